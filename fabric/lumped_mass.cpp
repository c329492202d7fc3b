// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "fabric/materials/law.hpp"
#include "fabric/membrane_setup.hpp"
#include "fabric/reference_shape.hpp"

namespace corpuscle::fabric {

std::vector<double> shell_mass(const MembraneSetup& setup) {
    std::vector<double> mass(setup.shells.size());
    for (std::size_t e = 0; e < mass.size(); ++e) {
        const Shell& shell = setup.shells[e];
        const Part& part = setup.parts[static_cast<std::size_t>(shell.part)];
        const Material& material = setup.materials[static_cast<std::size_t>(part.material)];
        mass[e] =
            density(material.card) * part.thickness * reference_area(shell, setup.reference[e]);
    }
    return mass;
}

std::vector<double> lumped_mass(const MembraneSetup& setup) {
    const std::vector<double> shells = shell_mass(setup);
    std::vector<double> nodes(setup.node_count, 0.0);
    for (std::size_t e = 0; e < shells.size(); ++e) {
        const ReferenceShape corners = distinct_corners(setup.shells[e]);
        for (int i = 0; i < corners.corners; ++i) {
            const auto place =
                static_cast<std::size_t>(corners.corner[static_cast<std::size_t>(i)]);
            nodes[static_cast<std::size_t>(setup.shells[e].nodes[place])] +=
                shells[e] / corners.corners;
        }
    }
    return nodes;
}

}  // namespace corpuscle::fabric
