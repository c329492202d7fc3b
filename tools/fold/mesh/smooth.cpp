// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "tools/fold/mesh/neighbours.hpp"

namespace corpuscle::fold {
namespace {

class Smoother {
public:
    Smoother(Sheet& sheet, const Freedom& freedom)
        : sheet_(sheet), freedom_(freedom), near_(sheet) {}

    void round(double wanted, double step) {
        for (std::size_t n = 0; n < sheet_.X.size(); ++n) {
            double best = least_reach(near_.cells[n], sheet_);
            if (best >= wanted || !may_move(sheet_.X[n], freedom_)) continue;
            const Vec3 from = sheet_.X[n];
            Vec3 to = from;
            for (const Vec3& way : ways(static_cast<Index>(n))) {
                sheet_.X[n] = from + step * way;
                settle(static_cast<Index>(n));
                if (const double r = least_reach(near_.cells[n], sheet_); r > best) {
                    best = r;
                    to = sheet_.X[n];
                }
            }
            sheet_.X[n] = to;
            sheet_.x[n] = to;
        }
    }

private:
    /// Directions in which a node may go.
    [[nodiscard]] std::vector<Vec3> ways(Index n) const {
        const std::vector<int>& on = sheet_.on[n];
        std::vector<Vec3> all;
        if (on.empty()) {
            for (int k = 0; k < 8; ++k)
                all.emplace_back(std::cos(0.25 * k * std::numbers::pi),
                                 std::sin(0.25 * k * std::numbers::pi), 0.0);
            return all;
        }
        if (on.front() < 0 && (on.size() > 1 || !freedom_.curves.contains(on.front()))) return all;
        for (const Index m : near_.nodes[n])
            if (is_within(on, sheet_.on[m]))
                all.push_back((sheet_.X[m] - sheet_.X[n]).normalized());
        return all;
    }

    void settle(Index n) {
        const std::vector<int>& on = sheet_.on[n];
        if (!on.empty() && on.front() < 0) freedom_.curves.at(on.front())(sheet_.X[n]);
    }

    Sheet& sheet_;
    const Freedom& freedom_;
    Neighbours near_;
};

}  // namespace

void smooth(Sheet& sheet, double wanted, int rounds, const Freedom& freedom) {
    Smoother smoother(sheet, freedom);
    for (int round = 0; round < rounds; ++round)
        for (const double share : {0.4, 0.2, 0.1, 0.05}) smoother.round(wanted, share * wanted);
}

}  // namespace corpuscle::fold
