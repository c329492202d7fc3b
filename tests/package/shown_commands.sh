#!/usr/bin/env bash
# Prints the commands of corpuscle that a page shows as code, a line each: number of the line, tab, exit status that the
# page says it has (`# status 2` behind the command; else 0), tab, command. Several in a line are parted by ; and synopses
# (with brackets, dots or names in capitals that stand for the reader's own) are left out.
# usage: shown_commands.sh PAGE
set -euo pipefail
awk '/^```/ { fenced = !fenced } /^    +corpuscle / || (fenced && /^corpuscle /) { print FNR ":" $0 }' "$1" | while IFS=: read -r number line; do
    status=$(sed -n 's/.*# status \([0-9]*\).*/\1/p' <<<"$line")
    while IFS= read -r command; do
        command=$(sed 's/ #.*//; s/   *[^ ].*$//; s/^ *//; s/ *$//' <<<"$command")
        [[ $command == corpuscle\ * ]] || continue
        [[ $command == *\[* || $command == *...* || $command =~ (^|[[:space:]])(DIR|[A-Z]+\.(k|stl|toml))([[:space:]]|$) ]] && continue
        printf '%s\t%s\t%s\n' "$number" "${status:-0}" "$command"
    done < <(sed 's/^ *//; s/; *corpuscle/\ncorpuscle/g' <<<"$line")
done
