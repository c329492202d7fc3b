// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Responses as text, JSON and HDF5.

#include <fmt/format.h>

#include <cmath>

#include "io/responses/body_responses.hpp"
#include "io/text/json.hpp"

namespace corpuscle::io {

std::string responses_json(const std::vector<BodyTable>& tables) {
    std::string out = "{\"bodies\": {";
    for (std::size_t b = 0; b < tables.size(); ++b) {
        out += fmt::format("{}\n  \"{}\": {{", b == 0 ? "" : ",", tables[b].id);
        const std::vector<Response>& responses = tables[b].responses;
        for (std::size_t k = 0; k < responses.size(); ++k) {
            const Response& r = responses[k];
            out += fmt::format(
                "{}\n    {}: {{\"value\": {}, \"unit\": {}, \"filter\": {}, \"note\": {}}}",
                k == 0 ? "" : ",", json(r.name), json(r.value), json(r.unit), json(r.filter),
                json(r.note));
        }
        out += "}";
    }
    return out + "}}\n";
}

std::string responses_text(const BodyTable& table) {
    std::string out = fmt::format("rigid body {}\n  {:<28} {:>12} {:<12} {:<10} {}\n", table.id,
                                  "response", "value", "unit", "filter", "note");
    for (const Response& r : table.responses) {
        const std::string value = std::isfinite(r.value) ? fmt::format("{:.5g}", r.value) : "-";
        out += fmt::format("  {:<28} {:>12} {:<12} {:<10} {}", r.name, value, r.unit, r.filter,
                           r.note);
        out.erase(out.find_last_not_of(' ') + 1);
        out += '\n';
    }
    return out;
}

void write_responses(Hdf5Writer& file, const std::vector<BodyTable>& tables) {
    for (const BodyTable& table : tables)
        for (const Response& r : table.responses) {
            if (!std::isfinite(r.value)) continue;
            file.dataset<double>(
                fmt::format("/responses/{}/{}", table.id, r.name), std::span(&r.value, 1), {},
                {r.unit, r.note.empty() ? fmt::format("filter: {}", r.filter)
                                        : fmt::format("filter: {}; {}", r.filter, r.note)});
        }
}

}  // namespace corpuscle::io
