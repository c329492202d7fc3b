// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/fuzz/targets.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "io/deck.hpp"
#include "io/mesh/mesh_file.hpp"
#include "io/results/checkpoint.hpp"
#include "io/results/hdf5.hpp"
#include "io/results/results_file.hpp"
#include "solver/simulation.hpp"
#include "tests/support/random/random_recipe.hpp"
#include "tests/unit/io/results/results_scene.hpp"
#include "tools/fold/fold.hpp"
#include "tools/study/study.hpp"

namespace corpuscle::fuzz {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& file) {
    std::ostringstream bytes;
    bytes << std::ifstream(file, std::ios::binary).rdbuf();
    return bytes.str();
}

std::vector<std::string> texts_in(const fs::path& folder, const std::string& suffix) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == suffix) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<std::string> texts;
    for (const fs::path& file : files) texts.push_back(bytes_of(file));
    return texts;
}

/// Reads a deck, and runs what is small for some steps.
void run_deck(const fs::path& file) {
    constexpr std::size_t SMALL = 3000;
    constexpr int STEPS = 3;
    Model model = io::read_deck(file);
    std::size_t size = model.x.size() + model.shells.size();
    for (const gas::BagCard& bag : model.bags) size += bag.particles;
    if (size > SMALL) return;
    Simulation simulation(std::move(model), 1);
    for (int k = 0; k < STEPS && !simulation.is_over(); ++k)
        simulation.step([](Simulation& now) { static_cast<void>(now.sample()); });
    static_cast<void>(simulation.frame());
}

/// Reads a recipe, and folds what has few elements.
void fold_recipe(const fs::path& file) {
    constexpr double SMALL = 2000.0;
    const fold::Recipe recipe = fold::read_recipe(file);
    const fold::Pattern& p = recipe.pattern;
    const double area =
        p.kind == fold::PatternKind::DISC ? p.diameter * p.diameter : p.length * p.width;
    if (area < SMALL * p.element * p.element) static_cast<void>(fold::fold(recipe));
}

/// Recipes as users might write them, coarse.
std::vector<std::string> some_recipes() {
    std::vector<std::string> texts;
    for (unsigned seed = 1; seed <= 12; ++seed)
        texts.push_back(seed % 3 == 0 ? support::random_tuck_recipe(seed)
                                      : support::random_recipe(seed, seed % 3 == 1));
    return texts;
}

void read_all(const io::Hdf5Reader& file, const std::string& group) {
    for (const std::string& name : file.names(group.empty() ? "/" : group)) {
        const std::string path = group + "/" + name;
        if (file.is_group(path))
            read_all(file, path);
        else
            static_cast<void>(file.read<double>(path));
    }
}

void read_results(const fs::path& file) {
    const io::Hdf5Reader results(file);
    for (const char* name : {"program", "deck", "unit_system", "termination"})
        static_cast<void>(results.text("/", name));
    read_all(results, "");
}

std::string small_results(const fs::path& work) {
    const RecordLayout layout = scene::layout();
    io::ResultsFile results(work / "seed", scene::info(), layout);
    for (std::size_t row = 0; row < 3; ++row) results.append(scene::sample(layout, row));
    results.write(scene::frame(layout, 0, 10));
    results.finish("normal");
    return bytes_of(work / "seed/results.h5");
}

std::string small_checkpoint(const fs::path& work) {
    io::write_checkpoint(work, {7, 0.5, 9, std::vector<char>(300, 'x')});
    return bytes_of(work / "checkpoint");
}

constexpr const char* STUDY =
    "deck = \"deck.k\"\nplan = \"latin\"\nsamples = 6\nworkers = 2\nuntil = 3.0\n"
    "repeats = 2\nresponses = [\n    \"100.hic15\", \"max:/history/airbag/1/pressure\",\n]\n"
    "[fixed]\nNP = 20000\n[factors]\nDISTANCE = [280, 340]\nSPEED = [6, 8]\n";
constexpr const char* PLY =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
constexpr const char* OBJ =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng a\nf 1 3 2\nf 1 2 4\ng b\nf 1 4 3\nf 2 3 4\n";
constexpr const char* STL =
    "solid t\nfacet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\n"
    "endfacet\nfacet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\n"
    "endfacet\nendsolid t\n";

}  // namespace

std::vector<Target> all_targets(const fs::path& models, const fs::path& decks,
                                const fs::path& work) {
    const auto mesh = [](const fs::path& file) { static_cast<void>(io::read_mesh(file)); };
    const auto study = [](const fs::path& file) {
        static_cast<void>(points(study::read_study(file)));
    };
    for (const fs::directory_entry& entry : fs::directory_iterator(decks))
        if (entry.path().extension() == ".inc")
            fs::copy_file(entry.path(), work / entry.path().filename());
    fs::copy_file(decks / "cloth.inc", work / "deck.k");
    std::vector<std::string> recipes = texts_in(models / "recipes", ".toml");
    for (std::string& recipe : some_recipes()) recipes.push_back(std::move(recipe));
    return {{"deck", "case.k", true, texts_in(decks, ".k"), run_deck},
            {"recipe", "case.toml", true, std::move(recipes), fold_recipe},
            {"study", "case.toml", true, {STUDY}, study},
            {"ply", "case.ply", true, {PLY}, mesh},
            {"obj", "case.obj", true, {OBJ}, mesh},
            {"stl", "case.stl", true, {STL}, mesh},
            {"results", "case.h5", false, {small_results(work)}, read_results},
            {"checkpoint", "checkpoint", false, {small_checkpoint(work)}, [](const fs::path& file) {
                 static_cast<void>(io::read_checkpoint(file.parent_path()));
             }}};
}

}  // namespace corpuscle::fuzz
