#!/usr/bin/env bash
# Compiles every header of the rooms and of tools by itself, without the precompiled ones: what it uses, it includes. Eigen alone is
# compiled once, for those that come to it by their own includes.
# By clang++ where it is installed, which reads faster than g++.
# usage: headers.sh BUILD   (CXX: the compiler, where there is no clang++)
set -euo pipefail
build=${1:?the build folder}
cd "$(dirname "$0")/../.."
if ! git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
    echo "headers: no git here to list the sources"
    exit 77
fi
compiler=$(command -v clang++ || echo "${CXX:-c++}")
alone() {
    if ! "$compiler" -fsyntax-only -x c++ "$@" >/dev/null 2>&1; then
        echo "headers: ${!#} needs a header that it does not include"
        return 1
    fi
}
export -f alone
export compiler
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# shellcheck disable=SC2046,SC2207
options=(-std=c++20 -O0 -w -I. "-I$build/places" "-I$build/tools" $(pkg-config --cflags eigen3 hdf5))
git ls-files 'solver/*.hpp' 'fabric/*.hpp' 'gas/*.hpp' 'contact/*.hpp' 'io/*.hpp' 'tools/*.hpp' | sort >"$work/left"
# Those that come to an external header by their own includes
come_to() {
    xargs grep -E '^#include ["<]' <"$work/left" | sed -E 's/:#include ["<](.*)[">].*/ \1/' | awk -v name="$1" '
        { uses[$1] = uses[$1] " " $2 }
        function comes(header,   n, i, list) {
            if (header == name) return 1
            if (header in known) return known[header]
            known[header] = 0
            n = split(uses[header], list, " ")
            for (i = 1; i <= n; i++) if (comes(list[i])) return known[header] = 1
            return 0
        }
        END { for (header in uses) if (comes(header)) print header }' | sort
}
check() { xargs -P "$(nproc)" -I{} bash -c 'alone "$@"' alone "${options[@]}" "$@" {}; }
for external in Eigen/Geometry Eigen/Core; do
    begin=$work/${external#*/}.hpp
    echo "#include <$external>" >"$begin"
    "$compiler" -x c++-header "${options[@]}" "$begin" -o "$begin.gch"
    come_to $external >"$work/these"
    check -include "$begin" <"$work/these"
    comm -23 "$work/left" "$work/these" >"$work/others"
    mv "$work/others" "$work/left"
done
check <"$work/left"
