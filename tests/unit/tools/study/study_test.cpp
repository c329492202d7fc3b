// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "solver/base/error.hpp"
#include "solver/base/parallel.hpp"
#include "solver/base/vec.hpp"
#include "tests/unit/tools/study/desk.hpp"
#include "tools/study/known_names.hpp"
#include "tools/study/outcome.hpp"
#include "tools/study/slurm.hpp"
#include "tools/study/table.hpp"
#include "tools/study/workers.hpp"

using namespace corpuscle;
using study_test::Desk;
namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& file) {
    std::ifstream in(file);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

const std::string HEAD = "deck = \"bag.k\"\nresponses = [\"20.peak_force\"]\n";

}  // namespace

TEST_CASE("a full plan meets every combination once, in order", "[study]") {
    const Desk desk("full");
    const study::Study s = desk.study(HEAD +
                                      "repeats = 2\nfirst_seed = 5\n[factors]\nSPEED = [2, 4]\n"
                                      "ANGLE = {from = 0, to = 30, count = 4}\n");
    const auto points = study::points(s);
    REQUIRE(points.size() == 8);
    CHECK(points[0] == std::vector<double>{2, 0});
    CHECK(points[1] == std::vector<double>{2, 10});
    CHECK(points[7] == std::vector<double>{4, 30});
    const auto rows = study::rows(s);
    REQUIRE(rows.size() == 16);
    CHECK((rows[3].seed == 6 && rows[3].point == 1 && rows[3].number == 4));
}

TEST_CASE("a Latin hypercube meets every share of every factor once, by its seed", "[study]") {
    const Desk desk("latin");
    const std::string text = HEAD +
                             "plan = \"latin\"\nsamples = 24\n[factors]\n"
                             "A = {from = 10, to = 34}\nB = [1, 2, 3]\n";
    const study::Study s = desk.study(text);
    const auto points = study::points(s);
    REQUIRE(points.size() == 24);
    std::set<int> shares;
    std::map<double, int> listed;
    for (const auto& point : points) {
        shares.insert(static_cast<int>(point[0] - 10.0));
        ++listed[point[1]];
    }
    CHECK(shares.size() == 24);
    CHECK(listed == std::map<double, int>{{1, 8}, {2, 8}, {3, 8}});
    CHECK(study::points(s) == points);
    CHECK(study::points(desk.study("plan_seed = 2\n" + text)) != points);
}

TEST_CASE("points come from a CSV", "[study]") {
    const Desk desk("points");
    desk.put("p.csv", "SPEED, NP\r\n2.5, 1e3\r\n\r\n3,2000\r\n");
    const study::Study s = desk.study(HEAD + "plan = \"points\"\npoints = \"p.csv\"\n");
    CHECK(study::points(s) == std::vector<std::vector<double>>{{2.5, 1000}, {3, 2000}});
    CHECK(study::definitions_of(s, study::rows(s)[0]) ==
          std::vector<std::string>{"SPEED=2.5", "NP=1000"});
    desk.put("p.csv", "\xEF\xBB\xBFSPEED,NP\n2,7\n");
    CHECK(desk.study(HEAD + "plan = \"points\"\npoints = \"p.csv\"\n").factors[0].name == "SPEED");
    CHECK(desk.study("\xEF\xBB\xBF" + HEAD + "plan = \"points\"\npoints = \"p.csv\"\n").listed ==
          std::vector<std::vector<double>>{{2, 7}});
    desk.put("p.csv", "SPEED,NP\n2,x\n3\n");
    const auto faults = desk.faults(HEAD + "plan = \"points\"\npoints = \"p.csv\"\n");
    REQUIRE(faults.size() == 2);
    CHECK(faults[0].find("p.csv:2: x, expected a number") != std::string::npos);
    CHECK(faults[1].find("p.csv:3: 1 numbers, expected 2") != std::string::npos);
}

