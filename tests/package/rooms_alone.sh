#!/usr/bin/env bash
# Fabric, contact and gas each by itself: configured, compiled (joined, as tools/run does) and their unit tests run in a
# tree that holds nothing of the other two, of the solver or of io. Gas takes contact's broad phase along.
# usage: rooms_alone.sh BUILD [COMPILER_LAUNCHER]   (CXX: the compiler)
set -euo pipefail
launcher=${2:-}
cd "$(dirname "$0")/../.."
if ! git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
    echo "rooms alone: no git here to list the sources"
    exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
shared=(CMakeLists.txt CMakePresets.json tools/cmake solver/base contact/broad_phase contact/geometry/box.hpp contact/surface/patches.?pp
    tests/CMakeLists.txt tests/places.hpp.in tests/support tests/unit/solver/base tests/benchmark/loop_meter.?pp)
alone() { # ROOM PROGRAM ...
    local tree=$work/$1
    mkdir "$tree"
    git ls-files -z "${shared[@]}" "$1" "tests/unit/$1" | xargs -0 cp --parents -t "$tree"
    cmake -S "$tree" --preset release -B "$tree/build" -DCORPUSCLE_ROOMS="$1" -DCORPUSCLE_JOIN=ON \
        ${launcher:+-DCMAKE_CXX_COMPILER_LAUNCHER=$launcher} >"$work/log" 2>&1 || { cat "$work/log"; echo "$1 alone: not configured"; exit 1; }
    cmake --build "$tree/build" --target "${@:2}" >"$work/log" 2>&1 || { cat "$work/log"; echo "$1 alone: not built"; exit 1; }
    for program in "${@:2}"; do
        OMP_WAIT_POLICY=passive "$tree/build/bin/$program" >"$work/log" 2>&1 || { cat "$work/log"; echo "$1 alone: $program"; exit 1; }
        echo "$1 alone: $program: $(grep -E 'passed' "$work/log")"
    done
}
alone fabric unit_fabric
alone contact unit_contact
alone gas test_gas test_flight
