# Headers of others, compiled once for all rooms and once more, with Catch2, for the tests. A source includes what it uses
# all the same: the build with CORPUSCLE_PRECOMPILE=OFF and the test "package: each header stands alone" hold it to that.
option(CORPUSCLE_PRECOMPILE "Compile Eigen, fmt and the standard library once, not in every source" ON)

set(precompiled_headers
    <algorithm> <array> <cmath> <cstdint> <cstring> <filesystem> <fstream> <functional> <limits> <map> <memory> <numbers>
    <numeric> <optional> <random> <set> <span> <sstream> <string> <string_view> <tuple> <utility> <vector>
    <Eigen/Core> <Eigen/Eigenvalues> <Eigen/Geometry> <Random123/philox.h> <fmt/format.h>)

# NAME holds HEADERS, precompiled with the options of all rooms.
function(corpuscle_precompiled name)
    add_library(${name} OBJECT ${CMAKE_SOURCE_DIR}/tools/cmake/precompiled.cpp)
    target_link_libraries(${name} PRIVATE corpuscle::base corpuscle::warnings)
    target_precompile_headers(${name} PRIVATE ${ARGN})
endfunction()

# TARGET's sources begin with what FROM holds.
function(corpuscle_begin_with target from)
    target_precompile_headers(${target} REUSE_FROM ${from})
    # the preprocessed source names the header, for compiler caches; fmt is no system header to g++ 12 once precompiled, and
    # gives a false alarm
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess> $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>)
endfunction()

# Every target of FOLDER and below whose sources see corpuscle::base takes the rooms' headers, unless it has others.
function(corpuscle_precompile folder)
    get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
    foreach(target ${targets})
        get_target_property(kind ${target} TYPE)
        get_target_property(others ${target} PRECOMPILE_HEADERS_REUSE_FROM)
        get_target_property(own ${target} PRECOMPILE_HEADERS)
        get_target_property(libraries ${target} LINK_LIBRARIES)
        if(kind MATCHES "EXECUTABLE|STATIC|SHARED" AND NOT others AND NOT own AND libraries MATCHES "corpuscle::|sod")
            corpuscle_begin_with(${target} corpuscle_headers)
        endif()
    endforeach()
    get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
    foreach(below ${folders})
        corpuscle_precompile(${below})
    endforeach()
endfunction()

# Sources, joined: a build that nobody edits (tools/test, tools/run, packages) reads each header once for eight sources. Same bits.
# Names in unnamed namespaces are therefore unique in their library or program; the build by sanitizers and packages hold
# them to it.
option(CORPUSCLE_JOIN "Compile sources eight at a time" OFF)
if(CORPUSCLE_JOIN)
    set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)
endif()
function(corpuscle_join)
    foreach(target ${ARGN})
        if(TARGET ${target})
            set_target_properties(${target} PROPERTIES UNITY_BUILD ${CORPUSCLE_JOIN})
        endif()
    endforeach()
endfunction()
