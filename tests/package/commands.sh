#!/usr/bin/env bash
# Runs every command of corpuscle that the manuals show, page by page and in the page's order, in a scratch folder that
# has what the pages name: the models, panel.stl, bag.stl and wrong.k. What is shortened is said:
#
#   run       ends after some 20 steps; with --restart a run of 200 steps is broken off first, to be gone on with
#   study     each of its runs likewise, of the first value of each factor and one seed
#   verify    one case, the pendulum, in place of all
#
# Skipped and counted: --slurm without a cluster, --png without Chromium.
# usage: commands.sh PROGRAM [PAGE ...]
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
tree=$(cd "$here/../.." && pwd)
program=$(realpath "$1")
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$tree" || exit 1
[ $# -gt 0 ] || mapfile -t pages < <(find README.md docs fabric gas contact solver io tools models tests -name '*.md' -not -path '*/node_modules/*' | sort)
[ $# -eq 0 ] || pages=("$@")

# The program as the pages call it: `corpuscle`, with runs cut short
mkdir "$work/bin" "$work/times"
cat >"$work/bin/corpuscle" <<SHIM
#!/usr/bin/env bash
program=$program times=$work/times
SHIM
cat >>"$work/bin/corpuscle" <<'SHIM'
# Time that so many of a deck's steps take, by `check`, once for decks and settings alike; nothing where the deck is not
# accepted.
time_of() { # STEPS DECK [-D NAME=VALUE ...]
    local known
    known=$times/$(cat "$(dirname "$2")"/*.k <(printf '%s\n' "${@:2}") | md5sum | cut -d' ' -f1)
    [ -e "$known" ] || "$program" check "${@:2}" >"$known" 2>/dev/null
    awk -v steps="$1" '
        /, end time / { end = $NF }
        match($0, /first step [0-9.e+-]+/) { step = substr($0, RSTART + 11, RLENGTH - 11) + 0 }
        END { t = steps * step; if (t > 0) print (t < end ? t : end) }' "$known"
}
case $1 in
run)
    settings=() restart=0
    for ((i = 2; i <= $#; ++i)); do
        case ${!i} in
        --until) exec "$program" "$@" ;;
        -D) j=$((i + 1)) settings+=(-D "${!j}") ;;
        --restart) restart=1 ;;
        *.k) deck=${!i} ;;
        esac
    done
    if [ $restart = 0 ]; then
        until=$(time_of 20 "$deck" "${settings[@]}")
    else
        until=$(time_of 200 "$deck" "${settings[@]}")
        folder=$(basename "$deck" .k).out
        "$program" run "$deck" "${settings[@]}" --until "$until" -q &
        for ((k = 0; k < 600; ++k)); do [ -e "$folder/results.h5" ] && break; sleep 0.1; done
        sleep 0.3
        kill -INT $!
        wait $!
        [ -n "$(find "$folder" -name '*checkpoint*')" ] || { echo "nothing to go on from"; exit 9; }
    fi
    exec "$program" "$@" ${until:+--until "$until"}
    ;;
verify)
    [[ " $* " == *" --list "* ]] && exec "$program" "$@"
    options=()
    for word in "${@:2}"; do [[ $word == -* || $word == *.* || $word =~ ^[0-9]+$ ]] && options+=("$word"); done
    exec "$program" verify pendulum "${options[@]/--full/--quick}"
    ;;
*) exec "$program" "$@" ;;
esac
SHIM
chmod +x "$work/bin/corpuscle"

# A disc of 0.3 m as STL, and a ball of the same size
shape() { # NAME
    awk -v name="$1" 'function corner(r, k, h) { return sprintf("vertex %.9g %.9g %.9g", r * cos(k * a), r * sin(k * a), h) }
        function facet(p, q, s) { print "facet normal 0 0 0\nouter loop\n" p "\n" q "\n" s "\nendloop\nendfacet" }
        function ring(i) { return name == "panel" ? i / n * R : R * sin(pi * i / n) }
        function height(i) { return name == "panel" ? 0 : R * cos(pi * i / n) }
        BEGIN {
            pi = 3.14159265358979; m = 36; a = 2 * pi / m; R = 300; n = 12; print "solid " name
            for (i = 0; i < n; ++i) for (k = 0; k < m; ++k) {
                if (i > 0) facet(corner(ring(i), k, height(i)), corner(ring(i + 1), k + 1, height(i + 1)), corner(ring(i), (k + 1) % m, height(i)))
                if (i < n - 1 || name == "panel") facet(corner(ring(i), k, height(i)), corner(ring(i + 1), k, height(i + 1)), corner(ring(i + 1), (k + 1) % m, height(i + 1)))
            }
            print "endsolid " name
        }' | sed 's/-0\b/0/g'
}

shape panel >"$work/panel.stl"
shape bag >"$work/bag.stl"
printf '%s\n' '*KEYWORD' '*CONTROL_TERMINTION' '1.0' '*SECTION_SHELL' '1,2,1.0,x' '*END' >"$work/wrong.k"
cp -r models "$work/models"
# Studies with short runs, of the first value of each factor
(cd "$work/models" && for study in */*.toml; do
    grep -q '^responses' "$study" || continue
    deck=$(dirname "$study")/$(sed -n 's/^deck = "\(.*\)".*/\1/p' "$study")
    step=$("$program" check "$deck" 2>/dev/null | sed -n 's/^estimate: first step \([0-9.e+-]*\).*/\1/p')
    sed -i -E 's/^repeats.*/repeats = 1/; /^until/d; s/^([A-Z]+ *= )\[ *([^],]+),[^]]*\]/\1[\2]/' "$study"
    sed -i "1i until = $(awk -v step="${step:-0.01}" 'BEGIN { print 20 * step }')" "$study"
done)

ran=0 skipped=0 bad=0
export PATH="$work/bin:$PATH"
for page in "${pages[@]}"; do
    mapfile -t commands < <("$here/shown_commands.sh" "$page")
    [ ${#commands[@]} -gt 0 ] || continue
    scratch=$work/page
    rm -rf "$scratch"
    mkdir "$scratch"
    cp -r "$work/models" "$work/panel.stl" "$work/bag.stl" "$work/wrong.k" "$scratch"
    folder=$scratch
    [[ $page == models/* ]] && folder=$scratch/$(dirname "$page")
    begin=$SECONDS
    for entry in "${commands[@]}"; do
        IFS=$'\t' read -r number status command <<<"$entry"
        if { [[ $command == *--slurm* ]] && ! sinfo >/dev/null 2>&1; } ||
            { [[ $command == *--png* ]] && ! command -v chromium >/dev/null; }; then
            skipped=$((skipped + 1))
            continue
        fi
        ran=$((ran + 1))
        (cd "$folder" && eval "$command") >"$work/log" 2>&1 </dev/null
        got=$?
        [ $got -eq "$status" ] && continue
        bad=$((bad + 1))
        echo "commands: $page:$number: $command: exit status $got, expected $status" >&2
        tail -5 "$work/log" | sed 's/^/    /' >&2
    done
    echo "$page: ${#commands[@]} commands, $((SECONDS - begin)) s"
done
echo "commands: $ran run, $skipped skipped (need Slurm or Chromium), $bad failed"
[ $bad -eq 0 ] && [ "$ran" -gt 0 ]
