// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <zlib.h>
#include <catch2/catch.hpp>

#include <cmath>
#include <cstring>
#include <fstream>

#include "solver/base/error.hpp"
#include "tests/unit/io/results/results_scene.hpp"
#include "tools/report/pack.hpp"
#include "tools/report/page.hpp"
#include "tools/report/pictures.hpp"
#include "tools/report/run_data.hpp"

using namespace corpuscle;
namespace fs = std::filesystem;

namespace {

std::string inflated(const std::string& packed, std::size_t size) {
    std::string out(size, '\0');
    uLongf got = size;
    REQUIRE(uncompress(reinterpret_cast<Bytef*>(out.data()), &got,
                       reinterpret_cast<const Bytef*>(packed.data()), packed.size()) == Z_OK);
    out.resize(got);
    return out;
}

/// The number behind "name": in JSON.
std::size_t number(const std::string& json, const std::string& name, std::size_t from = 0) {
    const std::string mark = "\"" + name + "\":";
    const std::size_t at = json.find(mark, from);
    REQUIRE(at != std::string::npos);
    return std::stoul(json.substr(at + mark.size()));
}

template <class T>
std::vector<T> section(const std::string& bytes, std::size_t at, std::size_t count) {
    REQUIRE(at + count * sizeof(T) <= bytes.size());
    std::vector<T> values(count);
    std::memcpy(values.data(), bytes.data() + at, count * sizeof(T));
    return values;
}

/// Results with two frames.
struct Run {
    scene::Folder folder{"report"};
    RecordLayout layout = scene::layout();
    std::vector<Frame> frames;
    Sample last;
    Run() {
        io::RunInfo info = scene::info();
        info.ambient = {{7, 1000.0}};
        info.parts = {{10, "cloth"}, {20, "head"}};
        info.up = "-y";
        io::ResultsFile results(folder.path, info, layout);
        for (std::size_t k = 0; k < 2; ++k) {
            last = scene::sample(layout, k);
            results.append(last);
            frames.push_back(scene::frame(layout, k, 4));
            results.write(frames.back());
        }
        results.finish("normal");
    }
};

}  // namespace

TEST_CASE("base64 as RFC 4648 has it", "[report]") {
    CHECK(report::base64("") == "");
    CHECK(report::base64("f") == "Zg==");
    CHECK(report::base64("fo") == "Zm8=");
    CHECK(report::base64("foobar") == "Zm9vYmFy");
    CHECK(report::base64(std::string("\xff\x00\xfe", 3)) == "/wD+");
}

TEST_CASE("packing loses nothing but the range's steps", "[report]") {
    report::Range range;
    for (const double value : {-2.0, 6.0, 1.0}) range.take(value);
    CHECK(range.in_16_bits(-2.0) == 0);
    CHECK(range.in_16_bits(6.0) == 65535);
    for (const double value : {-1.9, 0.0, 3.3})
        CHECK(range.low + 8.0 * range.in_16_bits(value) / 65535.0 ==
              Approx(value).margin(4.0 / 65535.0 + 1e-12));
    report::Range one;
    one.take(3.0);
    CHECK(one.in_8_bits(3.0) == 0);
    const std::string text(5000, 'x');
    CHECK(inflated(report::deflated(text), 6000) == text);
    const std::vector<std::uint16_t> a{1, 65535, 7}, b{3, 2, 0};
    const auto c = report::change(b, a);
    for (std::size_t k = 0; k < 3; ++k) CHECK(static_cast<std::uint16_t>(a[k] + c[k]) == b[k]);
}

