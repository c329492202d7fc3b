#!/usr/bin/env bash
# Lists what is larger than the house wants it: classes above 25 data members, functions above 60 lines, files above
# 300, folders with more than 25 source files. With --strict it fails if there is any.
# usage: sizes.sh [--strict]
set -euo pipefail
cd "$(dirname "$0")/../.."
if ! git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
    echo "sizes: no git here to list the sources"
    exit 77
fi
list=$(mktemp)
trap 'rm -f "$list"' EXIT
mapfile -t files < <(git ls-files 'solver/*.?pp' 'fabric/*.?pp' 'gas/*.?pp' 'contact/*.?pp' 'io/*.?pp' 'tools/*.?pp' 'tests/*.?pp')

wc -l "${files[@]}" | awk '$2 != "total" && $1 > 300 { printf "file      %4d lines    %s\n", $1, $2 }' >>"$list"
for file in "${files[@]}"; do dirname "$file"; done | sort | uniq -c |
    awk '$1 > 25 { printf "folder    %4d sources  %s\n", $1, $2 }' >>"$list"

# By indentation, which clang-format keeps: a function's or a class's body ends with a brace as far in as its head began.
awk '
function depth(s) { match(s, /^ */); return RLENGTH }
FNR == 1 { heads = 0; in_class = 0 }
/^ *(class|struct) [A-Za-z_0-9:]+( final)?( *: [^;]*)? *\{$/ {
    n_class++; name[n_class] = $2; at[n_class] = depth($0); members[n_class] = 0; where[n_class] = FILENAME ":" FNR; open_class[++top] = n_class; next }
/^ *\}.*;/ && top && depth($0) == at[open_class[top]] {
    c = open_class[top--]
    if (members[c] > 25) printf "class     %4d members  %s %s\n", members[c], where[c], name[c]; next }
top && depth($0) == at[open_class[top]] + 4 && /;( *\/\/.*)?$/ && !/^ *(using|friend|static|template|typedef|enum|struct|class|return|public|private|protected|~)/ {
    s = $0; sub(/ *\/\/.*/, "", s); t = s; sub(/ *=.*/, ";", t); gsub(/\{[^}]*\}/, "", t); gsub(/<[^<>]*>/, "", t); gsub(/<[^<>]*>/, "", t)
    if (t !~ /\(/) members[open_class[top]] += gsub(/,/, ",", t) + 1 }
' $(printf '%s\n' "${files[@]}" | grep -v '^tests/') >>"$list"
awk '
function depth(s) { match(s, /^ */); return RLENGTH }
FNR == 1 { begun = 0 }
!begun && /\)( const)?( noexcept)?( override)?( -> [^{]*)? (try )?\{$/ && !/^ *(if|for|while|switch|else|do|catch|\}|return|namespace)/ && !/\[[&=a-z, ]*\]/ && /[a-zA-Z_>&*] +[~a-zA-Z_:0-9<>]+\(|^ *[A-Z][A-Za-z:]+\(|^ +[a-z].*\)/ {
    begun = FNR; far = depth($0); head = $0; next }
begun && /^ *\}/ && depth($0) <= far {
    if (FNR - begun - 1 > 60) { sub(/^ */, "", head); printf "function  %4d lines    %s:%d %s\n", FNR - begun - 1, FILENAME, begun, substr(head, 1, 60) }
    begun = 0 }
' "${files[@]}" >>"$list"
sort -k1,1 -k2,2nr "$list"
echo "sizes: $(wc -l <"$list") above the house's measures, of ${#files[@]} files"
[ "${1:-}" != --strict ] || [ ! -s "$list" ]
