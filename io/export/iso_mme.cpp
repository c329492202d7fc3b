// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/export/iso_mme.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "io/responses/body_responses.hpp"
#include "io/text/units.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::io {
namespace {

/// "Name of the channel         :..."
std::string entry(std::string_view name, const std::string& value) {
    return fmt::format("{:<28}:{}\n", name, value);
}

struct Channel {
    std::string code, name, unit;
    std::vector<double> values;  ///< in that unit
};

/// One quantity of a body.
struct Kind {
    std::string_view code, name, unit;
    double scale;  ///< of the deck's unit to `unit`
    bool has_resultant;
};

class Test {
public:
    Test(const Hdf5Reader& results, const std::string& name)
        : results_(results), name_(name), ids_(tracked_bodies(results)) {
        const std::string system = results.text("/", "unit_system");
        const auto scale = scale_of(system);
        std::vector<std::string> faults;
        if (ids_.empty())
            faults.emplace_back("--iso-mme: expected results with a rigid body that can move");
        if (!scale)
            faults.push_back(
                fmt::format("--iso-mme: expected results in {}, whose units have names: these "
                            "are {}",
                            unit_systems(), system));
        if (!faults.empty()) throw InputError(faults);
        scale_ = *scale;
        for (std::size_t b = 0; b < ids_.size(); ++b) add_body(b);
    }

    void write(const MmeFile& write) const {
        write(name_ + ".mme", about());
        write(fmt::format("Channel/{}.chn", name_), contents());
        for (std::size_t k = 0; k < channels_.size(); ++k)
            write(fmt::format("Channel/{}.{:03}", name_, k + 1), channel(channels_[k]));
    }

private:
    void add_body(std::size_t b) {
        const BodyMotion motion = read_motion(results_, ids_[b]);
        interval_ = motion.interval * scale_.second;
        const double velocity = scale_.metre / scale_.second,
                     acceleration = velocity / scale_.second;
        const auto number = ids_.size() == 1 ? std::size_t{0} : b + 1;
        const auto add = [&](const Kind& kind, const Points& rows) {
            const auto put = [&](char axis, const auto& value) {
                Channel channel{
                    fmt::format("H0IMPA0000{:02}{}{}0", number, kind.code, axis),
                    fmt::format("Part {}, {}, {}", ids_[b], kind.name,
                                axis == 'R' ? "resultant" : fmt::format("deck's {}", axis)),
                    std::string(kind.unit),
                    {}};
                for (const Vec3& row : rows) channel.values.push_back(kind.scale * value(row));
                channels_.push_back(std::move(channel));
            };
            for (int axis = 0; axis < 3; ++axis)
                put("XYZ"[axis], [axis](const Vec3& row) { return row[axis]; });
            if (kind.has_resultant) put('R', [](const Vec3& row) { return row.norm(); });
        };
        Points way;
        for (const Vec3& x : motion.position) way.push_back(x - motion.position.front());
        add({"AC", "acceleration", "m/(s*s)", acceleration, true}, motion.acceleration);
        add({"FO", "force of contact and gas", "N", scale_.kilogram * acceleration, true},
            motion.force);
        add({"VE", "velocity", "m/s", velocity, false}, motion.velocity);
        add({"DS", "displacement", "m", scale_.metre, false}, way);
    }

    [[nodiscard]] std::string about() const {
        // every entry of the header, in its order; what a simulation has not is NOVALUE
        std::string text = entry("Data format edition number", "1.6");
        text += entry("Laboratory name",
                      results_.text("/", "program") + " " + results_.text("/", "version"));
        for (const char* name : {"Laboratory contact name", "Laboratory contact phone",
                                 "Laboratory contact fax", "Laboratory contact email"})
            text += entry(name, "NOVALUE");
        text += entry("Laboratory test ref. number", name_);
        for (const char* name :
             {"Customer name", "Customer test ref. number", "Customer project ref. number",
              "Customer order number", "Customer cost unit", "Customer test engineer name",
              "Customer test engineer phone", "Customer test engineer fax",
              "Customer test engineer email"})
            text += entry(name, "NOVALUE");
        text +=
            entry("Title", results_.text("/", "deck")) +
            entry("Medium No./number of media", "1/1") + entry("Comments", "numerical simulation") +
            entry("Type of the test", "simulation") + entry("Date of the test", "NOVALUE") +
            entry("Subtype of the test", "NOVALUE") + entry("Regulation", "NOVALUE") +
            entry("Reference temperature", "NOVALUE") + entry("Relative air humidity", "NOVALUE") +
            entry("Number of test objects", "1") + entry("Name of test object 1", "impactor");
        for (const char* name :
             {"Velocity test object 1", "Mass test object 1", "Driver position object 1",
              "Impact side test object 1", "Type of test object 1"})
            text += entry(name, "NOVALUE");
        return text + entry("Class of test object 1", "H") + entry("Code of test object 1", "H") +
               entry("Ref. number of test object 1", "NOVALUE");
    }

    [[nodiscard]] std::string contents() const {
        std::string text = entry("Instrumentation standard", "NOVALUE") +
                           entry("Number of channels", fmt::format("{}", channels_.size()));
        for (std::size_t k = 0; k < channels_.size(); ++k)
            text += entry(fmt::format("Name of channel {:03}", k + 1),
                          fmt::format("{} / {}", channels_[k].code, channels_[k].name));
        return text;
    }

    [[nodiscard]] std::string channel(const Channel& c) const {
        const auto number = [](double value) { return fmt::format("{:.9E}", value); };
        // the first of each, which minmax_element does not promise
        const auto least = std::min_element(c.values.begin(), c.values.end());
        const auto greatest = std::max_element(c.values.begin(), c.values.end());
        const auto time = [&](auto at) {
            return number(interval_ * static_cast<double>(at - c.values.begin()));
        };
        std::string text =
            entry("Test object number", "1") + entry("Name of the channel", c.name) +
            entry("Laboratory channel code", "NOVALUE") +
            entry("Customer channel code", "NOVALUE") + entry("Channel code", c.code) +
            entry("Unit", c.unit) + entry("Reference system", "axes of the deck") +
            entry("Pre-filter type", "NOVALUE") + entry("Cut off frequency", "NOVALUE") +
            entry("Channel amplitude class", "NOVALUE") +
            entry("Channel frequency class", "NOVALUE") + entry("Data source", "simulation") +
            entry("Data status", "ok") + entry("Reference channel", "implicit") +
            entry("Reference channel name", "NOVALUE") +
            entry("Sampling interval", number(interval_)) +
            entry("Time of first sample", number(0.0)) +
            entry("Number of samples", fmt::format("{}", c.values.size())) +
            entry("First global maximum value", number(*greatest)) +
            entry("Time of maximum value", time(greatest)) +
            entry("First global minimum value", number(*least)) +
            entry("Time of minimum value", time(least)) +
            entry("Start offset interval", "NOVALUE") + entry("End offset interval", "NOVALUE");
        for (const double value : c.values) text += number(value) + "\n";
        return text;
    }

    const Hdf5Reader& results_;
    const std::string& name_;
    std::vector<int> ids_;
    UnitScale scale_;
    double interval_ = 0.0;  ///< [s]
    std::vector<Channel> channels_;
};

}  // namespace

void write_iso_mme(const Hdf5Reader& results, const std::string& test, const MmeFile& write) {
    Test(results, test).write(write);
}

}  // namespace corpuscle::io