TEST_CASE("a run's data hold its mesh, places and histories", "[report]") {
    const Run run;
    const report::RunData data = report::run_data(run.folder.path);
    // a quad and a triangle
    CHECK(number(data.json, "triangles") == 3);
    const auto corners = section<std::uint32_t>(data.bytes, number(data.json, "corners_at"), 9);
    CHECK(corners == std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 3, 2, 4});
    CHECK(section<std::uint32_t>(data.bytes, number(data.json, "shell_of_at"), 3) ==
          std::vector<std::uint32_t>{0, 0, 1});

    // places, back from changes and the box
    const std::size_t box_at = data.json.find("\"box\": [[") + 9;
    std::size_t used = 0;
    const double low = std::stod(data.json.substr(box_at), &used);
    const double high = std::stod(data.json.substr(box_at + used + 1));
    const std::size_t first = data.json.find("\"frames\""),
                      second = data.json.find("\"t\":", data.json.find("\"t\":", first) + 4);
    const auto x_0 = section<std::uint16_t>(data.frames[0], number(data.json, "x", first), 15);
    const auto x_1 = section<std::uint16_t>(data.frames[1], number(data.json, "x", second), 15);
    for (std::size_t n = 0; n < 5; ++n) {
        const auto place = [&](std::uint16_t q) { return low + (high - low) * q / 65535.0; };
        const double step = (high - low) / 65535.0;
        CHECK(place(x_0[3 * n]) == Approx(run.frames[0].coordinates[n].x()).margin(step));
        CHECK(place(static_cast<std::uint16_t>(x_0[3 * n] + x_1[3 * n])) ==
              Approx(run.frames[1].coordinates[n].x()).margin(step));
    }

    // contact pressure of two shells, in the range of all
    float least = INFINITY, most = -INFINITY;
    for (const Frame& frame : run.frames)
        for (const float value : frame.shell_contact_pressure) {
            least = std::min(least, value);
            most = std::max(most, value);
        }
    const auto contact =
        section<std::uint8_t>(data.frames[1], number(data.json, "contact", second), 2);
    for (std::size_t s = 0; s < 2; ++s)
        CHECK(least + (most - least) * static_cast<float>(contact[s]) / 255.0F ==
              Approx(run.frames[1].shell_contact_pressure[s]).margin((most - least) / 510.0));

    // temperature of the particles, likewise
    least = INFINITY, most = -INFINITY;
    for (const Frame& frame : run.frames)
        for (const float value : frame.particles->temperature) {
            least = std::min(least, value);
            most = std::max(most, value);
        }
    const std::vector<float>& hot = run.frames[1].particles->temperature;
    const auto heat =
        section<std::uint8_t>(data.frames[1], number(data.json, "temperature", second), hot.size());
    for (std::size_t k = 0; k < hot.size(); ++k)
        CHECK(least + (most - least) * static_cast<float>(heat[k]) / 255.0F ==
              Approx(hot[k]).margin((most - least) / 510.0));

    const std::size_t pressure = data.json.find("\"name\":\"airbag/7/pressure\"");
    REQUIRE(pressure != std::string::npos);
    const auto values =
        section<float>(data.bytes, number(data.json, "at", pressure), number(data.json, "rows"));
    // of GPa
    CHECK(values.back() == Approx(1e6 * run.last.airbags[0].pressure).epsilon(1e-6));
    const std::size_t gauge = data.json.find("\"name\":\"airbag/7/pressure_gauge\"");
    REQUIRE(gauge < pressure);
    CHECK(section<float>(data.bytes, number(data.json, "at", gauge), 2).back() ==
          Approx(1e6 * (run.last.airbags[0].pressure - 1000.0)).epsilon(1e-6));
    for (const char* said :
         {"\"label\":\"bag 7: pressure, gauge\",\"unit\":\"kPa\"",
          "\"label\":\"bag 7: volume\",\"unit\":\"l\"",
          "\"label\":\"bag 9: pressure\",\"unit\":\"kPa\"",
          "\"label\":\"bag 7: gas gone through vents\",\"unit\":\"g\"",
          "\"label\":\"rigid body 20 \\\"head\\\": force, z\",\"unit\":\"kN\"",
          "\"label\":\"bag 7, part 10 \\\"cloth\\\": area\",\"unit\":\"cm^2\"", "\"up\": \"-y\"",
          "\"part_titles\": {\"10\":\"cloth\",\"20\":\"head\"}"}) {
        CAPTURE(said);
        CHECK(data.json.find(said) != std::string::npos);
    }
}

TEST_CASE("a page is whole in itself and asks nothing of the net", "[report]") {
    const Run run;
    std::string page = report::page({run.folder.path, run.folder.path});
    CHECK(page.starts_with("<!DOCTYPE html>"));
    const std::string name = "\"http://www.w3.org/1999/xhtml\"";  // a namespace, not an address
    REQUIRE(page.find(name) != std::string::npos);
    page.erase(page.find(name), name.size());
    for (const char* asks : {"http:", "https:", "src=", "<link", "@import", "import(", "fetch("})
        CHECK(page.find(asks) == std::string::npos);
    CHECK(page.find("default-src 'none'") != std::string::npos);
    for (const char* part : {"id=\"run0\"", "id=\"bytes0\"", "id=\"run1\"", "id=\"bytes1\"",
                             "id=\"frame0_1\"", "class Viewer", "class Chart", "three.js authors",
                             "Leon Sorokin", "id=\"slider\"", "\"termination\": \"normal\""})
        CHECK(page.find(part) != std::string::npos);
    for (const char* mark : {"@TITLE@", "@STYLE@", "@DATA@", "@LIBRARIES@", "@SCRIPT@", "@FRAMES@"})
        CHECK(page.find(mark) == std::string::npos);
}

TEST_CASE("base64 comes back whatever the length", "[report]") {
    std::string bytes;
    for (int k = 0; k < 300; ++k) {
        CHECK(report::from_base64(report::base64(bytes)) == bytes);
        bytes += static_cast<char>(37 * k);
    }
}

TEST_CASE("pictures without a Chromium are refused and told what is missing", "[report]") {
    const scene::Folder folder("no_browser");
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", folder.path.c_str(), 1);
    CHECK_THROWS_WITH(report::pictures("<body></body>"),
                      Catch::Contains("no Chromium on the PATH"));
    ::setenv("PATH", path.c_str(), 1);
}

TEST_CASE("a study's page holds its table, and a folder of neither kind is refused", "[report]") {
    const scene::Folder folder("report_study");
    fs::create_directories(folder.path);
    CHECK_THROWS_WITH(report::page({folder.path}), Catch::Contains("expected a folder with"));
    std::ofstream(folder.path / "study.csv")
        << "run,point,V,seed,status,seconds,a [N],reason\n"
           "1,1,2,1,failed (2),1,,\"</script> \"\"x\"\", y\"\n";
    const std::string page = report::page({folder.path});
    CHECK(page.find("id=\"study\"") != std::string::npos);
    CHECK(page.find("</script> \\") == std::string::npos);
    CHECK(page.find("\\u003c/script> \\\"\\\"x") != std::string::npos);
}
