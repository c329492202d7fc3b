#!/usr/bin/env bash
# Compiles every header by itself, without the precompiled ones: what it uses, it includes.
# usage: headers.sh BUILD   (CXX: the compiler)
set -euo pipefail
build=${1:?the build folder}
cd "$(dirname "$0")/../.."
if ! git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
    echo "headers: no git here to list the sources"
    exit 77
fi
alone() {
    if ! "${CXX:-c++}" -fsyntax-only -x c++ "$@" >/dev/null 2>&1; then
        echo "headers: ${!#} needs a header that it does not include"
        return 1
    fi
}
export -f alone
# shellcheck disable=SC2046
options=(-std=c++20 -O0 -w -fopenmp -I. "-I$build/places" "-I$build/tools" $(pkg-config --cflags eigen3 hdf5))
git ls-files 'solver/*.hpp' 'fabric/*.hpp' 'gas/*.hpp' 'contact/*.hpp' 'io/*.hpp' 'tools/*.hpp' 'tests/*.hpp' |
    xargs -P "$(nproc)" -I{} bash -c 'alone "$@"' alone "${options[@]}" {}
