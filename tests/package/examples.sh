#!/usr/bin/env bash
# Installs the libraries of a build, builds examples/ on them by find_package and one by pkg-config, runs them, and
# holds what they print to what they must. --prefix: on libraries that are installed already, as in /usr.
# usage: examples.sh BUILD [COMPILER_LAUNCHER] | examples.sh --prefix PREFIX
set -euo pipefail
work=$(mktemp -d)
launcher="" prefix=$work/usr
if [ "$1" = --prefix ]; then prefix=$2; else launcher=${2:-}; fi
trap 'rm -rf "$work"' EXIT
fail() { echo "examples: $*" >&2; exit 1; }
# close FILE 'fields' TOLERANCE: in each line of the awk expression two numbers that agree
close() {
    awk -v tolerance="$3" "$2"' { n++; d = a / b - 1; if (d < 0) d = -d; if (!(d <= tolerance)) { print "  " $0; bad = 1 } }
        END { exit bad || !n }' "$1" || fail "$1: expected agreement to $3"
}

[ "$1" = --prefix ] || cmake --install "$1" --prefix "$prefix" --component library >/dev/null
grep -rnE '#include "|#include <(solver|gas|fabric|contact|io)/' "$prefix/include/corpuscle" &&
    fail "an installed header includes what is not under corpuscle/"
cmake -S examples -B "$work/build" -G Ninja -DCMAKE_PREFIX_PATH="$prefix" \
    ${launcher:+-DCMAKE_CXX_COMPILER_LAUNCHER=$launcher} >"$work/log" 2>&1 || { cat "$work/log"; fail "not configured"; }
cmake --build "$work/build" -j2 >"$work/log" 2>&1 || { cat "$work/log"; fail "not built"; }
! grep -qE -- '-march|-mavx|-ffp-contract|-fno-' "$work/build/build.ninja" || fail "flags are forced on users"

cd "$work"
for example in membrane_under_pressure gas_in_a_box falling_cloth own_law; do
    build/$example >$example.txt || fail "$example: exit status $?"
    cat $example.txt
done
cd - >/dev/null
deck=models/tank_test/tank_test.k
"$work/build/deck_step_by_step" $deck NP=2000 ENDTIM=5 >"$work/deck.txt" 2>"$work/deck.err" || { cat "$work/deck.err"; fail "deck_step_by_step"; }
cat "$work/deck.txt"
! "$work/build/deck_step_by_step" nowhere.k 2>"$work/none.err" || fail "a deck that is not there was run"
grep -q nowhere.k "$work/none.err" || fail "a deck that is not there is not named"

close "$work/membrane_under_pressure.txt" '{ a = $6; b = $9 }' 0.01
close "$work/gas_in_a_box.txt" '{ a = $11; b = $14 }' 0.01
close "$work/own_law.txt" '$2 + 0 > 1 { a = $4; b = $7 } $2 + 0 == 1 { a = b = 1 }' 0.001
grep -q 'passed through 0,' "$work/falling_cloth.txt" || fail "cloth has passed through cloth"
awk '/lowest/ { z = $10 } END { exit !(z > 0.2 && z < 1.0) }' "$work/falling_cloth.txt" || fail "the cloth does not lie on itself"
[ "$(grep -c '^t ' "$work/deck.txt")" -ge 10 ] || fail "deck_step_by_step shows fewer than ten states"

# shellcheck disable=SC2046
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name corpuscle.pc)") &&
    export PKG_CONFIG_PATH &&
    ${CXX:-g++} -O1 $(pkg-config --cflags corpuscle) -std=c++20 examples/own_law.cpp -o "$work/by_pkg_config" $(pkg-config --libs corpuscle) ||
    fail "not built by pkg-config"
"$work/by_pkg_config" | cmp - "$work/own_law.txt" || fail "another answer by pkg-config"
