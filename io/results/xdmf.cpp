// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/results/xdmf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace corpuscle::io {
namespace {

constexpr int TRIANGLE = 4, QUAD = 5;  // XDMF's codes of cells in a mixed topology

/// How an array lies in results.h5. Dimensions must have the dataset's very rank: readers refuse
/// others.
struct Array {
    std::string path;
    std::string dimensions;
    std::string_view type;  ///< Float, Int, UChar
    int bytes;
};

std::string item(const Array& a) {
    return fmt::format(
        R"(<DataItem Format="HDF" Dimensions="{}" NumberType="{}" Precision="{}">results.h5:{}</DataItem>)",
        a.dimensions, a.type, a.bytes, a.path);
}

std::string attribute(std::string_view name, std::string_view kind, std::string_view centre,
                      const Array& a) {
    return fmt::format(
        R"(          <Attribute Name="{}" AttributeType="{}" Center="{}">{}</Attribute>)"
        "\n",
        name, kind, centre, item(a));
}

std::string rows(std::uint64_t n) {
    return fmt::format("{}", n);
}
std::string rows_of_3(std::uint64_t n) {
    return fmt::format("{} 3", n);
}

std::string bag(const XdmfScene& scene, double time, const std::string& frame) {
    const std::uint64_t n = scene.nodes, e = scene.shells;
    std::string text = fmt::format(
        R"(        <Grid Name="bag" GridType="Uniform">
          <Time Value="{:.17g}"/>
          <Topology TopologyType="Mixed" NumberOfElements="{}">{}</Topology>
          <Geometry GeometryType="XYZ">{}</Geometry>
)",
        time, e, item({"/mesh/xdmf_topology", rows(scene.topology_size), "Int", 4}),
        item({frame + "coordinates", rows_of_3(n), "Float", 8}));
    text += attribute("velocity", "Vector", "Node", {frame + "velocity", rows_of_3(n), "Float", 4});
    text += attribute("part", "Scalar", "Cell", {"/mesh/shell_part", rows(e), "Int", 4});
    text +=
        attribute("pressure", "Scalar", "Cell", {frame + "shell_pressure", rows(e), "Float", 4});
    if (scene.has_contact)
        text += attribute("contact_pressure", "Scalar", "Cell",
                          {frame + "shell_contact_pressure", rows(e), "Float", 4});
    text +=
        attribute("stress", "Vector", "Cell", {frame + "shell_stress", rows_of_3(e), "Float", 4});
    text +=
        attribute("strain", "Vector", "Cell", {frame + "shell_strain", rows_of_3(e), "Float", 4});
    text += attribute("active", "Scalar", "Cell", {frame + "shell_active", rows(e), "UChar", 1});
    return text + "        </Grid>\n";
}

/// Vertices need their numbers spelt out: one common reader shows nothing without them.
std::string gas(std::uint64_t p, double time, const std::string& frame) {
    const std::string at = frame + "particles/";
    std::string text = fmt::format(
        R"(        <Grid Name="gas" GridType="Uniform">
          <Time Value="{:.17g}"/>
          <Topology TopologyType="Polyvertex" NumberOfElements="{}" NodesPerElement="1">{}</Topology>
          <Geometry GeometryType="XYZ">{}</Geometry>
)",
        time, p, item({at + "xdmf_index", rows(p), "Int", 4}),
        item({at + "position", rows_of_3(p), "Float", 8}));
    text += attribute("velocity", "Vector", "Node", {at + "velocity", rows_of_3(p), "Float", 4});
    text += attribute("id", "Scalar", "Node", {at + "id", rows(p), "Int", 8});
    text += attribute("species", "Scalar", "Node", {at + "species", rows(p), "Int", 4});
    text += attribute("internal_energy", "Scalar", "Node",
                      {at + "internal_energy", rows(p), "Float", 8});
    text += attribute("mass", "Scalar", "Node", {at + "mass", rows(p), "Float", 8});
    text += attribute("temperature", "Scalar", "Node", {at + "temperature", rows(p), "Float", 4});
    return text + "        </Grid>\n";
}

}  // namespace

std::vector<std::int32_t> xdmf_topology(std::span<const std::array<Index, 4>> shells) {
    std::vector<std::int32_t> codes;
    codes.reserve(5 * shells.size());
    for (const auto& nodes : shells) {
        const bool is_triangle = nodes[2] == nodes[3];
        codes.push_back(is_triangle ? TRIANGLE : QUAD);
        codes.insert(codes.end(), nodes.begin(), nodes.end() - (is_triangle ? 1 : 0));
    }
    return codes;
}

std::string frame_name(std::size_t frame) {
    return fmt::format("{:05}", frame);
}

namespace {

/// A block over time: one reader of ParaView calls grids of one name "bag", "bag[1]", ..., so each
/// block is a collection of its own, whose name stays.
template <class Write>
std::string over_time(std::string_view name, const XdmfScene& scene, Write&& write) {
    std::string text =
        fmt::format(R"(    <Grid Name="{}" GridType="Collection" CollectionType="Temporal">)"
                    "\n",
                    name);
    for (std::size_t i = 0; i < scene.states.size(); ++i)
        text += write(scene.states[i], fmt::format("/frames/{}/", frame_name(i)));
    return text + "    </Grid>\n";
}

}  // namespace

std::string xdmf_text(const XdmfScene& scene) {
    std::string text = R"(<?xml version="1.0" ?>
<!DOCTYPE Xdmf SYSTEM "Xdmf.dtd" []>
<Xdmf Version="2.0">
  <Domain>
)";
    const auto has_gas = [](const XdmfScene::State& state) {
        return state.particles.value_or(0) > 0;
    };
    if (scene.shells > 0)
        text += over_time("bag", scene, [&](const XdmfScene::State& state, const std::string& at) {
            return bag(scene, state.time, at);
        });
    if (std::any_of(scene.states.begin(), scene.states.end(), has_gas))
        text += over_time("gas", scene, [&](const XdmfScene::State& state, const std::string& at) {
            return has_gas(state) ? gas(*state.particles, state.time, at) : std::string();
        });
    return text + "  </Domain>\n</Xdmf>\n";
}

}  // namespace corpuscle::io
