// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

/// Three flows that are neither waves nor at rest, and what is measured in them. Plane, between
/// mirrors. Units: c = sqrt(R T / M) of air at 300 K, and a length of the flow, L. Gases are
/// monatomic: air of 28 g/mol, helium of 4.
namespace corpuscle::dsmc {

/// By name.
using Findings = std::map<std::string, double>;

/// Air enters air at rest through a slot, 0 < y < slot of the end x = 0, with one speed v evenly in a cone,
/// and leaves through an outlet opposite. Within some mean free paths it comes to equilibrium at the density and
/// the temperature of the air at rest, with a speed u, at Mach 1.9:
///
///     momentum  u + T / u = v <cos²> / <cos>,   energy  u² / 2 + 5/2 T = v² / 2,   T = 1
struct SlotFlow {
    bool is_jet;
    double length, height, slot, outlet;  ///< [L]
    double from, end;                     ///< flow is averaged between                   [L / c]

    static constexpr double HALF_ANGLE = 45.0;  ///< [degrees]
    static constexpr double SPEED = 3.32022;    ///< v                                          [c]
    static constexpr double STREAM = 2.45435;   ///< u                                          [c]
};

/// The layer that begins at the slot's edge y = L, between a stream that crosses the box and gas at rest.
constexpr SlotFlow SHEAR_LAYER{false, 4.0, 3.0, 1.0, 1.0, 3.0, 6.0};
/// The jet of a slot of half the width L; the mirror y = 0 is its middle.
constexpr SlotFlow JET{true, 8.0, 5.0, 1.0, 2.0, 5.0, 8.0};

/// Mean flow over a grid of BINS by L.
class PlaneField {
public:
    static constexpr int BINS = 16;
    explicit PlaneField(const SlotFlow& flow);
    /// A sample begins. @param at_rest  particles of the plane before anything entered
    void begin(std::size_t at_rest);
    void add(double x, double y, double u);
    /// Thickness, y where u = U / 5 less y where u = 4 U / 5, at x = 1, 2, 3; U: mean over 0 < y < 1/2.
    [[nodiscard]] Findings layer() const;
    /// Speed on the middle line over that of the slot, where the mean flow has half of it (y), mass flux
    /// over that of the slot, at x = 2, 4, 6.
    [[nodiscard]] Findings jet() const;

private:
    struct Sums {
        double n = 0.0, nu = 0.0;
    };
    /// u by y, mean over 1/4 on both sides of x.
    [[nodiscard]] std::vector<Sums> profile(double x) const;
    [[nodiscard]] static double outermost(const std::vector<Sums>& rows, double u);

    int along_, across_;
    double at_rest_ = 0.0;  ///< particles of a bin, all samples together, had nothing entered
    std::vector<Sums> bins_;
};

/// Air in x < 4, helium in x > 4 of a box of 8 × 4 L at one pressure and 300 K; a plate between them is
/// open from time 0 on where y < slit.
struct SlitFlow {
    double slit;
    static constexpr double LENGTH = 8.0, HEIGHT = 4.0;
    static constexpr std::array<double, 2> TIMES{5.0, 10.0};  ///< [L / c]
    static constexpr double HELIUM_MASS = 4.0 / 28.0, HELIUM_DIAMETER = 2.2 / 3.7;
};
constexpr SlitFlow OPENING{1.0}, TUBE{SlitFlow::HEIGHT};

/// Share of each gas that has crossed at a time, by name: "helium, 5", "air, 5", ...
[[nodiscard]] Findings crossed(const std::array<double, 2>& air_helium, double time);

/// D of a tube from the share f that has crossed at t, for a step that spreads between closed ends:
///     f = 1/2 - 4 / pi² sum of exp(-k² pi² D t / LENGTH²) / k² over odd k
[[nodiscard]] double diffusivity(double share, double time);

/// By hard spheres. @param resolution  L over the mean free path of the air at rest
[[nodiscard]] Findings by_spheres(const SlotFlow&, double resolution, std::uint64_t seed);
[[nodiscard]] Findings by_spheres(const SlitFlow&, double resolution, std::uint64_t seed);

/// By a deck that the program runs, with default settings.
/// @param resolution  L over a cell's edge
/// @param options     of `corpuscle run` beside, for other settings
[[nodiscard]] Findings by_program(const SlotFlow&, double resolution, std::uint64_t seed,
                                  const std::string& options = "");
[[nodiscard]] Findings by_program(const SlitFlow&, double resolution, std::uint64_t seed,
                                  const std::string& options = "");

}  // namespace corpuscle::dsmc
