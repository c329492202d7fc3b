// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

#include "contact/culling/patch_pairs.hpp"
#include "tests/support/geometry/shapes.hpp"
#include "tests/support/scenes/spring_cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

namespace {

constexpr double PAIR_REACH = 1.5e-3, PAIR_SPAN = 1e-5;  ///< [m], [s]

/// Least distance of two patches' nodes and triangles, edges and edges that share no node; INF when
/// it is above 2 PAIR_REACH.                                                                [m]
double least_distance(const Cloth& cloth, Index p, Index q, const Points& x) {
    double least = INF;
    const auto look = [&](const Pair& pair) {
        least = std::min(least, nearest(pair, corners(pair, x)).apart.norm());
    };
    for (const Index t : cloth.patches[p])
        for (const Index u : cloth.patches[q]) {
            const Triangle &a = cloth.triangles[t], &b = cloth.triangles[u];
            if (!triangle_box(a, x, x, PAIR_REACH).overlaps(triangle_box(b, x, x, PAIR_REACH)))
                continue;
            const auto is_of = [](Index n, const Triangle& of) {
                return n == of[0] || n == of[1] || n == of[2];
            };
            for (std::size_t k = 0; k < 3; ++k) {
                if (!is_of(a[k], b)) look({{a[k], b[0], b[1], b[2]}, false});
                if (!is_of(b[k], a)) look({{b[k], a[0], a[1], a[2]}, false});
                for (std::size_t m = 0; m < 3; ++m) {
                    const Index i = a[k], j = a[(k + 1) % 3], r = b[m], s = b[(m + 1) % 3];
                    if (i != r && i != s && j != r && j != s) look({{i, j, r, s}, true});
                }
            }
        }
    return least;
}

/// Cloth in waves and noise that move.
class Waves {
public:
    Waves(Points rest, double height, double noise, unsigned seed, double speed = 4e3)
        : rest_(std::move(rest)), height_(height), noise_(noise), speed_(speed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> one(-1.0, 1.0);
        const auto any = [&] {
            const double x = one(random), y = one(random);
            return Vec3(x, y, one(random));
        };
        for (std::size_t i = 0; i < rest_.size(); ++i) kick_.push_back(any());
        for (Vec3& w : wave_) w = any();
    }
    [[nodiscard]] Points at(double t) const {
        Points x = rest_;
        for (std::size_t i = 0; i < x.size(); ++i) {
            for (std::size_t k = 0; k < wave_.size(); ++k)
                x[i] +=
                    height_ * wave_[(k + 1) % wave_.size()] *
                    std::sin(40.0 * wave_[k].dot(rest_[i]) + speed_ * t + static_cast<double>(k));
            x[i] += noise_ * kick_[i] * std::sin(5.0 * speed_ * t + 1e3 * kick_[i].x());
        }
        return x;
    }

private:
    Points rest_, kick_;
    double height_, noise_, speed_;
    std::array<Vec3, 4> wave_;
};

}  // namespace

TEST_CASE("what is left out is out of reach, however cloth moves, until it does not hold",
          "[contact]") {
    const auto ball = shapes::sphere(0.08, 3);
    std::size_t left_out = 0, near = 0, finds = 0, steps = 0;
    for (const auto& sheet :
         {support::square_sheet(16, 0.16), support::Sheet{ball.x, ball.triangles},
          support::two_panels(12, 0.12, 0.0, true)}) {
        const Cloth cloth = support::cloth_of(sheet);
        for (unsigned state = 0; state < 8; ++state) {
            // from gentle waves to cloth that runs through itself
            const Waves motion(sheet.x, 2e-3 * (1 << state % 4), 1e-3 * (state % 3), state);
            PatchPairs patches(cloth,
                               std::vector<double>(cloth.triangles.size(), 0.5 * PAIR_REACH));
            patches.start(motion.at(0.0));
            for (int n = 0; n < 24; ++n, ++steps) {
                const Points x = motion.at(n * PAIR_SPAN), next = motion.at((n + 1) * PAIR_SPAN);
                const Points v = support::velocity_between(x, next, PAIR_SPAN);
                if (n > 0) patches.follow(x);
                patches.foresee(v, PAIR_SPAN);
                if (n == 0 || !patches.holds(x)) {
                    patches.find(x, 12.0);
                    ++finds;
                }
                if (n % 6 != 0) continue;
                const auto pairs = patches.pairs();
                for (std::size_t p = 0; p < cloth.patches.size(); ++p)
                    for (std::size_t q = p; q < cloth.patches.size(); ++q) {
                        const std::pair<Index, Index> both(p, q);
                        const double least =
                            std::min(least_distance(cloth, both.first, both.second, x),
                                     least_distance(cloth, both.first, both.second, next));
                        const bool is_in = std::binary_search(pairs.begin(), pairs.end(), both);
                        near += least < PAIR_REACH;
                        left_out += !is_in;
                        if (!is_in) CHECK(least >= PAIR_REACH);
                    }
            }
        }
    }
    CHECK(near > 300);
    CHECK(left_out > 200);
    CHECK(finds < steps);
}

TEST_CASE("cloth folded flat is searched across its fold", "[contact]") {
    const support::Sheet flat = support::square_sheet(16, 0.16);
    support::Sheet folded = flat;
    for (Vec3& x : folded.x)
        if (x.x() > 0.08 + 1e-9) x = Vec3(0.16 - x.x(), x.y(), 2e-3);
    support::SpringCloth spring(folded);
    ContactCard card;
    card.thickness = 1e-3;
    const Cloth cloth(spring.setup(card, flat.x));  // patches are those of the flat cloth
    PatchPairs patches(cloth, std::vector<double>(cloth.triangles.size(), 0.5 * PAIR_REACH));
    const Points at_rest(folded.x.size(), Vec3::Zero());
    for (const Points& x :
         {flat.x, folded.x}) {  // what was found before means nothing after a start
        patches.start(x);
        patches.foresee(at_rest, PAIR_SPAN);
        patches.find(x, 12.0);
    }
    std::size_t across = 0;
    for (std::size_t p = 0; p < cloth.patches.size(); ++p)
        for (std::size_t q = p + 1; q < cloth.patches.size(); ++q) {
            const std::pair<Index, Index> both(p, q);
            const auto half = [&](std::size_t patch) {
                double x = 0.0;
                for (const Index t : cloth.patches[patch]) x += flat.x[cloth.triangles[t][0]].x();
                return x / static_cast<double>(cloth.patches[patch].size()) > 0.08;
            };
            const double least = least_distance(cloth, both.first, both.second, folded.x);
            if (half(p) == half(q) || least > 3e-3) continue;
            ++across;
            CHECK(std::binary_search(patches.pairs().begin(), patches.pairs().end(), both));
        }
    CHECK(across > 3);
}
