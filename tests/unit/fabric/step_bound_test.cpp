// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <Eigen/Eigenvalues>

#include <random>

#include "fabric/elements/quad_one_point.hpp"
#include "fabric/elements/triangle.hpp"
#include "fabric/materials/orthotropic_tension_field.hpp"
#include "sheet.hpp"

using namespace corpuscle;
using namespace corpuscle::fabric;
using namespace corpuscle::fabric::test;

namespace {

/// Numbers of a seed.
class Draw {
public:
    explicit Draw(unsigned seed) : random_(seed) {}
    double operator()(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }

private:
    std::mt19937 random_;
};

/// Highest frequency squared of an element that moves in space, stress and all, by its own kernel.
template <class Element>
double exact_frequency(const Element& element, const typename Element::Motion& motion,
                       const typename Element::Load& load, const PlaneModuli& moduli,
                       const std::array<double, Element::CORNERS>& per_mass) {
    constexpr int SIZE = 3 * Element::CORNERS;
    Eigen::Matrix<double, SIZE, SIZE> k;
    for (int j = 0; j < SIZE; ++j) {
        typename Element::Corners u{};
        Vector<double>& at = u[static_cast<std::size_t>(j / 3)];
        (j % 3 == 0 ? at.x : j % 3 == 1 ? at.y : at.z) = 1.0;
        const auto rate = element.motion(u);
        const auto stretched = element.spread(motion, element.viscous(moduli, motion, rate), 1.0);
        const auto turned = element.spread(rate, load, 1.0);
        for (int i = 0; i < Element::CORNERS; ++i) {
            const auto c = static_cast<std::size_t>(i);
            const double root = std::sqrt(per_mass[c] * per_mass[static_cast<std::size_t>(j / 3)]);
            k(3 * i, j) = -root * (stretched[c].x + turned[c].x);
            k(3 * i + 1, j) = -root * (stretched[c].y + turned[c].y);
            k(3 * i + 2, j) = -root * (stretched[c].z + turned[c].z);
        }
    }
    CHECK((k - k.transpose()).norm() < 1e-9 * k.norm());
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k, Eigen::EigenvaluesOnly)
        .eigenvalues()
        .maxCoeff();
}

/// Bound over exact value, root, of a drawn shape, drawn masses, and places that are stretched,
/// sheared by up to 45 degrees, bent and turned.
template <class Element, class Make>
double share_of_bound(unsigned seed, const Make& make) {
    Draw draw(seed);
    constexpr std::size_t CORNERS = Element::CORNERS;
    const FabricCard card = fabric_card();
    Shell shell{1, 0, {0, 1, 2, CORNERS == 3 ? 2 : 3}};
    std::array<Vec3, 4> x{Vec3(0, 0, 0), Vec3(5e-3, 0, 0), Vec3(5e-3, 5e-3, 0), Vec3(0, 5e-3, 0)};
    for (Vec3& at : x) at += 1e-3 * Vec3(draw(-1, 1), draw(-1, 1), draw(-0.5, 0.5));
    if (CORNERS == 3) x[3] = x[2];
    std::string fault;
    const ReferenceShape shape = lay_flat(shell, x, card, fault);
    REQUIRE(fault.empty());
    const Element element = make(shape, 0.3e-3);
    const OrthotropicTensionField law(card.E_warp, card.E_weft, card.nu_ba, draw(0.5e6, 30e6));

    std::array<double, CORNERS> per_mass;
    for (double& m : per_mass) m = 1.0 / (1e-6 * draw(0.3, 3.0));
    const Vec3 along(draw(0.7, 1.15), draw(-0.7, 0.7), draw(-0.2, 0.2));
    const Vec3 across(draw(-0.3, 0.3), draw(0.7, 1.15), draw(-0.2, 0.2));
    typename Element::Corners now;
    for (std::size_t c = 0; c < CORNERS; ++c) {
        const Vec3 at = shape.x[c].x() * along + shape.x[c].y() * across +
                        1e-3 * Vec3(draw(-0.3, 0.3), draw(-0.3, 0.3), draw(-1, 1));
        now[c] = {at.x(), at.y(), at.z()};
    }
    const auto motion = element.motion(now);
    double energy = 0.0;
    const auto load = element.elastic(law, motion, element.strain(motion), energy);
    const double exact = exact_frequency(element, motion, load, law.moduli(), per_mass);
    const double bound =
        element.frequency_bound(law.moduli(), motion, load, corner_mobility(element, per_mass));
    CAPTURE(seed, bound, exact);
    CHECK(bound >= exact * (1 - 1e-9));
    return std::sqrt(bound / exact);
}

template <class Element, class Make>
void check_bound(const char* what, const Make& make) {
    constexpr unsigned DRAWS = 2000;
    double sum = 0.0, most = 0.0;
    for (unsigned seed = 1; seed <= DRAWS; ++seed) {
        const double share = share_of_bound<Element>(seed, make);
        sum += share / DRAWS;
        most = std::max(most, share);
    }
    fmt::print("{}: bound of the highest frequency over the exact one {:.4f}, at most {:.3f}\n",
               what, sum, most);
    CHECK(sum < 1.04);
    CHECK(most < 1.25);
}

}  // namespace

TEST_CASE("no strained element vibrates faster than its bound, and hardly slower",
          "[fabric][step]") {
    check_bound<Triangle<double>>("triangles", make_triangle);
    check_bound<QuadOnePoint<double>>("quads", make_quad_one_point);
}

TEST_CASE("the greatest root is bounded from above, to 1e-3", "[fabric][step]") {
    Draw draw(3);
    for (int i = 0; i < 10000; ++i) {
        const double u = draw(0, 1), v = i % 3 == 0 ? u : draw(0, 1),
                     w = i % 9 == 0 ? u : draw(0, 1);
        const double most = std::max({u, v, w});
        const double found = greatest_root(u + v + w, u * v + v * w + w * u, u * v * w);
        CAPTURE(u, v, w);
        CHECK(found >= most * (1 - 1e-6));
        CHECK(found <= most * 1.001);
    }
}
