// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "deck_scene.hpp"

using namespace corpuscle;
using namespace corpuscle::test;
using contact::ContactCard;
using Kind = contact::ContactCard::Kind;

namespace {

/// A contact with these first cards; then friction and thickness are left blank.
ContactCard contact_of(const std::string& text) {
    const DeckFolder folder;
    const Model model = folder.read(small_deck(text));
    REQUIRE(model.contacts.size() == 1);
    return model.contacts[0];
}

using Rows = std::vector<Index>;

}  // namespace

TEST_CASE("contacts of two sides name both, by part, part set, all, or all but some", "[io]") {
    const ContactCard parts = contact_of(
        "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n8,head on bag\n1,2,3,3\n0.3,0.2\n"
        "0,0,0.5,0.7,1,1,0.5\n");
    CHECK(parts.id == 8);
    CHECK(parts.kind == Kind::SURFACE_TO_SURFACE);
    CHECK(parts.parts == Rows{0});
    CHECK(parts.other_parts == Rows{1});
    CHECK(parts.thickness == 0.5);
    CHECK(parts.other_thickness == 0.7);
    CHECK(parts.friction_static == 0.15);
    CHECK(parts.friction_dynamic == 0.1);
    const ContactCard nodes =
        contact_of("*SET_PART\n4\n2\n*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n4,4,2,6\n\n\n");
    CHECK(nodes.kind == Kind::NODES_TO_SURFACE);
    CHECK(nodes.parts == Rows{1});
    CHECK(nodes.other_parts == Rows{0});
    CHECK(std::isnan(nodes.thickness));
    const ContactCard all = contact_of("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,0,3,5\n\n\n");
    CHECK(all.other_parts == Rows{0, 1});
    CHECK(contains(only_fault("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,0,3\n\n\n"),
                   "(SURFB) = 0, expected a part, a set, or type 5"));
}

TEST_CASE("sets of segments, shells and nodes stand for the parts that they are", "[io]") {
    const std::string head = "*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n";
    const std::string segments = "*SET_SEGMENT\n3\n3,1,2\n4,3,1,1\n";
    CHECK(contact_of(segments + head + "3,2,0,3\n\n\n").parts == Rows{0});
    const std::string shells = "*SET_SHELL\n3\n13\n";
    CHECK(contact_of(shells + head + "3,1,1,3\n\n\n").parts == Rows{1});
    const std::string nodes = "*SET_NODE\n3\n1,2,3,4\n";
    CHECK(contact_of(nodes + head + "3,2,4,3\n\n\n").parts == Rows{0});

    const DeckFolder folder;
    const Model some = folder.read(small_deck("*SET_SEGMENT\n3\n3,1,2\n" + head + "3,2,0,3\n\n\n"));
    CHECK(some.contacts.at(0).parts == Rows{0});
    CHECK(some.contact_shells.at(0).first == Rows{0});
    CHECK(some.contact_shells.at(0).second.empty());
    CHECK(contains(only_fault("*SET_SEGMENT\n3\n3,1,5\n" + head + "3,2,0,3\n\n\n"),
                   "segments that are shells: 1 of this set are none"));
    const Model more = folder.read(small_deck("*SET_NODE\n3\n1,2,3,5\n" + head + "3,2,4,3\n\n\n"));
    CHECK(more.contacts.at(0).parts == Rows{0, 1});
    CHECK(more.contact_shells.at(0).first == Rows{0});
    CHECK(any_contains(more.warnings, "1 shells have nodes that are not of this set"));
    CHECK(contains(only_fault("*NODE\n9,5,5,5\n*SET_NODE\n3\n1,2,3,9\n" + head + "3,2,4,3\n\n\n"),
                   "nodes of shells: node 9 is of none"));
    CHECK(contains(only_fault(nodes + head + "2,3,3,4\n\n\n"), "(SURFBTYP) = 4"));
}

TEST_CASE("a scale of the shells' own thickness counts where a side has one thickness", "[io]") {
    const std::string two =
        "*SECTION_SHELL\n2,5\n0.5\n*PART\nthick\n3,2,1\n*ELEMENT_SHELL\n"
        "14,3,2,5,6,6\n";
    const std::string head = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n";
    const ContactCard scaled = contact_of(two + head + "2,3,3,3\n\n0,0,0,0,2.0,3.0\n");
    CHECK(scaled.thickness == Approx(0.6));
    CHECK(scaled.other_thickness == Approx(1.5));
    CHECK(contains(only_fault(two + head + "0,3,5,3\n\n0,0,0,0,2.0\n"),
                   "(SFSAT) = 2.0, expected 1, or parts of one thickness"));
    const ContactCard given = contact_of(head + "1,2,3,3\n\n0,0,0.4,0,2.0\n");
    CHECK(given.thickness == 0.4);
}

TEST_CASE("a curve of contact thicknesses stays above 0", "[io]") {
    const auto deck = [](const char* least) {
        return fmt::format(
            "*DEFINE_CURVE\n17\n0,{}\n1,0.3\n*CONTACT_AIRBAG_SINGLE_SURFACE\n1,0,3\n"
            "\n\n2,0.1,17\n",
            least);
    };
    CHECK(contact_of(deck("0.1")).thickness_curve == 1);
    CHECK(
        contains(only_fault(deck("0")), "(LCIDAB) = 17, expected a curve of thicknesses above 0"));
}

TEST_CASE("*PART_CONTACT gives a part its contact thickness", "[io]") {
    const DeckFolder folder;
    const Model model = folder.read(
        small_deck("*PART_CONTACT\nthin for contact\n3,1,1\n0,0,0,0,0.1\n*ELEMENT_SHELL\n"
                   "14,3,2,5,6,6\n"));
    CHECK(model.parts.at(2).contact_thickness == 0.1);
    CHECK(model.parts.at(2).thickness == 0.3);
    CHECK(std::isnan(model.parts.at(0).contact_thickness));
    const Model rough =
        folder.read(small_deck("*PART_CONTACT\nx\n3,1,1\n0.3\n*ELEMENT_SHELL\n14,3,2,5,6,6\n"));
    CHECK(any_contains(rough.warnings, "(FS) = 0.3"));
    CHECK(contains(only_fault("*PART_CONTACT\nx\n3,1,1\n0,0,0,0,0,2.0\n"), "(SFT) = 2.0"));
}
