// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

#include "io/deck_mesh.hpp"
#include "io/mesh/deck_writer.hpp"
#include "io/mesh/mesh_file.hpp"
#include "io/system/atomic_file.hpp"
#include "solver/base/error.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/mesh_inside.hpp"
#include "tools/commands/new_from_recipe.hpp"
#include "tools/fold/recipe/recipe.hpp"
#include "tools/new_deck.hpp"

namespace corpuscle::tools {
namespace {

namespace fs = std::filesystem;

constexpr double MILLIMETRES = 5.0;  ///< a bag that is longer is measured in mm, else in m

std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

double doubled_area(const Points& x, const std::array<Index, 4>& n) {
    const Vec3 first = (x[n[1]] - x[n[0]]).cross(x[n[2]] - x[n[0]]);
    const Vec3 second = (x[n[2]] - x[n[0]]).cross(x[n[3]] - x[n[0]]);
    return first.norm() + second.norm();
}

/// Vector area, twice; of closed facets 0.
Vec3 facing(const io::ImportedMesh& mesh) {
    Vec3 sum = Vec3::Zero();
    for (const auto& n : mesh.shells)
        sum += (mesh.x[n[2]] - mesh.x[n[0]]).cross(mesh.x[n[3]] - mesh.x[n[1]]);
    return sum;
}

/// A flat sheet becomes a bag: a second panel beside it, sewn to it at the rim.
///
/// The panels lie a fiftieth of the mean edge apart.
void sew_second_panel(io::ImportedMesh& mesh) {
    const Vec3 normal = facing(mesh).normalized();
    std::map<std::pair<Index, Index>, int> uses;
    double edges = 0.0, count = 0.0;
    for (const auto& n : mesh.shells)
        for (std::size_t k = 0; k < 4; ++k) {
            const Index a = n[k], b = n[(k + 1) % 4];
            if (a == b) continue;
            ++uses[std::minmax(a, b)];
            edges += (mesh.x[a] - mesh.x[b]).norm();
            count += 1.0;
        }
    std::vector<Index> twin(mesh.x.size(), -1);
    for (const auto& [edge, shells] : uses)
        if (shells == 1) {
            twin[edge.first] = edge.first;
            twin[edge.second] = edge.second;
        }
    const double gap = 0.02 * edges / count;
    const std::size_t nodes = mesh.x.size(), shells = mesh.shells.size();
    for (std::size_t n = 0; n < nodes; ++n) {
        if (twin[n] >= 0) continue;
        twin[n] = static_cast<Index>(mesh.x.size());
        mesh.x.push_back(mesh.x[n] - gap * normal);
    }
    const int part = static_cast<int>(mesh.part_names.size());
    mesh.part_names.emplace_back("second panel");
    for (std::size_t s = 0; s < shells; ++s) {
        const auto n = mesh.shells[s];
        const bool is_triangle = n[2] == n[3];
        mesh.shells.push_back(
            is_triangle ? std::array<Index, 4>{twin[n[0]], twin[n[2]], twin[n[1]], twin[n[1]]}
                        : std::array<Index, 4>{twin[n[0]], twin[n[3]], twin[n[2]], twin[n[1]]});
        mesh.part.push_back(part);
    }
}

/// Imports a mesh beside the deck; a flat sheet gets a second panel.
void import(const fs::path& from, const fs::path& to) {
    io::ImportedMesh mesh = io::read_mesh(from.string());
    io::MeshReport report = io::check_mesh(mesh);
    double all = 0.0;
    for (const auto& n : mesh.shells) all += doubled_area(mesh.x, n);
    const bool is_flat = std::abs(facing(mesh).norm() / all - 1.0) < 1e-3;
    if (!report.is_closed() && is_flat) {
        sew_second_panel(mesh);
        report = io::check_mesh(mesh);
        fmt::print("{}: a flat sheet; a second panel is sewn to its rim\n", from.string());
    }
    io::write_deck(to, mesh, from.filename().string());
    fmt::print("{}\n", io::text(report));
}

NewDeck bag_of(const fs::path& mesh_file, bool wants_head) {
    const io::DeckMesh mesh = io::read_deck_mesh(mesh_file);
    NewDeck bag;
    bag.mesh = mesh_file.filename().string();
    bag.facets = mesh.shells.size();
    Vec3 low = Vec3::Constant(INF), high = Vec3::Constant(-INF), centre = Vec3::Zero();
    for (std::size_t s = 0; s < mesh.shells.size(); ++s) {
        const auto& n = mesh.shells[s];
        const double area = 0.5 * doubled_area(mesh.x, n);
        bag.area += area;
        bag.volume += (mesh.x[n[0]].dot(mesh.x[n[1]].cross(mesh.x[n[2]])) +
                       mesh.x[n[0]].dot(mesh.x[n[2]].cross(mesh.x[n[3]]))) /
                      6.0;
        for (const Index node : n) {
            low = low.cwiseMin(mesh.x[node]);
            high = high.cwiseMax(mesh.x[node]);
            centre += 0.25 * area * mesh.x[node];
        }
        bag.parts.insert(mesh.part_id[s]);
    }
    if (!(bag.area > 0.0))
        throw InputError(fmt::format("{}: expected *ELEMENT_SHELL with area", mesh_file.string()));
    bag.volume = std::abs(bag.volume);
    bag.inflator = centre / bag.area;
    bag.is_mm = (high - low).maxCoeff() > MILLIMETRES;
    bag.top = high.z();
    bag.free_shell = *std::max_element(mesh.shell_id.begin(), mesh.shell_id.end()) + 1;
    bag.whole = mesh.last_part_set + 1;
    bag.closing = std::max(bag.closing, bag.whole + 1);
    bag.tethers = inner_part(mesh);
    bag.held_set = std::max(bag.held_set, mesh.last_node_set + 1);
    if (wants_head) bag.head = std::max({900, *bag.parts.rbegin() + 1, mesh.last_node_set + 1});
    bag.free_node = *std::max_element(mesh.node_id.begin(), mesh.node_id.end()) + 1;
    return bag;
}

/// Holds the cloth round the inflator of a bag that nothing else holds, and brings the inflator
/// close to it, where no cloth may come between; not where it is far from all cloth. Between the
/// layers of a folded bag it comes inside, and what lies flat with the nearest shell is held.
void hold_round_inflator(const io::DeckMesh& mesh, NewDeck& bag) {
    constexpr double RADIUS = 0.15, NEAR = 0.1;  ///< of a panel's side; of the way to the cloth
    const double radius = RADIUS * std::sqrt(0.5 * bag.area);
    double least = radius;
    std::size_t back = mesh.shells.size();
    for (std::size_t s = 0; s < mesh.shells.size(); ++s) {  // of two panels as near, the lower
        const Vec3 at = middle_of(mesh, s);
        const double away = (at - bag.inflator).norm();
        const bool is_lower =
            back < mesh.shells.size() && away < 1.001 * least && at.z() < middle_of(mesh, back).z();
        if (away >= 0.999 * least && !is_lower) continue;
        back = s;
        least = away;
    }
    if (back == mesh.shells.size()) return;
    const auto& n = mesh.shells[back];
    Vec3 towards = (mesh.x[n[2]] - mesh.x[n[0]]).cross(mesh.x[n[3]] - mesh.x[n[1]]).normalized();
    const double off = (middle_of(mesh, back) - bag.inflator).dot(towards);
    if (off < 0.0) towards = -towards;
    const Vec3 near = bag.inflator + (1.0 - NEAR) * std::abs(off) * towards;
    const auto over =
        is_inside(mesh, bag.tethers, near) ? std::nullopt : place_over(mesh, bag.tethers, back);
    const double gap = over ? 2.0 * (*over - middle_of(mesh, back)).norm() : 0.0;
    for (std::size_t k = 0; k < mesh.x.size(); ++k) {
        const Vec3 from = mesh.x[k] - bag.inflator, away = mesh.x[k] - middle_of(mesh, back);
        const bool is_held = over ? away.norm() < radius && std::abs(away.dot(towards)) < NEAR * gap
                                  : from.norm() < radius && from.dot(towards) > 0.5 * std::abs(off);
        if (is_held) bag.held.push_back(mesh.node_id[k]);
    }
    bag.inflator = over.value_or(near);
}

}  // namespace

int new_deck(const NewArguments& arguments) {
    const fs::path from = arguments.from;
    const fs::path deck =
        arguments.output.empty() ? from.stem().string() + ".new.k" : arguments.output;
    if (!fs::is_regular_file(from))
        throw InputError(fmt::format("--from {}: expected a file that can be read", from.string()));
    fs::path mesh = fs::path(deck).replace_extension("mesh.k");
    const fs::path study = fs::path(deck).replace_extension("study.toml");
    const bool is_recipe = from.extension() == ".toml";
    const bool is_deck = from.extension() == ".k" || from.extension() == ".key";
    std::vector<fs::path> inputs{from}, outputs{deck};
    if (is_recipe) inputs.push_back(fold::read_recipe(from).pattern.deck);
    if (!is_deck) outputs.push_back(mesh);
    if (arguments.head) outputs.push_back(study);
    for (const fs::path& output : outputs) expect_no_input(output, inputs);
    std::optional<RecipeBag> folded;
    if (is_recipe) {
        folded = bag_of_recipe(from, mesh);
    } else if (is_deck) {
        mesh = from;
    } else {
        import(from, mesh);
    }
    const std::string text = text_of(mesh);
    if (text.find("\n*SECTION_SHELL") != std::string::npos)
        throw InputError(
            fmt::format("{}: has *SECTION_SHELL, expected a mesh alone: nodes, shells "
                        "and parts",
                        mesh.string()));
    NewDeck bag = bag_of(mesh, arguments.head);
    if (folded)
        take_recipe(*folded, bag);
    else
        hold_round_inflator(io::read_deck_mesh(mesh), bag);
    bag.title = fmt::format("bag of {}", from.filename().string());
    if (mesh == from) bag.mesh = fs::relative(mesh, fs::absolute(deck).parent_path()).string();
    if (text.find("\n*PART\n") != std::string::npos) bag.numbered_parts = bag.parts;
    io::replace_text(deck, new_deck(bag));
    if (arguments.head) {
        io::replace_text(study, new_study(bag, deck.filename().string()));
        fmt::print("{}: the headform's speed as a study\n", study.string());
    }
    fmt::print(
        "{}: {} shells, {} parts; think about what is marked THINK, then\n"
        "  corpuscle check {}\n  corpuscle run {}\n",
        deck.string(), bag.facets, bag.parts.size(), deck.string(), deck.string());
    return 0;
}

}  // namespace corpuscle::tools
