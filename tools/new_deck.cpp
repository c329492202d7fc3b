// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/new_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/mesh/deck_writer.hpp"

namespace corpuscle::tools {
namespace {

constexpr double FULL = 0.0774;          ///< V / A^(3/2) of two discs blown up
constexpr double TARGET = 40e3;          ///< gauge pressure                               [Pa]
constexpr double ATMOSPHERE = 101325.0;  ///< [Pa]
constexpr double T_GAS = 700.0;          ///< static temperature of the gas                [K]
constexpr double MOLAR_MASS = 0.0285, CP_A = 27.0, CP_B = 0.0056, R_GAS = 8.314462;
constexpr double PARTICLES_A_FACET = 10.0;

/// A number that fits ten columns with a blank before it.
std::string ten(double value) {
    std::string text = fmt::format("{:.6g}", value);
    for (int digits = 5; text.size() > 9; --digits) text = fmt::format("{:.{}g}", value, digits);
    return text;
}

/// 0 for what is rounding beside `size`.
double clean(double value, double size) {
    return std::abs(value) < 1e-9 * size ? 0.0 : value;
}

/// Numbers in SI and how the deck has them.
struct Units {
    double length, time;  ///< of one unit, SI

    [[nodiscard]] double pressure() const { return 1.0 / (length * time * time); }  // kg
    [[nodiscard]] std::string p(double pa) const { return ten(pa / pressure()); }
    [[nodiscard]] std::string t(double s) const { return ten(s / time); }
};

/// Gas that gives TARGET in the full volume, in kilograms:
///
///     p V / (g - 1) = m h(T) + p_atm V_0 / (g - 1) - p_atm (V - V_0)
double gas_mass(double full, double start) {
    const double cp = (CP_A + CP_B * T_GAS) / MOLAR_MASS, gas = R_GAS / MOLAR_MASS;
    const double gamma = cp / (cp - gas);
    const double h = (CP_A * T_GAS + 0.5 * CP_B * T_GAS * T_GAS) / MOLAR_MASS;
    const double energy = (ATMOSPHERE + TARGET) * full / (gamma - 1.0) -
                          ATMOSPHERE * start / (gamma - 1.0) + ATMOSPHERE * (full - start);
    return energy / h;
}

std::string parts_and_cloth(const NewDeck& bag, const Units& units) {
    std::string text;
    for (const int part : bag.parts)
        if (!bag.numbered_parts.contains(part))
            text +=
                fmt::format("*PART\npart {}\n$#     pid     secid       mid\n{:10d}{:10d}{:10d}\n",
                            part, part, 1, 1);
    std::set<int> numbers = bag.numbered_parts;
    if (numbers.size() < bag.parts.size() || numbers.empty()) numbers.insert(1);
    for (const int number : numbers)
        text += fmt::format(
            "*SECTION_SHELL_TITLE\nmembrane\n$#   secid    elform\n{:10d}         5\n"
            "$#      t1        t2        t3        t4\n  &THICK    &THICK    &THICK    &THICK\n"
            "*MAT_FABRIC_TITLE\n470 dtex polyamide\n"
            "$#     mid        ro        ea        eb                prba      prab\n"
            "{:10d}{:>10}    &EWARP    &EWARP       0.0       0.2       0.2\n"
            "$#     gab                           cse        el       prl    lratio      damp\n"
            "{:>10}       0.0       0.0         1       0.0       0.0       0.0      0.05\n"
            "$#    aopt       flc       fac       ela      lnrc      form     fvopt\n"
            "       0.0       0.0       0.0       0.0         0         0         0\n"
            "$#            rgbrth     a0ref        a1        a2        a3\n"
            "       0.0       0.0         0       0.0       0.0       0.0\n"
            "$#      v1        v2        v3                                    beta    isrefg\n"
            "       0.0       0.0       0.0       0.0       0.0       0.0       0.0         0\n",
            number, number, fmt::format("{:.3g}", 730.0 * std::pow(units.length, 3.0)),
            units.p(5e6));
    return text;
}

std::string part_set(int id, const char* title, const std::set<int>& parts) {
    std::string text = fmt::format("*SET_PART_LIST_TITLE\n{}\n{:10d}\n", title, id);
    int column = 0;
    for (const int part : parts) {
        text += fmt::format("{:10d}", part);
        if (++column % 8 == 0) text += "\n";
    }
    return text + (column % 8 == 0 ? "" : "\n");
}

std::string part_sets(const NewDeck& bag) {
    std::string text;
    if (!bag.has_part_set) text += part_set(bag.whole, "the whole bag", bag.parts);
    if (bag.tethers == 0) return text;
    std::set<int> closing = bag.parts;
    closing.erase(bag.tethers);
    return text + part_set(bag.closing, "what closes the bag", closing);
}

/// A rigid ball of 165 mm and 4.5 kg above the bag, that flies along -z. Its nodes are written with
/// the foremost point at the origin and put in place by a transformation.
std::string headform(const NewDeck& bag, const Units& units) {
    constexpr int ROUND = 16, RINGS = 8;
    constexpr double RADIUS = 0.0825, MASS = 4.5;
    const double r = RADIUS / units.length;
    const int first = bag.free_node + 1;
    std::string text = fmt::format(
        "$ ---------------------------------------------------------------------------- headform\n"
        "$ THINK: a ball of 165 mm and 4.5 kg; its speed, and how far above the bag it starts\n"
        "*PARAMETER\nR SPEED {:>12}\nR DIST  {:>12}\n*PARAMETER_EXPRESSION\n"
        "R ZS      DIST+({:.9g})\nR ZC      ZS+{:.9g}\nR VZ      -SPEED\nR IBALL   {:.9g}\n"
        "*DEFINE_TRANSFORMATION\n         1\nTRANSL{:>14}{:>10}       &ZS\n"
        "*NODE_TRANSFORM\n         1{:10d}\n*SET_NODE_GENERAL\n{:10d}\n"
        "PART      {:10d}\n*NODE\n",
        "5.0", fmt::format("{:.4g}", 0.2 / units.length), bag.top, r, 0.4 * MASS * r * r,
        ten(clean(bag.inflator.x(), r)), ten(clean(bag.inflator.y(), r)), bag.head, bag.head,
        bag.head);
    const auto node = [&](int id, const Vec3& x) {
        text += fmt::format("{:8d}{}{}{}\n", id, io::in_16_columns(x.x()), io::in_16_columns(x.y()),
                            io::in_16_columns(x.z()));
    };
    node(first, Vec3(0.0, 0.0, 0.0));
    node(first + 1, Vec3(0.0, 0.0, 2.0 * r));
    for (int i = 1; i < RINGS; ++i)
        for (int k = 0; k < ROUND; ++k) {
            const double a = std::numbers::pi * i / RINGS, b = 2.0 * std::numbers::pi * k / ROUND;
            node(first + 2 + (i - 1) * ROUND + k,
                 r * Vec3(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), 1.0 - std::cos(a)));
        }
    text += "*ELEMENT_SHELL\n";
    int shell = bag.free_shell;
    const auto ring = [&](int i, int k) { return first + 2 + (i - 1) * ROUND + k % ROUND; };
    for (int k = 0; k < ROUND; ++k) {
        text += fmt::format("{:8d}{:8d}{:8d}{:8d}{:8d}{:8d}\n", shell++, bag.head, first,
                            ring(1, k + 1), ring(1, k), ring(1, k));
        for (int i = 1; i + 1 < RINGS; ++i)
            text += fmt::format("{:8d}{:8d}{:8d}{:8d}{:8d}{:8d}\n", shell++, bag.head, ring(i, k),
                                ring(i, k + 1), ring(i + 1, k + 1), ring(i + 1, k));
        text += fmt::format("{:8d}{:8d}{:8d}{:8d}{:8d}{:8d}\n", shell++, bag.head, first + 1,
                            ring(RINGS - 1, k), ring(RINGS - 1, k + 1), ring(RINGS - 1, k + 1));
    }
    return text +
           fmt::format(
               "*PART_INERTIA\nheadform\n{0:10d}{0:10d}{0:10d}\n"
               "{1:>10}{2:>10}       &ZC       {3}         0         0\n"
               "    &IBALL       0.0       0.0    &IBALL       0.0    &IBALL\n"
               "       0.0       0.0       &VZ\n"
               "*SECTION_SHELL\n{0:10d}         9\n    &THICK    &THICK    &THICK    &THICK\n"
               "*MAT_RIGID\n{0:10d}{4:>10}{5:>10}       0.3\n       0.0\n       0.0\n"
               "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n         2bag on headform\n"
               "{7:10d}{0:10d}         2         3\n"
               "       0.3       0.3       0.0       0.0      20.0\n"
               "       1.0       1.0    &THICK    &THICK\n"
               "*DATABASE_RBDOUT\n{6:>10}\n",
               bag.head, ten(clean(bag.inflator.x(), r)), ten(clean(bag.inflator.y(), r)), MASS,
               fmt::format("{:.3g}", 1000.0 * std::pow(units.length, 3.0)), units.p(2e9),
               units.t(1e-4), bag.whole);
}

/// Title, parameters, control, output.
std::string head_of(const NewDeck& bag, const Units& units) {
    const double full = std::max(bag.volume * std::pow(units.length, 3.0),
                                 FULL * std::pow(bag.area * units.length * units.length, 1.5));
    const double mass = gas_mass(full, bag.volume * std::pow(units.length, 3.0));
    const auto particles = static_cast<long>(
        std::clamp(PARTICLES_A_FACET * static_cast<double>(bag.facets), 1e4, 2e5));
    const double thickness = 0.33e-3 / units.length;
    const std::string length = bag.is_mm ? "mm" : "m", time = bag.is_mm ? "ms" : "s",
                      pressure = bag.is_mm ? "GPa" : "Pa";
    return fmt::format(
        "*KEYWORD\n*TITLE\n{}\n"
        "$ A starting deck. Units: kg, {}, {}, K. What is marked THINK is a guess for this mesh.\n"
        "$ corpuscle check DECK.k says what it makes of them; -D NAME=VALUE changes one.\n"
        "*PARAMETER\n"
        "$ THINK: end time [{}]\nR ENDTIM{:>12}\n"
        "$ THINK: particles; 10 a facet, at least 10 000\nI NP    {:>12}\n"
        "$ THINK: gas that comes in [kg]: 40 kPa over the atmosphere in some {:.3g} l if none "
        "leaves\nR GAS   {:>12.4g}\n"
        "$ THINK: its static temperature [K]\nR TGAS  {:>12}\n"
        "$ THINK: cloth: thickness [{}], modulus [{}]\nR THICK {:>12.4g}\nR EWARP {:>12}\n"
        "$ THINK: discharge coefficient of the vents, where there are any\nR C23            0.7\n"
        "*INCLUDE\n{}\n"
        "*CONTROL_TERMINATION\n$#  endtim\n   &ENDTIM\n"
        "*CONTROL_TIMESTEP\n$#  dtinit    tssfac\n       0.0       0.9\n"
        "$ ------------------------------------------------------------------------------ output\n"
        "*DATABASE_ABSTAT\n{:>10}\n*DATABASE_GLSTAT\n{:>10}\n*DATABASE_BINARY_D3PLOT\n{:>10}\n"
        "$ ------------------------------------------------------------------------------- cloth\n",
        bag.title.substr(0, 70), length, time, time, units.t(0.04), particles, 1e3 * full, mass,
        T_GAS, length, pressure, thickness, units.p(3.5e8), bag.mesh, units.t(1e-4), units.t(1e-4),
        units.t(1e-3));
}

/// What holds the bag.
std::string supports(const NewDeck& bag) {
    std::string text;
    const auto stands = [&](bool is_there, const char* what, int set) {
        if (!is_there) return std::string();
        return fmt::format(
            "$ {} (node set {})\n*BOUNDARY_SPC_SET\n"
            "$#    nsid       cid      dofx      dofy      dofz\n"
            "{:10d}         0         1         1         1\n",
            what, set, set);
    };
    text += stands(bag.has_module, "The inflator's place stands still", 1);
    text += stands(bag.has_clamps, "What is clamped stands still", 3);
    if (!bag.held.empty()) {
        text += fmt::format("*SET_NODE_LIST_TITLE\nround the inflator\n{:10d}\n", bag.held_set);
        for (std::size_t k = 0; k < bag.held.size(); ++k)
            text += fmt::format("{:10d}{}", bag.held[k],
                                k % 8 == 7 || k + 1 == bag.held.size() ? "\n" : "");
        text += "$ THINK: what holds the bag\n" +
                stands(true, "The cloth round the inflator stands still", bag.held_set);
    }
    if (!bag.has_module && !bag.has_clamps && bag.held.empty())
        text += "$ THINK: nothing holds this bag. *SET_NODE_LIST and *BOUNDARY_SPC_SET do.\n";
    return text;
}

/// The bag touches itself; what its card of the gas begins with.
std::string contact_and_airbag(const NewDeck& bag, const Units& units) {
    std::string text;
    text += fmt::format(
        "*CONTACT_AIRBAG_SINGLE_SURFACE_ID\n$#     cid     title\n         1fabric on fabric\n"
        "$#   surfa     surfb  surfatyp  surfbtyp\n{:10d}         0         2         0\n"
        "$#      fs        fd        dc        vc       vdc\n"
        "       0.2       0.2       0.0       0.0      20.0\n"
        "$#    sfsa      sfsb      sast      sbst\n       1.0       1.0    &THICK    &THICK\n"
        "$ --------------------------------------------------------------------------------- gas\n"
        "$ THINK: where the gas comes in: a place inside, free of cloth\n"
        "*NODE\n{:8d}{}{}{}\n"
        "*AIRBAG_PARTICLE_ID\n$#      id     title\n         1bag\n"
        "$#    sid1    stype1      sid2    stype2     block\n"
        "{:10d}         1{:10d}         0         0\n"
        "$#      np      unit    visflg      tatm      patm     nvent      tend       tsw\n"
        "       &NP{:>10}         1     293.0{:>10}{:>10}   1.0E+10   1.0E+10\n"
        "$ Initial air, one gas, one orifice\n$#    iair      ngas     norif\n"
        "         1         1         1\n",
        bag.whole, bag.free_node, io::in_16_columns(bag.inflator.x()),
        io::in_16_columns(bag.inflator.y()), io::in_16_columns(bag.inflator.z()),
        bag.tethers != 0 ? bag.closing : bag.whole, bag.tethers, bag.is_mm ? 0 : 1,
        units.p(ATMOSPHERE), bag.has_vents ? 1 : 0);
    if (bag.has_vents)
        text +=
            "$ Vents: part set 2\n$#    sid3    stype3       c23    lctc23    lcpc23     enh_v\n"
            "         2         1      &C23         0         0         1\n";
    return text;
}

/// The gas that comes in.
std::string inflow(const NewDeck& bag, const Units& units) {
    return fmt::format(
        "$#    pair      tair     xmair      aair\n{:>10}     293.0   0.02897      29.1\n"
        "$ THINK: nitrogen and the like, Cp = 27 + 0.0056 T per mole\n"
        "$#     lcm       lct        xm         a         b         c      infg\n"
        "         1         2{:>10}{:>10}{:>10}       0.0         1\n"
        "$ THINK: into all directions; VD of a *DEFINE_VECTOR gives one, with a cone CA\n"
        "$#     nid        an        vd        ca      info\n"
        "{:10d}       1.0         0      30.0         1\n"
        "*DEFINE_CURVE_TITLE\nTHINK: mass flow, one in all, times GAS\n"
        "$#    lcid      sidr       sfa       sfo\n         1         0{:>10}     &MDOT\n"
        "                 0.0                 0.0\n                 0.2                 1.6\n"
        "                 0.5                 1.2\n                 1.0                 0.0\n"
        "*PARAMETER_EXPRESSION\nR MDOT    GAS/{}*{:.6f}\n"
        "*DEFINE_CURVE_TITLE\nstatic temperature\n         2         0       1.0     &TGAS\n"
        "                 0.0                 1.0\n{:>20}                 1.0\n",
        units.p(ATMOSPHERE), MOLAR_MASS, CP_A, CP_B, bag.free_node, units.t(0.03), units.t(0.03),
        1.0 / (0.5 * 0.2 * 1.6 + 0.3 * 1.4 + 0.5 * 0.5 * 1.2), units.t(1.0));
}

}  // namespace

std::string new_study(const NewDeck& bag, const std::string& deck) {
    return fmt::format(
        "# How hard the bag holds a head up, by its speed.\n"
        "#   corpuscle study THIS_FILE; corpuscle report THIS_FILE's folder\n"
        "deck = \"{}\"\nplan = \"full\"\nworkers = 1\n"
        "responses = [\"{}.peak_force\", \"max:/history/airbag/1/pressure\"]\n\n"
        "[factors]\n# THINK\nSPEED = [3.0, 5.0]\n",
        deck, bag.head);
}

std::string new_deck(const NewDeck& bag) {
    const Units units = bag.is_mm ? Units{1e-3, 1e-3} : Units{1.0, 1.0};
    std::string text = head_of(bag, units) + parts_and_cloth(bag, units) + part_sets(bag) +
                       supports(bag) + contact_and_airbag(bag, units) + inflow(bag, units);
    if (bag.head > 0) text += headform(bag, units);
    return text + "*END\n";
}

}  // namespace corpuscle::tools
