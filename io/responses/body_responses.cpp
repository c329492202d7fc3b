// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/responses/body_responses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "io/responses/channel_filter.hpp"
#include "io/responses/criteria.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::io {
namespace {

using Lines = std::vector<double>;

double peak(const Lines& a) {
    return a.empty() ? 0.0 : *std::max_element(a.begin(), a.end());
}

Lines norms(const Points& rows) {
    Lines out;
    for (const Vec3& row : rows) out.push_back(row.norm());
    return out;
}

/// Resultant of the filtered components.
Lines filtered_norms(const Points& rows, double dt, double cfc) {
    Lines squares(rows.size(), 0.0), component(rows.size());
    for (int axis = 0; axis < 3; ++axis) {
        for (std::size_t k = 0; k < rows.size(); ++k) component[k] = rows[k][axis];
        const Lines smooth = filtered(component, dt, cfc);
        for (std::size_t k = 0; k < rows.size(); ++k) squares[k] += smooth[k] * smooth[k];
    }
    for (double& value : squares) value = std::sqrt(value);
    return squares;
}

/// Gathers responses of one body.
class Teller {
public:
    Teller(const BodyMotion& motion, const std::string& units)
        : motion_(motion), units_(units), scale_(scale_of(units)) {}

    std::vector<Response> tell() {
        forces();
        accelerations();
        injuries();
        travel();
        return std::move(all_);
    }

private:
    void add(const char* name, double value, Quantity quantity, const char* filter,
             std::string note = {}) {
        const SpokenUnit unit = spoken(quantity, units_);
        all_.push_back({name, unit.factor * value, unit.unit, filter, std::move(note)});
    }

    void forces() {
        const Lines force = norms(motion_.force);
        peak_force_ = peak(force);
        add("peak_force", peak_force_, Quantity::FORCE, "raw");
        for (const double cfc : {60.0, 180.0, 600.0, 1000.0}) filtered_force(cfc);
        for (const Vec3& f : motion_.force) impulse_ += motion_.interval * f;
        add("impulse", impulse_.norm(), Quantity::MOMENTUM, "raw");
        const auto meets = [&](double f) { return peak_force_ > 0.0 && f > 1e-3 * peak_force_; };
        const auto first = std::find_if(force.begin(), force.end(), meets);
        touches_ = first != force.end();
        // forces are means since the row before: there contact began
        contact_ = std::max<std::ptrdiff_t>(first - force.begin() - 1, 0);
    }

    void filtered_force(double cfc) {
        const SpokenUnit unit = spoken(Quantity::FORCE, units_);
        Response response{fmt::format("peak_force_cfc{:g}", cfc),
                          NaN,
                          unit.unit,
                          fmt::format("CFC {:g}", cfc),
                          {}};
        try {
            if (scale_)
                response.value =
                    unit.factor *
                    peak(filtered_norms(motion_.force, motion_.interval * scale_->second, cfc));
            else
                response.note = "the deck's units are unknown";
        } catch (const InputError& why) {
            response.note = why.what();
        }
        all_.push_back(std::move(response));
    }

    /// One that needs units and a rate that serves its filter; else it says why there is none.
    void in_g(const std::string& name, double cfc, const char* unit,
              const std::function<double(const Lines&, double, std::string&)>& find) {
        Response response{name, NaN, unit, cfc > 0.0 ? fmt::format("CFC {:g}", cfc) : "raw", {}};
        if (!scale_) {
            response.note = "the deck's units are unknown";
        } else {
            const double dt = motion_.interval * scale_->second;
            try {
                Lines a = cfc > 0.0 ? filtered_norms(motion_.acceleration, dt, cfc)
                                    : norms(motion_.acceleration);
                for (double& value : a) value /= scale_->gravity();
                response.value = find(a, dt, response.note);
            } catch (const InputError& why) {
                response.note = why.what();
            }
        }
        all_.push_back(std::move(response));
    }

    void accelerations() {
        const auto highest = [](const Lines& a, double, std::string&) { return peak(a); };
        in_g("peak_acceleration", 0.0, "g", highest);
        for (const double cfc : {60.0, 180.0, 600.0, 1000.0})
            in_g(fmt::format("peak_acceleration_cfc{:g}", cfc), cfc, "g", highest);
    }

