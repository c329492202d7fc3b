// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/support/decks/mirrored.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <sstream>
#include <vector>

#include "tests/support/draw.hpp"

namespace corpuscle::support {
namespace {

using Fields = std::vector<std::string>;

struct Block {
    std::string keyword;
    std::vector<Fields> rows;
};

std::vector<Block> blocks_of(const std::string& deck) {
    std::vector<Block> blocks;
    std::istringstream lines(deck);
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind('*', 0) == 0) {
            blocks.push_back({line, {}});
            continue;
        }
        Fields fields;
        std::istringstream row(line);
        for (std::string field; std::getline(row, field, ',');)
            fields.push_back(field.substr(std::min(field.find_first_not_of(' '), field.size())));
        if (line.empty() || line.back() == ',') fields.emplace_back();
        blocks.back().rows.push_back(fields);
    }
    return blocks;
}

std::string deck_of(const std::vector<Block>& blocks) {
    std::string text;
    for (const Block& block : blocks) {
        text += block.keyword + "\n";
        for (const Fields& fields : block.rows) {
            for (std::size_t i = 0; i < fields.size(); ++i) text += (i > 0 ? ", " : "") + fields[i];
            text += "\n";
        }
    }
    return text;
}

void negate(std::string& number) {
    number = number.rfind('-', 0) == 0 ? number.substr(1) : "-" + number;
}

void shuffle(std::vector<Fields>& rows, Draw& draw) {
    for (std::size_t i = rows.size(); i > 1; --i)
        std::swap(rows[i - 1], rows[static_cast<std::size_t>(draw.below(static_cast<int>(i)))]);
}

/// Of all nodes in *NODE below 100 000: those above are nozzles' and bodies'.
std::map<std::string, std::string> new_ids(const std::vector<Block>& blocks, Draw& draw) {
    std::vector<Fields> nodes;
    for (const Block& block : blocks)
        if (block.keyword == "*NODE")
            for (const Fields& row : block.rows)
                if (row[0].size() < 6) nodes.push_back(row);
    const std::vector<Fields> before = nodes;
    shuffle(nodes, draw);
    std::map<std::string, std::string> ids;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        ids[before[i][0]] = std::to_string(3 * std::stoi(nodes[i][0]) + 7);
    return ids;
}

/// x of points and directions. Columns of each keyword's only row.
const std::map<std::string, std::vector<std::size_t>> ALONG_X{
    {"*DEFINE_VECTOR", {1, 4}},
    {"*INITIAL_VELOCITY_GENERATION", {3}},
    {"*INITIAL_VELOCITY_RIGID_BODY", {1}}};

}  // namespace

std::string triangulated(const std::string& deck) {
    std::vector<Block> blocks = blocks_of(deck);
    for (Block& block : blocks) {
        if (block.keyword != "*ELEMENT_SHELL") continue;
        std::vector<Fields> second;
        for (Fields& row : block.rows) {
            if (row[4] == row[5]) continue;
            second.push_back({std::to_string(50000 + std::stoi(row[0])), row[1], row[2], row[4],
                              row[5], row[5]});
            row[5] = row[4];
        }
        block.rows.insert(block.rows.end(), second.begin(), second.end());
    }
    return deck_of(blocks);
}

std::string mirrored(const std::string& deck, unsigned seed) {
    Draw draw(seed);
    std::vector<Block> blocks = blocks_of(deck);
    const std::map<std::string, std::string> ids = new_ids(blocks, draw);
    const auto renumber = [&](std::string& id) {
        if (const auto at = ids.find(id); at != ids.end()) id = at->second;
    };
    for (Block& block : blocks) {
        if (block.keyword == "*NODE") {
            for (Fields& row : block.rows) renumber(row[0]), negate(row[1]);
            shuffle(block.rows, draw);
        } else if (block.keyword == "*ELEMENT_SHELL") {
            for (Fields& row : block.rows) {
                std::swap(row[2], row[3]);
                for (std::size_t i = 2; i < 6; ++i) renumber(row[i]);
            }
            shuffle(block.rows, draw);
        } else if (block.keyword == "*SET_NODE_LIST") {
            for (std::size_t i = 1; i < block.rows.size(); ++i) renumber(block.rows[i][0]);
        } else if (block.keyword == "*RIGIDWALL_PLANAR") {
            for (const std::size_t i : {0U, 3U}) negate(block.rows[1][i]);
        } else if (const auto at = ALONG_X.find(block.keyword); at != ALONG_X.end()) {
            for (const std::size_t i : at->second) negate(block.rows[0][i]);
        }
    }
    return deck_of(blocks);
}

}  // namespace corpuscle::support
