#!/usr/bin/env bash
# Installs the program of a build elsewhere and holds its version, manual pages and completions to its --help.
# usage: program.sh BUILD VERSION
set -euo pipefail
build=$1 version=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "program: $*" >&2; exit 1; }

cmake --install "$build" --prefix "$work" --component program >/dev/null
program=$work/bin/corpuscle
"$program" --version >"$work/version"
cat "$work/version"
[ "$(sed -n 1p "$work/version")" = "corpuscle $version" ] || fail "--version: not $version"
for line in commit compiler build; do grep -q "^$line  *[^ ]" "$work/version" || fail "--version: no $line"; done

commands=$("$program" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
[ "$(wc -w <<<"$commands")" -ge 9 ] || fail "--help lists fewer than nine commands"
for command in $commands; do
    page=$work/share/man/man1/corpuscle-$command.1
    [ -s "$page" ] || fail "no manual page of $command"
    "$program" "$command" --help >"$work/help"
    for option in $(grep -oE '^  (-[a-zA-Z]|--[a-z0-9-]+)(,--[a-z0-9-]+)*' "$work/help" | tr ',' ' '); do
        grep -qF -- "${option//-/\\-}" "$page" || fail "corpuscle-$command.1 says nothing of $option"
        COMP_WORDS=(corpuscle "$command" "$option") bash -c '
            source "$1"; COMP_WORDS=(corpuscle "$2" "$3"); COMP_CWORD=2; _corpuscle; [[ " ${COMPREPLY[*]} " == *" $3 "* ]]' \
            - "$work/share/bash-completion/completions/corpuscle" "$command" "$option" ||
            fail "bash does not complete $command $option"
        grep -qF -- "'${option}[" "$work/share/zsh/vendor-completions/_corpuscle" || fail "zsh does not know $option"
    done
done
if command -v man >/dev/null; then
    for page in "$work"/share/man/man1/*.1; do
        complaints=$(LC_ALL=C.UTF-8 MANROFFSEQ='' MANWIDTH=100 man --warnings -E UTF-8 -l -Tutf8 -Z "$page" 2>&1 >/dev/null) || true
        [ -z "$complaints" ] || fail "$page: $complaints"
    done
fi