    void injuries() {
        const auto lasting = [](Clip how) {
            return
                [how](const Lines& a, double dt, std::string&) { return clip(a, dt, 3e-3, how); };
        };
        in_g("clip_3ms_cfc1000", 1000.0, "g", lasting(Clip::CUMULATIVE));
        in_g("clip_3ms_cfc180", 180.0, "g", lasting(Clip::CUMULATIVE));
        in_g("clip_3ms_contiguous_cfc180", 180.0, "g", lasting(Clip::CONTIGUOUS));
        const auto hic = [](double longest) {
            return [longest](const Lines& a, double dt, std::string& note) {
                const HeadInjury worst = head_injury(a, dt, longest);
                note = fmt::format("{:.3f} to {:.3f} ms", 1e3 * worst.begin, 1e3 * worst.end);
                return worst.value;
            };
        };
        in_g("hic15", 1000.0, "g^2.5 s", hic(0.015));
        in_g("hic36", 1000.0, "g^2.5 s", hic(0.036));
    }

    /// Along which the body meets the bag.
    [[nodiscard]] Vec3 axis() const {
        const Vec3& start = motion_.velocity.front();
        if (!start.isZero(0.0)) return start.normalized();
        return impulse_.isZero(0.0) ? Vec3(Vec3::Zero()) : Vec3(-impulse_.normalized());
    }

    void travel() {
        const Vec3 e = axis();
        const auto energy = [&](const Vec3& v) { return 0.5 * motion_.mass * v.squaredNorm(); };
        const double start = energy(motion_.velocity.front());
        double least = start;
        for (const Vec3& v : motion_.velocity) least = std::min(least, energy(v));
        const std::string none = touches_ ? "" : "no contact";
        const auto after_contact = [&](double value) { return touches_ ? value : NaN; };

        add("rebound_velocity", after_contact(-motion_.velocity.back().dot(e)), Quantity::VELOCITY,
            "-", touches_ ? "at the end, positive away from the bag" : none);
        add("energy_absorbed", start - energy(motion_.velocity.back()), Quantity::ENERGY, "-",
            "kinetic energy at the start less that at the end");
        add("greatest_energy_absorbed", start - least, Quantity::ENERGY, "-",
            "kinetic energy at the start less its least");
        add("time_to_contact", after_contact(static_cast<double>(contact_) * motion_.interval),
            Quantity::TIME, "raw", none);
        double deepest = 0.0;
        for (std::size_t k = static_cast<std::size_t>(contact_); k < motion_.position.size(); ++k)
            deepest = std::max(deepest, (motion_.position[k] -
                                         motion_.position[static_cast<std::size_t>(contact_)])
                                            .dot(e));
        add("greatest_intrusion", after_contact(deepest), Quantity::LENGTH, "-",
            touches_ ? "way after contact along the approach" : none);
    }

    const BodyMotion& motion_;
    const std::string& units_;
    std::optional<UnitScale> scale_;
    std::vector<Response> all_;
    Vec3 impulse_ = Vec3::Zero();
    double peak_force_ = 0.0;
    bool touches_ = false;
    std::ptrdiff_t contact_ = 0;  ///< first row of contact
};

Points points(const Hdf5Reader& file, const std::string& path) {
    const std::vector<double> flat = file.read<double>(path);
    Points rows(flat.size() / 3);
    for (std::size_t k = 0; k < rows.size(); ++k)
        rows[k] = {flat[3 * k], flat[3 * k + 1], flat[3 * k + 2]};
    return rows;
}

}  // namespace

std::vector<Response> body_responses(const BodyMotion& motion, const std::string& unit_system) {
    return Teller(motion, unit_system).tell();
}

std::vector<int> tracked_bodies(const Hdf5Reader& results) {
    std::vector<int> ids;
    if (!results.has("/history_fast/rigid_body")) return ids;
    for (const std::string& name : results.names("/history_fast/rigid_body"))
        ids.push_back(std::stoi(name));
    std::sort(ids.begin(), ids.end());
    return ids;
}

BodyMotion read_motion(const Hdf5Reader& results, int id) {
    const std::string of = fmt::format("/history_fast/rigid_body/{}/", id);
    const std::vector<double> time = results.read<double>("/history_fast/time");
    if (time.size() < 2)
        throw InputError(
            fmt::format("/history_fast holds {} rows, expected 2 or more: the run "
                        "has hardly begun",
                        time.size()));
    return {id,
            results.read<double>(of + "mass").at(0),
            time[1],
            points(results, of + "position"),
            points(results, of + "velocity"),
            points(results, of + "acceleration"),
            points(results, of + "force")};
}

}  // namespace corpuscle::io
