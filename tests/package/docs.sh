#!/usr/bin/env bash
# The manuals: no dead links, and every line that shows a command of corpuscle is one that corpuscle takes.
# usage: docs.sh PAGES     PAGES: the program corpuscle_pages
set -euo pipefail
pages=$1
bad=0
fail() { echo "docs: $*" >&2; bad=1; }
mapfile -t manuals < <(find README.md docs fabric gas contact solver io tools models tests -name '*.md' -not -path '*/node_modules/*')

# Names of headings as links spell them
anchors() { sed -n 's/^##* *//p' "$1" | tr '[:upper:]' '[:lower:]' | sed 's/[^a-z0-9 _-]//g; s/ /-/g'; }

links=0
for file in "${manuals[@]}"; do
    while IFS= read -r link; do
        links=$((links + 1))
        case $link in http://* | https://* | mailto:*) continue ;; esac
        target=${link%%#*} anchor=""
        [ "$link" = "$target" ] || anchor=${link#*#}
        path=$file
        [ -z "$target" ] || path=$(dirname "$file")/$target
        [ -e "$path" ] || { fail "$file: dead link $link"; continue; }
        [ -z "$anchor" ] || anchors "$path" | grep -qxF -- "$anchor" || fail "$file: no heading for $link"
    done < <(grep -oE '\]\([^) ]+\)' "$file" | sed 's/^](//; s/)$//')
done
[ "$links" -gt 50 ] || fail "only $links links found: expected more than 50"

# Lines of indented or fenced code that begin with corpuscle; several commands are parted by ;
commands=0
while IFS=: read -r file number line; do
    while IFS= read -r command; do
        command=$(sed 's/ #.*//; s/   *[^ ].*$//; s/^ *//; s/ *$//' <<<"$command")
        [[ $command == corpuscle\ * ]] || continue
        [[ $command != *\[* && $command != *...* ]] || continue # a synopsis
        commands=$((commands + 1))
        eval "words=(${command#corpuscle })"
        "$pages" --parse "${words[@]}" >/dev/null 2>/tmp/docs.$$ || fail "$file:$number: $command: $(head -1 /tmp/docs.$$)"
        for word in "${words[@]}"; do
            [[ $word != models/* ]] || [ -e "$word" ] || fail "$file:$number: there is no $word"
        done
    done < <(sed 's/^ *//; s/; *corpuscle/\ncorpuscle/g' <<<"$line")
done < <(grep -nE '^    +corpuscle ' "${manuals[@]}")
rm -f /tmp/docs.$$
[ "$commands" -gt 40 ] || fail "only $commands commands found: expected more than 40"
echo "docs: $links links, $commands commands in ${#manuals[@]} pages"
exit $bad
