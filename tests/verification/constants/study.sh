#!/usr/bin/env bash
# One-at-a-time study of the calibrated constants in table.txt: for each value a program of its own, on a case of
# `corpuscle verify` that it acts on. Prints a table in Markdown.
# usage: study.sh [-j RUNS_AT_A_TIME] [NAME ...]       a build a value; CMAKE_CXX_COMPILER_LAUNCHER is taken
set -euo pipefail
cd "$(dirname "$0")/../../.."
table=$PWD/tests/verification/constants/table.txt jobs=$(nproc)
if [ "${1:-}" = -j ]; then jobs=$2; shift 2; fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
git ls-files -z | xargs -0 cp --parents -t "$work"
cmake -S "$work" --preset release -B "$work/build" -DCORPUSCLE_TESTS=OFF -DCORPUSCLE_JOIN=ON >/dev/null
built() { cmake --build "$work/build" --target corpuscle >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }; }
# Puts a constant of FILE to VALUE
put() { # FILE NAME VALUE
    sed -Ei "s@(constexpr [a-z_:]+ $2 *= *)[^;]+;@\1$3;@" "$work/$1"
    grep -q "constexpr [a-z_:]* $2 *= *$3;" "$work/$1" || { echo "study: no constant $2 in $1" >&2; exit 1; }
}
# The error that CASE shows for the quantity that begins with WHAT, and its budget
measured() { # FOLDER CASE WHAT
    "$work/build/bin/corpuscle" verify "$2" --quick -j "$jobs" --runs "$work/runs/$1" -o "$work/page.md" >"$work/log" 2>&1 || true
    awk -F ' *[|] *' -v what="$3" 'index($4, what) == 1 { print $6 "|" $7; found = 1 } END { exit !found }' "$work/page.md" ||
        { cat "$work/log" >&2; echo "study: $2 has no quantity that begins with '$3'" >&2; exit 1; }
}

echo "# Calibrated constants"
echo
echo "By \`tests/verification/constants/study.sh\`: each constant at three values, its own in the middle and in bold, all others left"
echo "alone, and the error of a quantity that it acts on (\`corpuscle verify CASE --quick\`; ± of 95 % between seeds)."
echo
echo "| constant | what it sets | why its value | case: quantity | budget | values | errors |"
echo "|---|---|---|---|---|---|---|"
while IFS='|' read -r file name values case what sets why; do
    read -r file name case <<<"$file $name $case"
    [ $# -eq 0 ] || [[ " $* " == *" $name "* ]] || continue
    what=$(sed 's/^ *//; s/ *$//' <<<"$what")
    shown='' errors='' budget='' i=0
    IFS=';' read -ra all <<<"$values"
    for setting in "${all[@]}"; do
        setting=$(sed 's/^ *//; s/ *$//' <<<"$setting")
        more=$(grep -oE '[A-Z_]+=[^ ]+' <<<"$setting" || true) value=$(sed -E 's/ *[A-Z_]+=[^ ]+//g' <<<"$setting")
        cp "$file" "$work/$file"
        if [ $i = 1 ]; then
            grep -q "constexpr [a-z_:]* $name *= *$value;" "$file" || { echo "study: $name is not $value in $file" >&2; exit 1; }
            folder=as_it_is
        else
            put "$file" "$name" "$value"
            for other in $more; do put "$file" "${other%%=*}" "${other#*=}"; done
            folder=${name}_$i
        fi
        built
        IFS='|' read -r error budget < <(measured "$folder" "$case" "$what")
        [ $i = 1 ] && { value="**$value**" error="**$error**"; }
        shown+="${shown:+, }$value" errors+="${errors:+, }$error" i=$((i + 1))
    done
    cp "$file" "$work/$file"
    echo "| \`$name\` |$sets|$why | $case: $what | $budget | $shown | $errors |"
done < <(grep -vE '^#|^$' "$table")
