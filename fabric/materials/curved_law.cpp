// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "fabric/materials/curved_law.hpp"

namespace corpuscle::fabric {

namespace {

Below below(const FabricCard& c, std::size_t which) {
    if (which == 2) return Below::MIRRORED;
    return c.no_compression ? Below::NOTHING : Below::STRAIGHT;
}

LoadingLoop loop(const FabricCard& c, std::span<const Curve> curves, std::size_t which) {
    const double modulus = which == 0 ? c.E_warp : which == 1 ? c.E_weft : c.G;
    const Index load = c.curves.load[which], unload = c.curves.unload[which];
    StressCurve loading =
        load < 0 ? StressCurve(modulus, below(c, which))
                 : StressCurve(curves[static_cast<std::size_t>(load)], below(c, which));
    if (unload < 0) return LoadingLoop(std::move(loading));
    return {std::move(loading), curves[static_cast<std::size_t>(unload)], c.curves.reload};
}

}  // namespace

std::vector<CurveFault> curve_faults(const FabricCard& card, std::span<const Curve> curves) {
    std::vector<CurveFault> faults;
    for (std::size_t which = 0; which < 3; ++which) {
        const std::size_t before = faults.size();
        const auto check = [&](Index row, bool unloads, Below at) {
            if (row < 0) return;
            if (std::string fault = loading_fault(curves[static_cast<std::size_t>(row)], at);
                !fault.empty())
                faults.push_back({which, unloads, std::move(fault)});
        };
        check(card.curves.load[which], false, below(card, which));
        check(card.curves.unload[which], true, below(card, which));
        if (faults.size() > before || card.curves.unload[which] < 0) continue;
        if (std::string fault = loop(card, curves, which).fault(); !fault.empty())
            faults.push_back({which, true, std::move(fault)});
    }
    return faults;
}

Law curved_law(const FabricCard& card, std::span<const Curve> curves, const PlaneModuli& layers) {
    YarnLoops loops{loop(card, curves, 0), loop(card, curves, 1), loop(card, curves, 2)};
    const YarnMeasure measure = card.form == 14 ? YarnMeasure::ENGINEERING : YarnMeasure::GREEN;
    if (loops.warp.remembers() || loops.weft.remembers() || loops.shear.remembers())
        return Looped(std::move(loops), measure, layers);
    return Curved(std::move(loops), measure, layers);
}

}  // namespace corpuscle::fabric