TEST_CASE("a study's faults are told all at once, with line and key", "[study]") {
    const Desk desk("faults");
    const auto faults = desk.faults(
        "deck = \"no.k\"\nrepeats = 0\nworkrs = 2\n[factors]\nA = {from = 3, to = 2}\nB = \"x\"\n");
    const auto told = [&](const std::string& words) {
        return std::any_of(faults.begin(), faults.end(), [&](const std::string& fault) {
            return fault.find(words) != std::string::npos;
        });
    };
    CHECK(told("s.toml:1: the study deck = 'no.k', expected a deck beside the study"));
    CHECK(told("s.toml:2: the study repeats = 0"));
    CHECK(told("s.toml:3: the study has no key workrs, did you mean workers?"));
    CHECK(told("s.toml:5: [factors] A to = 2, expected a number above from"));
    CHECK(told("has no count"));
    CHECK(told("s.toml:6: [factors] B"));
    CHECK(told("has no responses"));
}

TEST_CASE("a study that does not say how many workers uses all hardware threads", "[study]") {
    const Desk desk("machine");
    const int all = parallel::processors();
    CHECK(desk.study(HEAD + "[factors]\nV = [1, 2]\n").workers == all);
    CHECK(desk.study(HEAD + "threads = 2\n[factors]\nV = [1, 2]\n").workers ==
          std::max(1, all / 2));
    CHECK(desk.study(HEAD + "threads = 1024\n[factors]\nV = [1, 2]\n").workers == 1);
    CHECK(desk.study(HEAD + "workers = 1\n[factors]\nV = [1, 2]\n").workers == 1);
}

TEST_CASE("workers make runs, keep why they failed, and resume makes what is missing", "[study]") {
    const Desk desk("workers");
    desk.put("bag.k", "*KEYWORD\n*INCLUDE\nmesh.k\n*END\n");
    desk.put("mesh.k", "*NODE\n*END\n");
    const std::string text =
        HEAD + "workers = 3\n[fixed]\nNP = 7\n[factors]\nV = [1, 2, 3, 4, 5]\n";
    const study::Study s = desk.study(text);
    fs::create_directories(s.folder);
    // words: run DECK -o DIR --seed 1 -j 1 -D NP=7 -D V=...
    const std::string program = desk.program(
        "echo \"$@\"\ncase \"$*\" in\n*V=2) echo 'bag.k:3: *PART: bad'; echo 'corpuscle: 1 fault "
        "in the input'; exit 2;;\n*V=3) echo 'corpuscle: the physics broke at 3'; echo 'a note'; "
        "exit 3;;\n*V=4) kill -9 $$;;\nesac\n");
    std::map<std::size_t, int> status;
    study::make_runs(s, study::rows(s), program,
                     [&](const study::Row& row, int code) { status[row.number] = code; });
    CHECK(status == std::map<std::size_t, int>{{1, 0}, {2, 2}, {3, 3}, {4, 137}, {5, 0}});
    CHECK(text_of(s.folder / "run_0005" / "log.txt") == "run " + s.deck.string() + " -o " +
                                                            (s.folder / "run_0005").string() +
                                                            " --seed 1 -j 1 -D NP=7 -D V=5\n");
    const study::Table table = study::gather(s);
    CHECK(table.outcomes[1].reason == "bag.k:3: *PART: bad");
    CHECK(table.outcomes[2].reason == "the physics broke at 3");
    CHECK(table.outcomes[3].reason == "killed by signal 9");
    CHECK(table.outcomes[0].is_finished);
    CHECK(table.outcomes[0].status == 1);  // it left no results
    CHECK(table.outcomes[0].reason.find("results.h5") != std::string::npos);

    SECTION("another deck, other runs") {
        CHECK(study::gather(desk.study(text)).outcomes[0].is_finished);
        desk.put("bag.k", "*KEYWORD\n*INCLUDE\nmesh.k\n$ changed\n*END\n");
        CHECK_FALSE(study::gather(desk.study(text)).outcomes[0].is_finished);
    }
    SECTION("another file that the deck includes, other runs") {
        desk.put("mesh.k", "*NODE\n$ changed\n*END\n");
        CHECK_FALSE(study::gather(desk.study(text)).outcomes[0].is_finished);
        desk.put("mesh.k", "*NODE\n*END\n");
        CHECK(study::gather(desk.study(text)).outcomes[0].is_finished);
    }
    SECTION("a run that was broken off is missing") {
        fs::remove(s.folder / "run_0005" / "status");
        CHECK_FALSE(study::gather(s).outcomes[4].is_finished);
        study::make_runs(s, {study::rows(s)[4]}, program, [](const study::Row&, int) {});
        CHECK(text_of(s.folder / "run_0005" / "log.txt").find("--restart") != std::string::npos);
        study::make_runs(s, {study::rows(s)[4]}, program, [](const study::Row&, int) {});
        CHECK(text_of(s.folder / "run_0005" / "log.txt").find("--restart") == std::string::npos);
        CHECK(study::gather(s).outcomes[0].is_finished);
    }
}

