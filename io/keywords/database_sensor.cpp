// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {
namespace {

/// A box has a third length, a cylinder a second, a sphere neither.
gas::SensorCard shape(Card& c) {
    using Shape = gas::SensorCard::Shape;
    gas::SensorCard sensor;
    sensor.offset = c.real("OFFSET");
    sensor.size = {c.real("R/LX", POSITIVE), c.real("LEN/LY", NON_NEGATIVE),
                   c.real("LZ", NON_NEGATIVE)};
    if (sensor.size[2] > 0.0) {
        sensor.shape = Shape::BOX;
        if (sensor.size[1] == 0.0) c.fault("LEN/LY", "> 0, for LZ makes this sensor a box");
    } else if (sensor.size[1] > 0.0) {
        sensor.shape = Shape::CYLINDER;
    }
    return sensor;
}

}  // namespace

void database_cpm_sensor(Cards& cards, Draft& draft) {
    {
        Card c = cards.next("DT BINARY=1");
        const double interval = c.real("DT", NON_NEGATIVE);
        draft.model.output.cpm_sensor = interval > 0.0 ? interval : NaN;  // 0: results.h5 alone
        c.harmless("BINARY");
    }
    if (!cards.rows()) return cards.fault("has no sensor, expected a line SEGSID OFFSET R/LX ...");
    while (cards.rows()) {
        Card c = cards.next("SEGSID OFFSET R/LX LEN/LY LZ");
        gas::SensorCard sensor = shape(c);
        const Index set = c.row("SEGSID", draft.segment_sets);
        if (set < 0) continue;
        for (const auto& segment : draft.segment_set[static_cast<std::size_t>(set)]) {
            sensor.nodes = segment;
            draft.model.sensors.push_back(sensor);
        }
    }
}

}  // namespace corpuscle::io::keywords
