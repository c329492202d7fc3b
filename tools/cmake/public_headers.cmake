# cmake -D FROM=<source> -D TO=<folder> -P public_headers.cmake: the headers that users may include, and those that they
# need, as TO/corpuscle/ROOM/...; "gas/x.hpp" in them becomes <corpuscle/gas/x.hpp>, "solver/base/x.hpp"
# <corpuscle/base/x.hpp>.

cmake_minimum_required(VERSION 3.25)

# The rooms' doors; what they include comes with them.
set(doors
    solver/base/constants.hpp solver/base/curve.hpp solver/base/error.hpp solver/base/parallel.hpp
    solver/base/random.hpp solver/base/surface.hpp solver/base/vec.hpp
    fabric/membranes.hpp fabric/mesh.hpp fabric/nodes.hpp
    contact/surface_contact.hpp contact/rigid_walls/rigid_wall.hpp
    gas/bag_gas.hpp gas/enclosure/chambers.hpp gas/particles.hpp gas/sensor.hpp gas/uniform_bag.hpp gas/thermo/control_volume.hpp gas/thermo/species.hpp
    solver/simulation.hpp
    io/results/checkpoint.hpp io/deck.hpp io/mesh/mesh_file.hpp io/results/results_file.hpp)

function(install_header header)
    get_property(seen GLOBAL PROPERTY seen)
    if(header IN_LIST seen)
        return()
    endif()
    set_property(GLOBAL APPEND PROPERTY seen ${header})
    file(READ ${FROM}/${header} text)
    string(REGEX MATCHALL "#include \"[^\"]+\"" includes "${text}")
    foreach(include ${includes})
        string(REGEX REPLACE "#include \"(.+)\"" "\\1" path ${include})
        install_header(${path})
        string(REGEX REPLACE "^solver/base/" "base/" public ${path})
        string(REPLACE "${include}" "#include <corpuscle/${public}>" text "${text}")
    endforeach()
    string(REGEX REPLACE "^solver/base/" "base/" public ${header})
    file(WRITE ${TO}/corpuscle/${public} "${text}")
endfunction()

file(REMOVE_RECURSE ${TO}/corpuscle)
foreach(door ${doors})
    install_header(${door})
endforeach()
