// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "contact/intersections.hpp"
#include "contact/orientation.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::contact {
namespace {

constexpr std::size_t CHUNK = 8;  ///< patch pairs; some thousand triangle pairs

constexpr double STEPS = 100.0;  ///< greatest life of the lists
constexpr double SWEEP = 0.5;    ///< farthest that a patch may sweep in that time, in edge lengths
constexpr double STRAY =
    0.3;  ///< part of its way that a patch may well stray from what is predicted
constexpr double LEAST =
    0.5;  ///< smallest budget, in contact thicknesses: cloth at rest will soon move

/// The largest budget grows while lists are short and shrinks while they are long, between these
/// numbers of candidates a triangle: in open cloth a wide list costs nothing, in folded cloth every
/// thickness adds a layer.
constexpr std::size_t FEW = 2, MANY = 12;
constexpr double ADAPTATION = 1.3;
constexpr double LIVES = 3.0;  ///< steps like the last one that any lists serve

std::uint64_t key_of(bool is_edges, Index first, Index second) {
    return static_cast<std::uint64_t>(is_edges) << 63 | static_cast<std::uint64_t>(first) << 32 |
           static_cast<std::uint64_t>(second);
}

bool has_node(const Triangle& t, Index node) {
    return t[0] == node || t[1] == node || t[2] == node;
}

Vec3 foot_to_point(const Candidate& pair, const Points& x) {
    const auto& n = pair.node;
    if (pair.is_edges) {
        const auto [region, s, t] = feet_of_edges(x[n[0]], x[n[1]], x[n[2]], x[n[3]]);
        return x[n[0]] + s * (x[n[1]] - x[n[0]]) - x[n[2]] - t * (x[n[3]] - x[n[2]]);
    }
    const Vec3 w = foot_on_triangle(x[n[0]], x[n[1]], x[n[2]], x[n[3]]).weights;
    return x[n[0]] - w[0] * x[n[1]] - w[1] * x[n[2]] - w[2] * x[n[3]];
}

}  // namespace

double distance(const Candidate& pair, const Points& x) {
    return foot_to_point(pair, x).norm();
}

Candidates::Candidates(const Cloth& cloth, double reach)
    : cloth_(cloth),
      reach_(reach),
      motion_(cloth),
      near_triangles_(cloth.patches),
      boxes_(cloth.triangles.size()),
      budget_(cloth.patches.size()),
      most_budget_(4.0 * cloth.greatest_thickness),
      growth_(cloth.patches.size()) {}

void Candidates::start(const Points& x, const Points& v, double t, double dt) {
    motion_.start(x, v, t, dt);
    crossing_ = crossings(cloth_.triangles, cloth_.patches, x);
    bar_crossing_pairs();
    build(x, t);
    for (Candidate& pair : list_) {
        pair.memory.short_by = std::max(0.0, pair.thickness - distance(pair, x));
        pair.memory.born = t;
    }
}

void Candidates::follow(const Points& x, double t) {
    motion_.follow(x, t);
    if (are_spent()) build(x, t);
}

/// Whether the lists might miss a pair at the end of the step ahead.
bool Candidates::are_spent() const {
    if (motion_.age() + GROWTH * motion_.time_step() > life_) return true;
    for (std::size_t p = 0; p < budget_.size(); ++p) {
        const auto patch = static_cast<Index>(p);
        if (motion_.stray(patch) + GROWTH * motion_.stray_step(patch) > budget_[p]) return true;
    }
    return false;
}

void Candidates::build(const Points& x, double t) {
    ++builds_;
    std::vector<Candidate> old;
    std::copy_if(list_.begin(), list_.end(), std::back_inserter(old), [](const Candidate& pair) {
        const PairMemory& m = pair.memory;
        return m.side != 0 || m.short_by > 0.0 || m.account != 0.0 || !m.normal.isZero();
    });

    std::vector<std::uint64_t> were_barred;
    const auto uncrossed = std::erase_if(crossing_, [&](const auto& pair) {
        return !triangles_cross(cloth_.triangles[pair.first], cloth_.triangles[pair.second], x);
    });
    if (uncrossed > 0) {
        were_barred = barred_;
        bar_crossing_pairs();
    }

    set_budgets();
    for (std::size_t i = 0; i < boxes_.size(); ++i)
        boxes_[i] = grown(triangle_box(cloth_.triangles[i], x, x, 0.0), cloth_.patch_of[i]);
    near_triangles_.update(boxes_);
    list_pairs(x);
    remember(std::move(old));
    give_gentle_gaps(were_barred, x, t);
}

