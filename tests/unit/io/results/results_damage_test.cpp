// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: results and checkpoints that were damaged on the disk give what was written or an error,
// never other numbers, and cost no more memory than the whole file.

#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <map>

#include "io/results/checkpoint.hpp"
#include "io/results/hdf5.hpp"
#include "io/results/results_file.hpp"
#include "solver/base/error.hpp"
#include "solver/base/random.hpp"
#include "tests/unit/io/results/results_scene.hpp"

using namespace corpuscle;
using io::Hdf5Reader;

namespace {

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

/// Results of a few rows and frames, in one file.
std::string whole_results(const std::filesystem::path& folder) {
    const RecordLayout layout = scene::layout();
    io::ResultsFile results(folder, scene::info(), layout);
    for (std::size_t row = 0; row < 5; ++row) results.append(scene::sample(layout, row));
    for (std::size_t n = 0; n < 2; ++n) results.write(scene::frame(layout, n, 20));
    results.finish("normal");
    return bytes_of(folder / "results.h5");
}

using Content = std::map<std::string, std::vector<double>>;

/// All numbers under a group, by path.
void collect(const Hdf5Reader& file, const std::string& group, Content& all) {
    for (const std::string& name : file.names(group.empty() ? "/" : group)) {
        const std::string path = group + "/" + name;
        if (file.is_group(path))
            collect(file, path, all);
        else
            all[path] = file.read<double>(path);
    }
}

Content content_of(const std::filesystem::path& file) {
    Content all;
    collect(Hdf5Reader(file), "", all);
    return all;
}

long peak_memory() {  // [KiB]
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

}  // namespace

TEST_CASE("a bit that was turned over in results is found, or was in nobody's number", "[io]") {
    const scene::Folder folder("damage");
    const std::string whole = whole_results(folder.path);
    const Content before = content_of(folder.path / "results.h5");
    REQUIRE(before.size() > 50);
    const auto file = folder.path / "damaged.h5";
    const long memory = peak_memory();
    constexpr int FLIPS = 400;
    int found = 0;
    for (int i = 0; i < FLIPS; ++i) {
        Random draw(2007, Stream::INITIAL, 0, static_cast<std::uint64_t>(i));
        std::string damaged = whole;
        const auto at = draw.below(static_cast<std::uint32_t>(whole.size()));
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << draw.below(8)));
        write_bytes(file, damaged);
        CAPTURE(i, at);
        try {
            const Content now = content_of(file);
            REQUIRE(now == before);
        } catch (const SystemError&) {
            ++found;
        }
    }
    CHECK(found > FLIPS / 2);
    CHECK(peak_memory() - memory < 200000);
}

TEST_CASE("results whose texts lie where no text is are an error, not a crash", "[io]") {
    const scene::Folder folder("texts");
    const std::string whole = whole_results(folder.path);
    const auto file = folder.path / "damaged.h5";
    const std::size_t heap =
        whole.find("GCOL");  // HDF5's global heap: the only one without checksum
    REQUIRE(heap != std::string::npos);
    int found = 0;
    for (std::size_t at = heap; at < heap + 400; at += 4) {
        std::string damaged = whole;
        for (const std::size_t i : {0, 1, 2, 3}) damaged[at + i] = '\xf0';
        write_bytes(file, damaged);
        CAPTURE(at - heap);
        try {
            const Hdf5Reader results(file);
            for (const std::string& name : results.attributes("/")) try {
                    static_cast<void>(results.text("/", name));
                } catch (const SystemError&) {
                }
        } catch (const SystemError&) {
            ++found;
        }
    }
    CHECK(found > 0);
}

TEST_CASE("results that were cut off anywhere do not open", "[io]") {
    const scene::Folder folder("cut");
    const std::string whole = whole_results(folder.path);
    const auto file = folder.path / "damaged.h5";
    for (int i = 0; i < 60; ++i) {
        write_bytes(file, whole.substr(0, whole.size() * i / 60));
        CAPTURE(i);
        CHECK_THROWS_AS(content_of(file), SystemError);
    }
}

TEST_CASE("any bit of a checkpoint that was turned over is found", "[io]") {
    const scene::Folder folder("checkpoint_damage");
    std::filesystem::create_directories(folder.path);
    io::Checkpoint checkpoint{0x123456789abcdefULL, 1.5, 77, {}};
    for (int i = 0; i < 100; ++i) checkpoint.state.push_back(static_cast<char>(7 * i));
    io::write_checkpoint(folder.path, checkpoint);
    const auto again = io::read_checkpoint(folder.path);
    REQUIRE(again);
    CHECK(again->state == checkpoint.state);
    CHECK(again->scene == checkpoint.scene);
    const std::string whole = bytes_of(folder.path / "checkpoint");
    for (std::size_t at = 0; at < whole.size(); ++at)
        for (int bit = 0; bit < 8; ++bit) {
            std::string damaged = whole;
            damaged[at] = static_cast<char>(damaged[at] ^ (1 << bit));
            write_bytes(folder.path / "checkpoint", damaged);
            CAPTURE(at, bit);
            REQUIRE_THROWS_AS(io::read_checkpoint(folder.path), SystemError);
        }
    for (std::size_t size = 1; size < whole.size(); ++size) {
        write_bytes(folder.path / "checkpoint", whole.substr(0, size));
        CAPTURE(size);
        REQUIRE_THROWS_AS(io::read_checkpoint(folder.path), SystemError);
    }
}
