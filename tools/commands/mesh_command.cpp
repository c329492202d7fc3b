// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT

#include <fmt/core.h>

#include "io/mesh/deck_writer.hpp"
#include "io/mesh/mesh_file.hpp"
#include "tools/commands/commands.hpp"

namespace corpuscle::tools {

int mesh(const MeshArguments& arguments) {
    expect_no_input(arguments.output, {arguments.input});
    io::ImportedMesh mesh = io::read_mesh(arguments.input);
    const io::MeshReport report = io::check_mesh(mesh);
    io::write_deck(arguments.output, mesh, arguments.input);
    fmt::print("{}\n{}: {} nodes, {} shells, {} parts\n", io::text(report), arguments.output,
               mesh.x.size(), mesh.shells.size(), mesh.part_names.size());
    return 0;
}

}  // namespace corpuscle::tools
