// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/deck/deck_words.hpp"

namespace corpuscle::io {
namespace {

std::string_view word_of_material(Property property) {
    switch (property) {
        case Property::DENSITY:
            return "RO";
        case Property::WARP_MODULUS:
            return "EA";
        case Property::WEFT_MODULUS:
            return "EB";
        case Property::SHEAR_MODULUS:
            return "GAB";
        case Property::MODULUS:
            return "E";
        case Property::POISSON_RATIO:
            return "PR";
        case Property::CROSS_POISSON_RATIO:
            return "PRBA";
        case Property::DAMPING:
            return "DAMP";
        case Property::LINER_MODULUS:
            return "EL";
        case Property::LINER_RATIO:
            return "LRATIO";
        case Property::LINER_POISSON_RATIO:
            return "PRL";
        case Property::COAT_MODULUS:
            return "ECOAT";
        case Property::COAT_THICKNESS:
            return "TCOAT";
        case Property::THICKNESS:
            return "T1";
        case Property::STRESS_CURVE:
            return "LCA, LCB, LCAB";
        case Property::UNLOADING_CURVE:
            return "LCUA, LCUB, LCUAB";
        case Property::REFERENCE_RESTORATION:
            return "TSRFAC";
        default:
            return {};
    }
}

std::string_view word_of_bag(Property property, std::string_view of) {
    switch (property) {
        case Property::CLOSING_WALL:
            return of.starts_with("*AIRBAG_PARTICLE") ? "SID1" : "SID";
        case Property::VENT_WALL:
            return "SID3";
        case Property::VENT_COEFFICIENT:
            return "C23";
        case Property::VENT_LAW:
            return "ENH_V";
        case Property::ORIFICE_PLACE:
            return "NID";
        case Property::ORIFICE_AREA:
            return "AN";
        case Property::CONE_ANGLE:
            return "CA in radians";
        case Property::PARTICLE_NUMBER:
            return "NP";
        case Property::HOLE_SHARE:
            return "share of the bag's area (-D CLOSE=SHARE)";
        case Property::POROSITY:
            return "X0 to X3";
        case Property::INITIAL_AIR:
            return "IAIR";
        case Property::START_VOLUME:
            return "VSCA V - VINI";
        case Property::START_STATE:
            return "PE, RO";
        default:
            return {};
    }
}

}  // namespace

std::string_view deck_word(Property property, std::string_view of) {
    if (property == Property::MASS_SCALED_STEP) return "DT2MS";
    return of.starts_with("*AIRBAG_") ? word_of_bag(property, of) : word_of_material(property);
}

}  // namespace corpuscle::io
