#!/usr/bin/env bash
# Fabric, contact and gas each by itself: configured in a tree that holds nothing of the other two, of the solver or of io
# (gas takes contact's broad phase along), their programs would be made by the same commands as in BUILD, and all that those
# commands read in BUILD lies in that tree. What runs in BUILD is therefore what would run alone; its tests run there.
# usage: rooms_alone.sh BUILD
set -euo pipefail
build=${1:?the build folder}
cd "$(dirname "$0")/../.."
if ! git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
    echo "rooms alone: no git here to list the sources"
    exit 77
fi
root=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
shared=(CMakeLists.txt CMakePresets.json tools/cmake solver/base contact/broad_phase contact/geometry/box.hpp contact/surface/patches.?pp
    tests/CMakeLists.txt tests/places.hpp.in tests/support tests/unit/solver/base tests/benchmark/loop_meter.?pp)
# The options of BUILD, but for its rooms
mapfile -t options < <(sed -nE 's/^((CORPUSCLE_|CMAKE_BUILD_TYPE|CMAKE_CXX_FLAGS|CMAKE_CXX_COMPILER(_LAUNCHER)?:)[^ ]*=.*)/-D\1/p' \
    "$build/CMakeCache.txt" | grep -v '^-DCORPUSCLE_ROOMS')
# What makes PROGRAM in FOLDER of the tree at ROOT, one command a line
commands() { # ROOT FOLDER PROGRAM
    ninja -C "$2" -t commands "$3" | sed -E "s:$2:BUILD:g; s:$1:ROOT:g; s/tests-[0-9a-f]+\.cmake/tests.cmake/" | sort
}
alone() { # ROOM PROGRAM ...
    local tree=$work/$1
    mkdir "$tree"
    git ls-files -z "${shared[@]}" "$1" "tests/unit/$1" | xargs -0 cp --parents -t "$tree"
    cmake -S "$tree" -G Ninja -B "$tree/build" "${options[@]}" -DCORPUSCLE_ROOMS="$1" >"$work/log" 2>&1 ||
        { cat "$work/log"; echo "$1 alone: not configured"; exit 1; }
    for program in "${@:2}"; do
        comm -23 <(commands "$tree" "$tree/build" "$program") <(commands "$root" "$build" "$program") >"$work/log"
        [ ! -s "$work/log" ] || { head -5 "$work/log"; echo "$1 alone: $program is made by other commands"; exit 1; }
        mapfile -t objects < <(ninja -C "$tree/build" -t inputs "$program" | grep '\.o$')
        ninja -C "$build" -t deps "${objects[@]}" >"$work/deps"
        [ "$(grep -c '#deps' "$work/deps")" = ${#objects[@]} ] || { echo "$1 alone: $program is not built"; exit 1; }
        awk '/^ / { print $1 }' "$work/deps" | (cd "$build" && sort -u | xargs realpath -s) | sed -n "s:^$root/::p" | grep -v "^${build#"$root/"}/" >"$work/read"
        while read -r file; do
            [ -e "$tree/$file" ] || { echo "$1 alone: $program needs $file"; exit 1; }
        done <"$work/read"
        echo "$1 alone: $program: ${#objects[@]} objects of $(wc -l <"$work/read") sources"
    done
}
alone fabric unit_fabric
alone contact unit_contact
alone gas test_gas test_flight
