// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <regex>
#include <sstream>

#include "io/results/hdf5.hpp"
#include "io/results/results_file.hpp"
#include "tests/unit/io/results/results_scene.hpp"

using namespace corpuscle;

namespace {

std::string xml_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// Every tag is closed in turn, attributes are quoted, and there is one root.
bool is_well_formed(const std::string& xml) {
    static const std::regex tag(R"re(<(/?)([A-Za-z]+)((?: [A-Za-z]+="[^"<&]*")*)(/?)>)re");
    std::string rest = std::regex_replace(xml, std::regex(R"(<\?xml[^>]*\?>|<!DOCTYPE[^>]*>)"), "");
    std::vector<std::string> open;
    int roots = 0;
    std::string between;
    for (auto it = std::sregex_iterator(rest.begin(), rest.end(), tag);
         it != std::sregex_iterator(); ++it) {
        between += it->prefix();
        const bool closes = (*it)[1].length() > 0, closes_itself = (*it)[4].length() > 0;
        if (closes) {
            if (open.empty() || open.back() != (*it)[2]) return false;
            open.pop_back();
        } else {
            if (open.empty()) ++roots;
            if (!closes_itself) open.push_back((*it)[2]);
        }
    }
    return roots == 1 && open.empty() && between.find_first_of("<>&") == std::string::npos;
}

struct Item {
    io::Shape shape;
    std::string type;
    std::size_t bytes;
    std::string path;
};

std::vector<Item> items_of(const std::string& xml) {
    static const std::regex item(
        R"re(<DataItem Format="HDF" Dimensions="([0-9 ]+)" NumberType="(\w+)" Precision="(\d)">results\.h5:([^<]+)</DataItem>)re");
    std::vector<Item> found;
    for (auto it = std::sregex_iterator(xml.begin(), xml.end(), item); it != std::sregex_iterator();
         ++it) {
        Item& one = found.emplace_back();
        std::istringstream dimensions((*it)[1]);
        for (std::uint64_t n = 0; dimensions >> n;) one.shape.push_back(n);
        one.type = (*it)[2];
        one.bytes = std::stoul((*it)[3]);
        one.path = (*it)[4];
    }
    return found;
}

std::size_t count(const std::string& text, const std::string& word) {
    std::size_t n = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        ++n;
    return n;
}

}  // namespace

TEST_CASE("after each version the XDMF file is well-formed and fits results.h5", "[io]") {
    const scene::Folder folder("xdmf");
    const RecordLayout layout = scene::layout();
    io::ResultsFile results(folder.path, scene::info(), layout);
    CHECK(is_well_formed(xml_of(folder.path / "results.xdmf")));
    const std::vector<int> particles{0, 4, -1, 7};
    std::size_t gas = 0;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        results.write(scene::frame(layout, i, particles[i]));
        results.flush();
        if (i + 1 == particles.size()) results.finish("normal");
        if (particles[i] > 0) ++gas;

        const std::string xml = xml_of(folder.path / "results.xdmf");
        REQUIRE(is_well_formed(xml));
        CHECK(count(xml, "<Time ") == i + 1 + gas);
        CHECK(count(xml, fmt::format("<Time Value=\"{}\"/>", 1.5 * static_cast<double>(i))) ==
              (particles[i] > 0 ? 2 : 1));
        CHECK(count(xml, R"(CollectionType="Temporal")") == (gas > 0 ? 2 : 1));
        CHECK(count(xml, R"(<Grid Name="bag" GridType="Uniform">)") == i + 1);
        CHECK(count(xml, R"(<Grid Name="gas" GridType="Uniform">)") == gas);

        const io::Hdf5Reader file(folder.path / "results.h5");
        const std::vector<Item> items = items_of(xml);
        CHECK(items.size() == count(xml, "<DataItem"));
        CHECK(items.size() == 9 * (i + 1) + 8 * gas);
        for (const Item& item : items) {
            INFO(item.path);
            REQUIRE(file.has(item.path));
            CHECK(file.shape(item.path) == item.shape);
            CHECK(file.element_size(item.path) == item.bytes);
        }
    }
}

TEST_CASE("the check of XML knows bad from good", "[io]") {
    CHECK(is_well_formed("<a><b c=\"1\"/><d>text</d></a>"));
    CHECK_FALSE(is_well_formed("<a><b></a></b>"));
    CHECK_FALSE(is_well_formed("<a>"));
    CHECK_FALSE(is_well_formed("<a/><b/>"));
    CHECK_FALSE(is_well_formed("<a b=1></a>"));
    CHECK_FALSE(is_well_formed("<a>1 < 2</a>"));
}