TEST_CASE("the table tells responses, means and spread", "[study]") {
    const Desk desk("table");
    const study::Study s = desk.study(
        "deck = \"bag.k\"\nrepeats = 2\nresponses = [\"20.peak_force\", "
        "\"max:/history/energy/gas\"]\n[factors]\nV = [1, 2]\n");
    for (const study::Row& row : study::rows(s)) {
        if (row.number == 4) continue;  // missing
        io::ResultsFile results(study::folder_of(s, row), scene::info(), scene::layout());
        results.follow(0.01, {{20, 4.5, Vec3(1, 2, 3), Vec3(10, 0, 0)}});
        for (int n = 0; n <= 4; ++n)
            results.observe(
                0.1 * n, {{Vec3(0, 0, 0), Vec3(9, 0, 0), Vec3(-10.0 * row.number, 0, 0)}}, n == 4);
        results.append(scene::sample(scene::layout(), 0));
        results.finish("normal");
        study::write_status(s, row, 0, {1.5}, "");
    }
    const study::Table table = study::gather(s);
    CHECK(table.outcomes[0].responses[0] == Approx(10.0));
    CHECK(table.outcomes[1].responses[0] == Approx(20.0));
    CHECK(table.outcomes[0].units == std::vector<std::string>{"kN", "J"});
    CHECK(std::isnan(table.outcomes[3].responses[0]));
    study::Study other = s;
    other.responses = {"20.peak_froce", "20.peak_force"};
    CHECK(study::read_outcome(other, study::rows(s)[0]).reason == "no response 20.peak_froce");
    const study::Spread spread = study::spread_of({10.0, 20.0, NaN});
    CHECK(spread.mean == 15.0);
    CHECK(spread.deviation == Approx(std::sqrt(50.0)));
    const auto effect = study::main_effect(table, 0, 0);
    REQUIRE(effect.size() == 2);
    CHECK(effect[0].mean == Approx(15.0));
    CHECK(effect[1].mean == Approx(30.0));

    study::write_csv(table);
    std::stringstream csv(text_of(s.folder / "study.csv"));
    std::string line;
    std::getline(csv, line);
    CHECK(line ==
          "run,point,V,seed,status,seconds,20.peak_force [kN],max:/history/energy/gas [J],reason");
    std::getline(csv, line);
    CHECK(line.starts_with("1,1,1,1,normal,1.5,10"));
    for (int k = 0; k < 3; ++k) std::getline(csv, line);
    CHECK(line == "4,2,2,2,missing,,,,");

    study::write_h5(table);
    const io::Hdf5Reader h5(s.folder / "study.h5");
    CHECK(h5.read<double>("/factors/V") == std::vector<double>{1, 1, 2, 2});
    CHECK(h5.read<std::int32_t>("/status") == std::vector<std::int32_t>{0, 0, 0, -1});
    CHECK(h5.read<double>("/responses/20.peak_force")[2] == Approx(30.0));
    CHECK(h5.text("/responses/20.peak_force", "unit") == "kN");
    CHECK(study::table_text(table).find("15 +- 64 (47 %)") != std::string::npos);
}