/// Sweeps and budgets for the time ahead; a fast patch may stray farther than a slow one.
void Candidates::set_budgets() {
    motion_.restart();
    const double h = cloth_.greatest_thickness;
    if (list_.size() < FEW * cloth_.triangles.size())
        most_budget_ *= ADAPTATION;
    else if (list_.size() > MANY * cloth_.triangles.size())
        most_budget_ /= ADAPTATION;
    most_budget_ = std::clamp(most_budget_, 2.0 * LEAST * h,
                              std::max(2.0 * LEAST * h, 0.2 * cloth_.mean_edge));

    double fastest = 0.0;
    for (std::size_t p = 0; p < budget_.size(); ++p)
        fastest = std::max(fastest, motion_.velocity(static_cast<Index>(p)).norm());
    life_ = STEPS * motion_.time_step();
    if (fastest * life_ > SWEEP * cloth_.mean_edge) life_ = SWEEP * cloth_.mean_edge / fastest;
    life_ = std::max(life_, LIVES * motion_.time_step());

    for (std::size_t p = 0; p < budget_.size(); ++p) {
        const auto patch = static_cast<Index>(p);
        budget_[p] = std::max(most_budget_, LIVES * motion_.stray_step(patch));
        // two boxes overlap where a gap may come within reach
        const Vec3 sweep = life_ * motion_.velocity(patch);
        const Vec3 margin = Vec3::Constant(0.5 * reach_ * h + budget_[p]);
        growth_[p] = {sweep.cwiseMin(0.0) - margin, sweep.cwiseMax(0.0) + margin};
    }
}

void Candidates::list_pairs(const Points& x) {
    const auto pairs = near_triangles_.patch_pairs();
    const std::size_t chunks = parallel::chunk_count(pairs.size(), CHUNK);
    chunk_list_.resize(std::max(chunk_list_.size(), chunks));
    chunk_watch_.resize(chunk_list_.size());
    const auto search = [&](std::size_t begin, std::size_t end, std::size_t c) {
        chunk_list_[c].clear();
        chunk_watch_[c].clear();
        for (std::size_t i = begin; i < end; ++i)
            near_triangles_.for_each_in(pairs[i], [&](Index a, Index b) {
                list_pairs_of(a, b, x, chunk_list_[c], chunk_watch_[c]);
            });
    };
    parallel::for_chunks(pairs.size(), search, CHUNK);

    list_.clear();
    watch_.clear();
    for (std::size_t c = 0; c < chunks; ++c) {
        list_.insert(list_.end(), chunk_list_[c].begin(), chunk_list_[c].end());
        watch_.insert(watch_.end(), chunk_watch_[c].begin(), chunk_watch_[c].end());
    }
}

/// Nodes of a against b, of b against a, edges of a against edges of b, as far as they own them.
void Candidates::list_pairs_of(Index a, Index b, const Points& x, std::vector<Candidate>& list,
                               std::vector<Watch>& watch) const {
    const Triangle& ta = cloth_.triangles[a];
    const Triangle& tb = cloth_.triangles[b];
    const double h = 0.5 * (cloth_.thickness[a] + cloth_.thickness[b]);
    const Index patch_a = cloth_.patch_of[a], patch_b = cloth_.patch_of[b];
    const auto node_against = [&](Index node, Index patch, Index t) {
        const Triangle& n = cloth_.triangles[t];
        if (has_node(n, node) || !grown({x[node], x[node]}, patch).overlaps(boxes_[t])) return;
        consider({{node, n[0], n[1], n[2]}, false, h, key_of(false, node, t), {}}, a, b, x, list,
                 watch);
    };
    for (int k = 0; k < 3; ++k) {
        if (cloth_.owns_node(a, k)) node_against(ta[k], patch_a, b);
        if (cloth_.owns_node(b, k)) node_against(tb[k], patch_b, a);
        if (!cloth_.owns_edge(a, k)) continue;
        const Index i = ta[k], j = ta[(k + 1) % 3];
        const Box edge = grown({x[i].cwiseMin(x[j]), x[i].cwiseMax(x[j])}, patch_a);
        for (int m = 0; m < 3; ++m) {
            const Index p = tb[m], q = tb[(m + 1) % 3];
            if (!cloth_.owns_edge(b, m) || i == p || i == q || j == p || j == q) continue;
            if (!edge.overlaps(grown({x[p].cwiseMin(x[q]), x[p].cwiseMax(x[q])}, patch_b)))
                continue;
            consider(
                {{i, j, p, q}, true, h, key_of(true, cloth_.edge[a][k], cloth_.edge[b][m]), {}}, a,
                b, x, list, watch);
        }
    }
}

