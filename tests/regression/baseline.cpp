// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/regression/baseline.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace corpuscle::test {

namespace {

const std::string OPTIONS = "# options: ";
const std::string HEADER = "dataset,time,value,tolerance,why";

}  // namespace

Baseline Baseline::read(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string line, header;
    if (!std::getline(in, line) || !line.starts_with(OPTIONS) || !std::getline(in, header) ||
        header != HEADER) {
        throw std::runtime_error(file.string() + " does not begin with its options and header");
    }
    Baseline baseline{line.substr(OPTIONS.size()), {}};
    while (std::getline(in, line)) {
        std::istringstream fields(line);
        Row row;
        for (std::string* field : {&row.dataset, &row.time, &row.value, &row.tolerance}) {
            std::getline(fields, *field, ',');
        }
        std::getline(fields, row.why);  // the rest: a sentence may hold commas
        if (row.why.empty()) throw std::runtime_error(file.string() + ": no reason in: " + line);
        baseline.rows.push_back(row);
    }
    return baseline;
}

void Baseline::write(const std::filesystem::path& file) const {
    std::ofstream out(file);
    out << OPTIONS << options << '\n' << HEADER << '\n';
    for (const Row& row : rows) {
        out << row.dataset << ',' << row.time << ',' << row.value << ',' << row.tolerance << ','
            << row.why << '\n';
    }
    if (!out.flush()) throw std::runtime_error("cannot write " + file.string());
}

}  // namespace corpuscle::test
