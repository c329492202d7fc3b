// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/collisions/groups.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "gas/flight/screens.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {

namespace {

constexpr std::size_t CELLS_A_CHUNK = 256;
constexpr std::size_t LONG_CELL = 4096;  ///< particles times facets
constexpr int WITNESSES =
    4;  ///< classes of a group that a newcomer tries to see; more: fewer, larger groups

/// Divides the particles of one cell. Keeps its memory from cell to cell.
class Divider {
public:
    void work_among(const FabricInCells& fabric, const Particles& particles, double reach) {
        fabric_ = &fabric;
        particles_ = &particles;
        reach_ = reach;
    }

    /// Orders `rows` by group, in place; true in begins[k] where a group begins. Returns their
    /// number.
    std::size_t divide(std::size_t cell, std::span<Index> rows, std::uint8_t* begins) {
        begins[0] = 1;
        if (rows.size() < 2 || !reaches_fabric(cell, rows) || !find_screens(cell, rows)) return 1;
        order_by_id(rows);
        find_classes();
        const std::size_t groups = join_classes();
        if (groups > 1) write(groups, rows, begins);
        return groups;
    }

private:
    struct Group {
        std::array<int, WITNESSES> witness;
        int witnesses = 0;
    };

    /// False when all particles are on one side of all that the cell holds.
    [[nodiscard]] bool reaches_fabric(std::size_t cell, std::span<const Index> rows) const {
        const Slab& slab = fabric_->lists->slab(cell);
        float low = std::numeric_limits<float>::max(), high = -low;
        for (const Index row : rows) {
            const float height = slab.height(fabric_->lists->small(particles_->x[row]));
            low = std::min(low, height);
            high = std::max(high, height);
        }
        return low <= slab.high && high >= slab.low;
    }

    /// Keeps the facets that have particles on both sides. False when there are none.
    bool find_screens(std::size_t cell, std::span<const Index> rows) {
        x_.resize(rows.size());
        Vec3 low = Vec3::Constant(INF), high = Vec3::Constant(-INF);
        for (std::size_t i = 0; i < x_.size(); ++i) {
            x_[i] = particles_->x[rows[i]];
            low = low.cwiseMin(x_[i]);
            high = high.cwiseMax(x_[i]);
        }
        screens_.begin(x_, reach_);
        for (const Index f : fabric_->lists->in(cell)) {
            if (!fabric_->is_open.empty() && fabric_->is_open[f] != 0) continue;
            const auto& [i, j, k] = fabric_->lists->triangles()[f];
            const Vec3 &a = fabric_->x[i], &b = fabric_->x[j], &c = fabric_->x[k];
            if ((a.cwiseMin(b).cwiseMin(c).array() > high.array()).any() ||
                (a.cwiseMax(b).cwiseMax(c).array() < low.array()).any())
                continue;
            screens_.add(a, b, c);
        }
        return !screens_.empty();
    }

    /// From here on particles are taken by id, so that nothing depends on the order of rows.
    void order_by_id(std::span<const Index> rows) {
        by_id_.clear();
        for (std::size_t i = 0; i < rows.size(); ++i)
            by_id_.emplace_back(particles_->id[rows[i]], static_cast<Index>(i));
        std::sort(by_id_.begin(), by_id_.end());
    }

    /// A class: particles strictly on the same side of every screen. Who touches a plane is alone.
    void find_classes() {
        class_.resize(by_id_.size());
        member_.clear();
        for (const auto& [id, i] : by_id_) {
            std::size_t found = screens_.touches(i) ? member_.size() : 0;
            while (found < member_.size() && !screens_.are_alike(i, member_[found])) ++found;
            if (found == member_.size()) member_.push_back(i);
            class_[i] = static_cast<int>(found);
        }
    }

    /// Joins classes that see each other; group_[class] in the order of their first particles.
    std::size_t join_classes() {
        groups_.clear();
        group_.assign(member_.size(), -1);
        for (int k = 0; k < static_cast<int>(member_.size()); ++k) {
            int home = -1;
            for (int g = 0; g < static_cast<int>(groups_.size()); ++g) {
                if (!sees(k, groups_[g])) continue;
                if (home < 0)
                    home = g;
                else
                    merge(g--, home);
            }
            if (home < 0) {
                home = static_cast<int>(groups_.size());
                groups_.emplace_back();
            }
            group_[k] = home;
            Group& group = groups_[home];
            if (group.witnesses < WITNESSES) group.witness[group.witnesses++] = k;
        }
        return groups_.size();
    }