TEST_CASE("a study for Slurm without sbatch says so, with one it is an array and a table after it",
          "[study]") {
    const Desk desk("slurm");
    const study::Study s = desk.study(HEAD + "workers = 3\nthreads = 2\n[factors]\nV = [1, 2]\n");
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", desk.folder.path.c_str(), 1);
    CHECK_THROWS_WITH(study::submit(s, 2, "/bin/corpuscle", ""), Catch::Contains("no sbatch"));

    const fs::path sbatch = desk.folder.path / "sbatch";
    desk.put("sbatch", "#!/bin/sh\nPATH=" + path + "\necho \"$@\" >> " +
                           (desk.folder.path / "said").string() + "\necho 41\n");
    fs::permissions(sbatch, fs::perms::owner_all);
    ::setenv("PATH", (desk.folder.path.string() + ":" + path).c_str(), 1);
    const std::string told = study::submit(s, 2500, "/bin/corpuscle", " --retry-failed");
    ::setenv("PATH", path.c_str(), 1);
    CHECK(told.find("2500 runs in Slurm's array 41 (3 at a time)") != std::string::npos);
    const std::string said = text_of(desk.folder.path / "said");
    CHECK(said.find("--array=0-999%3 --cpus-per-task=2") != std::string::npos);
    CHECK(said.find("--dependency=afterany:41") != std::string::npos);
    const std::string script = text_of(s.folder / "slurm" / "runs.sh");
    CHECK(script.find("'/bin/corpuscle' study '") != std::string::npos);
    CHECK(script.find(" --retry-failed --share \"$SLURM_ARRAY_TASK_ID/1000\"") !=
          std::string::npos);
}

TEST_CASE("a body that met nothing has no time to contact, and its run went well", "[study]") {
    const Desk desk("no_contact");
    const study::Study s =
        desk.study("deck = \"bag.k\"\nresponses = [\"20.time_to_contact\"]\n[factors]\nV = [1]\n");
    const study::Row row = study::rows(s)[0];
    io::ResultsFile results(study::folder_of(s, row), scene::info(), scene::layout());
    results.follow(0.01, {{20, 4.5, Vec3::Zero(), Vec3(10, 0, 0)}});
    for (int n = 0; n <= 4; ++n)
        results.observe(0.1 * n, {{Vec3(n, 0, 0), Vec3(10, 0, 0), Vec3::Zero()}}, n == 4);
    results.finish("normal");
    study::write_status(s, row, 0, {1.0}, "");
    const study::Outcome outcome = study::read_outcome(s, row);
    CHECK(outcome.status == 0);
    CHECK(std::isnan(outcome.responses[0]));
}

TEST_CASE("names that no run could know are found before the first", "[study]") {
    const Desk desk("names");
    desk.put("bag.k",
             "*KEYWORD\n*PARAMETER\nR SPEED          3.0\nI NP             100\n*INCLUDE\n"
             "mesh.k\n*END\n");
    desk.put("mesh.k", "*PARAMETER\nR SIZE           2.0\n*END\n");
    const auto faults = [&](const std::string& text) -> std::vector<std::string> {
        try {
            study::expect_known_names(desk.study(text));
        } catch (const InputError& error) {
            return error.faults;
        }
        return {};
    };
    CHECK(faults(HEAD + "[fixed]\nNP = 7\nCLOSE = 0\n[factors]\nspeed = [1]\nSIZE = [1, 2]\n")
              .empty());
    const auto told = faults(
        "deck = \"bag.k\"\nresponses = [\"20.peak_force\", \"20.peak_froce\", "
        "\"mx:/history/airbag/1/pressure\", \"max:/history/airbag/1/pressure\"]\n"
        "[fixed]\nPN = 7\n[factors]\nSPED = [1, 2]\n");
    REQUIRE(told.size() == 4);
    CHECK_THAT(told[0], Catch::Contains("s.toml: [factors] SPED, expected a *PARAMETER of bag.k: "
                                        "NP, SIZE, SPEED"));
    CHECK_THAT(told[1], Catch::Contains("s.toml: [fixed] PN, expected a *PARAMETER of bag.k"));
    CHECK_THAT(told[2], Catch::Contains("responses = 20.peak_froce, expected BODY.RESPONSE"));
    CHECK_THAT(told[3], Catch::Contains("responses = mx:/history/airbag/1/pressure"));
    CHECK(study::has_form_of_response("last:/history/energy/total"));  // as end:
}
