// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/surface_contact.hpp"

#include <algorithm>
#include <cmath>

#include "contact/response/ccd_limiter.hpp"
#include "contact/response/facet_load.hpp"
#include "contact/response/implicit_response.hpp"
#include "contact/response/narrow_phase.hpp"
#include "contact/response/stopping_impulses.hpp"

namespace corpuscle::contact {
namespace {

/// Gap, in contact thicknesses, below which pairs are looked at in every step and remember their
/// sides.
constexpr double REACH = 1.2;

constexpr std::size_t CHUNKS = 4;  ///< of contacts, whose counts are taken together

}  // namespace

struct SurfaceContact::State {
    Cloth cloth;
    Candidates pairs;
    std::vector<ImpulseBooks> books;  ///< by card
    ImplicitResponse response;
    StoppingImpulses stops;
    CcdLimiter ccd;
    FacetLoad load;
    ContactList contacts;
    ColumnColouring columns;
    NarrowPhase narrow_phase;
    ContactCounts counts;
    std::vector<double> most;         ///< contact thickness now, by card                  [m]
    std::vector<std::uint8_t> is_on;  ///< by card
    double t = 0.0, dt_last = 0.0, span = 0.0;  ///< [s]
    bool is_started = false;

    explicit State(const ContactSetup& setup)
        : cloth(setup),
          pairs(cloth, REACH),
          books(setup.cards.size()),
          response(cloth),
          stops(cloth, books),
          ccd(cloth),
          load(cloth),
          columns(cloth),
          narrow_phase(cloth, REACH),
          most(setup.cards.size()),
          is_on(setup.cards.size(), 0) {}