/// Keeps a pair that may come within reach while the lists live.
void Candidates::consider(Candidate pair, Index a, Index b, const Points& x,
                          std::vector<Candidate>& list, std::vector<Watch>& watch) const {
    double mobility = 0.0;
    for (const Index node : pair.node) mobility += cloth_.inverse_mass[node];
    if (mobility == 0.0) return;  // held against held

    const Index p = cloth_.patch_of[a], q = cloth_.patch_of[b];
    const double gap = distance(pair, x);
    const double approach = life_ * (motion_.velocity(p) - motion_.velocity(q)).norm();
    if (gap > reach_ * pair.thickness + budget_[p] + budget_[q] + approach || is_barred(pair.key))
        return;
    pair.thickness = std::min(pair.thickness, neighbours_thickness(pair));
    list.push_back(pair);
    watch.push_back({gap - reach_ * pair.thickness, p, q});
}

/// Neighbours on the cloth are as near as the mesh is fine: they push below half that distance
/// only.
double Candidates::neighbours_thickness(const Candidate& pair) const {
    const auto& n = pair.node;
    const auto are_beside = [&](int i, int j) { return cloth_.are_beside(n[i], n[j]); };
    const bool is_neighbour =
        pair.is_edges ? are_beside(0, 2) || are_beside(0, 3) || are_beside(1, 2) || are_beside(1, 3)
                      : are_beside(0, 1) || are_beside(0, 2) || are_beside(0, 3);
    if (!is_neighbour) return INF;
    return 0.5 * std::max(distance(pair, cloth_.reference_x), distance(pair, cloth_.x0));
}

bool Candidates::is_barred(std::uint64_t key) const {
    return std::binary_search(barred_.begin(), barred_.end(), key);
}

void Candidates::bar_crossing_pairs() {
    barred_.clear();
    for (const auto& [a, b] : crossing_)
        for (int k = 0; k < 3; ++k) {
            barred_.push_back(key_of(false, cloth_.triangles[a][k], b));
            barred_.push_back(key_of(false, cloth_.triangles[b][k], a));
            for (int m = 0; m < 3; ++m) {
                barred_.push_back(key_of(true, cloth_.edge[a][k], cloth_.edge[b][m]));
                barred_.push_back(key_of(true, cloth_.edge[b][m], cloth_.edge[a][k]));
            }
        }
    std::sort(barred_.begin(), barred_.end());
}

/// Pairs of triangles that have just come apart start with the gap that they have.
void Candidates::give_gentle_gaps(const std::vector<std::uint64_t>& keys, const Points& x,
                                  double t) {
    if (keys.empty()) return;
    for (Candidate& pair : list_) {
        if (!std::binary_search(keys.begin(), keys.end(), pair.key)) continue;
        pair.memory.short_by = std::max(0.0, pair.thickness - distance(pair, x));
        pair.memory.born = t;
    }
}

void Candidates::remember(std::vector<Candidate> old) {
    const auto by_key = [](const Candidate& a, const Candidate& b) { return a.key < b.key; };
    std::sort(old.begin(), old.end(), by_key);
    for (std::size_t i = 0; i < list_.size(); ++i) {
        const auto known = std::lower_bound(old.begin(), old.end(), list_[i], by_key);
        if (known == old.end() || known->key != list_[i].key) continue;
        list_[i].memory = known->memory;
        watch_[i].due = -INF;  // what is remembered is kept up to date
    }
}

}  // namespace corpuscle::contact