    void merge(int from, int into) {
        Group& to = groups_[into];
        for (int w = 0; w < groups_[from].witnesses && to.witnesses < WITNESSES; ++w)
            to.witness[to.witnesses++] = groups_[from].witness[w];
        groups_.erase(groups_.begin() + from);
        for (int& g : group_) {
            if (g == from)
                g = into;
            else if (g > from)
                --g;
        }
    }

    [[nodiscard]] bool sees(int k, const Group& group) const {
        return std::any_of(
            group.witness.begin(), group.witness.begin() + group.witnesses,
            [&](int witness) { return screens_.is_free(member_[k], member_[witness]); });
    }

    /// Rows by group; within a group they keep their order.
    void write(std::size_t groups, std::span<Index> rows, std::uint8_t* begins) {
        next_.assign(groups + 1, 0);
        for (const int k : class_) ++next_[group_[k] + 1];
        for (std::size_t g = 0; g < groups; ++g) {
            begins[next_[g]] = 1;
            next_[g + 1] += next_[g];
        }
        old_.assign(rows.begin(), rows.end());
        for (std::size_t i = 0; i < old_.size(); ++i) rows[next_[group_[class_[i]]]++] = old_[i];
    }

    const FabricInCells* fabric_ = nullptr;
    const Particles* particles_ = nullptr;
    double reach_ = 0.0;

    std::vector<Vec3> x_;  ///< by row
    Screens screens_;
    std::vector<std::pair<int, Index>> by_id_;  ///< id, row
    std::vector<Index> member_, old_;           ///< the first of each class; rows as they were
    std::vector<int> class_, group_, next_;     ///< by row; by class; places of groups
    std::vector<Group> groups_;
};

}  // namespace

void Groups::find(CellSort& sorted, const FabricInCells& fabric, const Particles& particles,
                  double reach) {
    const Lists cells = sorted.cells();
    order_ = sorted.order();
    begins_.resize(order_.size());
    const auto size = [&](std::size_t c) {
        return static_cast<std::size_t>(cells.start[c + 1] - cells.start[c]);
    };
    with_fabric_.clear();
    found_.find(
        cells.size(), with_fabric_,
        [&](std::size_t c, auto&& take) {
            if (size(c) == 0) return;
            std::uint8_t* const begins = begins_.data() + cells.start[c];
            std::fill(begins, begins + size(c), 0);
            begins[0] = 1;
            if (size(c) > 1 && fabric.lists && !fabric.lists->is_empty(c))
                take({c, size(c) * fabric.lists->in(c).size()});
        },
        CELLS_A_CHUNK);
    // Those that may take long first: every particle is held against every facet
    const auto is_long = [](const FabricCell& cell) { return cell.work > LONG_CELL; };
    const auto end_of_long = std::partition(with_fabric_.begin(), with_fabric_.end(), is_long);
    std::sort(with_fabric_.begin(), end_of_long, [](const FabricCell& a, const FabricCell& b) {
        return std::pair(b.work, a.cell) < std::pair(a.work, b.cell);
    });
    const auto divided = [&](std::size_t i) {
        thread_local Divider divider;
        const std::size_t c = with_fabric_[i].cell;
        const auto begin = static_cast<std::size_t>(cells.start[c]);
        const auto rows = order_.subspan(begin, size(c));
        divider.work_among(fabric, particles, reach);
        return static_cast<std::size_t>(divider.divide(c, rows, begins_.data() + begin) > 1);
    };
    divided_cells_ = parallel::sum(with_fabric_.size(), std::size_t{0}, divided, 1);
    number_groups();
}

/// Starts of groups from the marks: counted by chunk, then written where each chunk's belong.
void Groups::number_groups() {
    const std::size_t n = order_.size();
    count_.assign(parallel::chunk_count(n) + 1, 0);
    parallel::for_chunks(n, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        count_[chunk + 1] = static_cast<std::size_t>(
            std::count(begins_.begin() + static_cast<std::ptrdiff_t>(begin),
                       begins_.begin() + static_cast<std::ptrdiff_t>(end), 1));
    });
    for (std::size_t c = 1; c < count_.size(); ++c) count_[c] += count_[c - 1];
    start_.resize(count_.back() + 1);
    parallel::for_chunks(n, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        std::size_t group = count_[chunk];
        for (std::size_t k = begin; k < end; ++k)
            if (begins_[k]) start_[group++] = static_cast<Index>(k);
    });
    start_[count_.back()] = static_cast<Index>(n);
}

}  // namespace corpuscle::gas