    template <class Archive>
    void visit_state(Archive& archive) {
        archive(pairs, books, response, ccd, load, contacts, counts, most, is_on, t, dt_last, span,
                is_started);
    }
    bool look_at_cards(double now);
    void count();
    [[nodiscard]] bool any_on() const {
        return std::any_of(is_on.begin(), is_on.end(), [](std::uint8_t on) { return on != 0; });
    }
};

SurfaceContact::SurfaceContact(const ContactSetup& setup)
    : state_(std::make_unique<State>(setup)) {}
SurfaceContact::~SurfaceContact() = default;
SurfaceContact::SurfaceContact(SurfaceContact&&) noexcept = default;
SurfaceContact& SurfaceContact::operator=(SurfaceContact&&) noexcept = default;

/// Which cards are on now, and how thick. Returns whether one has begun to hold for a pair of parts.
bool SurfaceContact::State::look_at_cards(double now) {
    t = now;
    for (std::size_t c = 0; c < is_on.size(); ++c) {
        const int card = static_cast<int>(c);
        is_on[c] = !cloth.triangles.empty() && cloth.rules.is_on(card, t);
        most[c] = is_on[c] ? cloth.rules.most(card, t) : 0.0;
    }
    return cloth.rules.choose(is_on);
}

void SurfaceContact::find(const Points& x, const Points& v, double t, double dt,
                          std::span<const RigidProxy> bodies) {
    State& s = *state_;
    const bool is_other = s.look_at_cards(t);
    if (!s.any_on()) {
        return s.contacts.lay_out(0);
    }
    if (!s.is_started) {
        s.is_started = true;
        s.pairs.start(x, v, t, dt);
    } else {
        s.pairs.follow(x, t, dt);
        if (is_other) s.pairs.admit(x, v, t, dt);
    }
    s.counts.close_starts = s.pairs.close_starts().size();
    if (s.pairs.size() > 0) {
        s.columns.lay(x);
        s.narrow_phase.find({x, v, t, dt, bodies, s.is_on, s.most}, s.columns, s.pairs, s.contacts);
    } else {
        s.contacts.lay_out(0);
    }
    s.count();
}

void SurfaceContact::State::count() {
    counts.builds = pairs.builds();
    counts.renewals = pairs.renewals();
    counts.searched = pairs.searched();
    counts.candidates = pairs.pairs();
    counts.impacts = ccd.impacts();
    counts.impact_zones = ccd.impact_zones();
    counts.unstopped = ccd.unstopped();
    const auto& solved = response.convergence();
    if (solved.steps > 0) {
        counts.residual = solved.sum / static_cast<double>(solved.steps);
        counts.sweeps = static_cast<double>(solved.sweeps) / static_cast<double>(solved.steps);
    }
    counts.worst_residual = solved.worst;
    struct Tally {
        double least = INF;  ///< gap over its rest value                                     [-]
        std::size_t touching = 0, near = 0;
    };
    const Tally all = parallel::fold(
        contacts.chunks(), Tally{},
        [&](Tally& own, std::size_t c) {
            for (const Contact& touching : contacts.chunk(c))
                own.least = std::min(own.least, touching.gap / touching.rest);
            for (const NearPair& near : contacts.near(c)) {
                if (near.rest > 0.0) own.least = std::min(own.least, near.gap / near.rest);
                (near.gap < near.rest ? own.touching : own.near) += 1;
            }
            own.touching += contacts.chunk(c).size();
        },
        [](Tally& sum, const Tally& own) {
            sum.least = std::min(sum.least, own.least);
            sum.touching += own.touching;
            sum.near += own.near;
        },
        CHUNKS);
    counts.touching = all.touching;
    counts.near = all.touching + all.near;
    counts.least_gap = std::min(counts.least_gap, all.least);
}

bool SurfaceContact::respond(const Points& x, double dt, Points& v, std::span<RigidProxy> bodies,
                             Points* v_before, const Hold& hold, const Points* unkicked) {
    State& s = *state_;
    s.span = 0.5 * (s.dt_last + dt);
    s.dt_last = dt;
    s.load.pass(s.span);
    if (!s.any_on()) return false;
    VelocityState motion(s.cloth, x, v, bodies, v_before, unkicked);
    if (s.counts.near > 0) motion.begin();
    s.response.apply(s.span, dt, s.contacts, s.columns, s.pairs, motion, s.books, hold);
    s.columns.for_each(s.contacts, [&](const Contact& c) { s.load.add(c); });
    s.ccd.stop(s.t, dt, s.pairs, s.stops, s.load, motion);
    motion.settle();
    return motion.has_begun();
}

const std::vector<std::pair<Index, Index>>& SurfaceContact::crossing() const {
    return state_->pairs.crossing();
}
const std::vector<std::pair<Index, Index>>& SurfaceContact::close_starts() const {
    return state_->pairs.close_starts();
}
double SurfaceContact::stored_energy() const {
    return contact::stored_energy(state_->contacts);
}
double SurfaceContact::friction_energy() const {
    double energy = 0.0;
    for (const ImpulseBooks& book : state_->books) energy += book.friction;
    return energy;
}
double SurfaceContact::friction_work(const Points& v_mid) const {
    return state_->contacts.sum([&](const Contact& c) {
        return c.rubbed.isZero(0.0) ? 0.0 : -c.rubbed.dot(c.relative(v_mid));
    });
}
double SurfaceContact::damping_energy() const {
    double energy = 0.0;
    for (const ImpulseBooks& book : state_->books) energy += book.normal;
    return energy - stored_energy();
}
double SurfaceContact::held_work() const {
    double work = 0.0;
    for (const ImpulseBooks& book : state_->books) work += book.held_work;
    return work;
}
Vec3 SurfaceContact::force(int card) const {
    if (state_->is_on[static_cast<std::size_t>(card)] == 0) return Vec3::Zero();
    const Vec3& given = state_->books[static_cast<std::size_t>(card)].given;
    return state_->span > 0.0 ? Vec3(given / state_->span) : given;
}
double SurfaceContact::energy_of(int card) const {
    const ImpulseBooks& book = state_->books[static_cast<std::size_t>(card)];
    return book.friction + book.normal;
}
SurfaceContact::Depth SurfaceContact::depth(int card) const {
    Depth now;
    const auto take = [&](const auto& c) {
        if (c.card != card || c.gap >= c.rest) return;
        ++now.pairs;
        now.greatest = std::max(now.greatest, 1.0 - c.gap / c.rest);
    };
    const ContactList& contacts = state_->contacts;
    for (std::size_t chunk = 0; chunk < contacts.chunks(); ++chunk) {
        std::for_each(contacts.chunk(chunk).begin(), contacts.chunk(chunk).end(), take);
        std::for_each(contacts.near(chunk).begin(), contacts.near(chunk).end(), take);
    }
    return now;
}
std::vector<double> SurfaceContact::take_facet_forces(const Points& x) {
    std::vector<double> forces = state_->load.forces(x);
    state_->load.clear();
    return forces;
}
void SurfaceContact::mark_touching(std::span<std::uint8_t> nodes) const {
    state_->contacts.for_each([&](const Contact& c) {
        if (c.gap >= c.rest) return;
        for (int i = 0; i < 4; ++i)
            if (std::abs(c.weight[i]) > 0.5) nodes[c.node[i]] = 1;
    });
}
void SurfaceContact::visit_state(StateWriter& archive) {
    archive(*state_);
}
void SurfaceContact::visit_state(StateReader& archive) {
    archive(*state_);
    state_->cloth.rules.choose(state_->is_on);
}
const ContactCounts& SurfaceContact::counts() const {
    return state_->counts;
}

}  // namespace corpuscle::contact
