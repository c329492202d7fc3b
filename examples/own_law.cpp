// A material law of one's own: cloth that stiffens exponentially, w = k/2 (exp(E:D:E/k) - 1) of
// Fung's kind. One element is pulled along its warp; its pull is exact.
#include <corpuscle/fabric/membranes.hpp>

#include <cmath>
#include <cstdio>

using namespace corpuscle;
using namespace corpuscle::fabric;

class Fung final : public OwnLaw {
public:
    PlaneModuli moduli() const override { return {WARP, 0.0, WEFT, SHEAR}; }

    Stress<double> stress(const Strain<double>& e) const override {
        const double grown = growth(e);
        return {grown * WARP * e.warp, grown * WEFT * e.weft, grown * SHEAR * e.shear,
                0.5 * K * (grown - 1.0)};
    }
    double stiffening(const Strain<double>& e) const override {  // of dS/dE, and what the load adds
        const double Q = std::log(growth(e));
        return growth(e) * (1.0 + 2.0 * Q) * OwnLaw::stiffening(e);
    }

private:
    static constexpr double WARP = 300e6, WEFT = 250e6, SHEAR = 5e6, K = 10e6;  // [Pa]
    static double growth(const Strain<double>& e) {
        return std::exp(
            (WARP * e.warp * e.warp + WEFT * e.weft * e.weft + SHEAR * e.shear * e.shear) / K);
    }
};

int main() {
    constexpr double THICKNESS = 0.3e-3, SIDE = 0.01;  // [m]
    const Points x{{0, 0, 0}, {SIDE, 0, 0}, {SIDE, SIDE, 0}, {0, SIDE, 0}};
    const Shell shell{1, 0, {0, 1, 2, 3}};
    const Part part{.id = 1, .material = 0, .thickness = THICKNESS};
    const Material cloth{1, "stiffening cloth",
                         OwnCard{.density = 750, .law = std::make_shared<Fung>()}};
    const std::array<Vec3, 4> reference{x[0], x[1], x[2], x[3]};
    const std::uint8_t active = 1;
    Membranes membranes(
        {{&shell, 1}, {&part, 1}, {&cloth, 1}, {&reference, 1}, {&active, 1}, x.size()});

    for (const double stretch : {1.0, 1.05, 1.10, 1.15}) {
        Points now = x, f(x.size(), Vec3::Zero());
        const Points at_rest = f;
        for (Vec3& p : now) p.x() *= stretch;
        if (membranes.add_force(now, at_rest, f) >= 0) return 3;
        const double E = 0.5 * (stretch * stretch - 1.0);
        const double exact = stretch * Fung().stress({E, 0.0, 0.0}).warp * THICKNESS * SIDE;
        std::printf("stretch %.2f, pull %.3f N, exact %.3f N, step %.3f us\n", stretch,
                    -(f[1].x() + f[2].x()), exact, 1e6 * membranes.stable_step().dt);
    }
}
