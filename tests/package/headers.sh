#!/usr/bin/env bash
# Compiles every header of the rooms and of tools by itself, without the build's precompiled ones: what it uses, it includes.
# External headers that many come to by their own includes are compiled once, in sets.
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
# shellcheck disable=SC2046,SC2086,SC2207
options=(-std=c++20 -O0 -w -I. "-I$build/places" "-I$build/tools" $(pkg-config --cflags eigen3 hdf5))
git ls-files 'solver/*.hpp' 'fabric/*.hpp' 'gas/*.hpp' 'contact/*.hpp' 'io/*.hpp' 'tools/*.hpp' | sort >"$work/left"
# Each header, and the external ones that it comes to by its own includes
comes_to() {
    xargs grep -HE '^#include ["<]' <"$work/left" | sed -E 's/:#include ["<](.*)[">].*/ \1/' | awk '
        { uses[$1] = uses[$1] " " $2 }
        function visit(header,   n, i, list) {
            if (header in seen) return
            seen[header] = 1
            if (!(header in uses)) { found = found " " header; return }
            n = split(uses[header], list, " ")
            for (i = 1; i <= n; i++) visit(list[i])
        }
        END { for (header in uses) { delete seen; found = ""; visit(header); print header found } }'
}
check() { xargs -P "$(nproc)" -I{} bash -c 'alone "$@"' alone "${options[@]}" "$@" {}; }
comes_to >"$work/external"
eigen='Eigen/Core Eigen/Geometry'
for set in "$eigen vector span string memory algorithm" "$eigen vector span string memory" "$eigen vector span string algorithm" \
    "$eigen vector span" "$eigen vector string" "$eigen vector" "$eigen" 'vector string algorithm' 'vector string' vector string; do
    begin=$work/${set//[ \/]/_}.hpp
    printf '#include <%s>\n' $set >"$begin"
    "$compiler" -x c++-header "${options[@]}" "$begin" -o "$begin.gch"
    awk -v set="$set" '
        BEGIN { n = split(set, wanted, " ") }
        NR == FNR { left[$1] = 1; next }
        $1 in left { all = 1; for (i = 1; i <= n; i++) all = all && index($0 " ", " " wanted[i] " "); if (all) print $1 }
        ' "$work/left" "$work/external" | sort >"$work/these"
    check -include "$begin" <"$work/these"
    comm -23 "$work/left" "$work/these" >"$work/others"
    mv "$work/others" "$work/left"
done
check <"$work/left"
