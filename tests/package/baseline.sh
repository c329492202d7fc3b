#!/usr/bin/env bash
# Looks through a program's code for instructions that a processor of x86-64-v2 lacks: AVX and all else that is encoded like
# it (FMA, F16C), BMI1, BMI2, LZCNT, MOVBE. (tzcnt is rep bsf there, which every processor takes.)
# usage: baseline.sh PROGRAM
set -euo pipefail
command -v objdump >/dev/null || { echo "baseline: skipped: no objdump"; exit 77; }
objdump -d --no-show-raw-insn "$1" | awk -F'\t' '
    NF > 1 { all++; split($2, word, " "); m = word[1] }
    NF > 1 && (m ~ /^v[a-z]/ && m !~ /^(verr|verw|vm)/ || /%[yz]mm/ || m ~ /^(andn|bextr|blsi|blsr|blsmsk|bzhi|mulx|pdep|pext|rorx|sarx|shlx|shrx|lzcnt|movbe)$/) { count[m]++; bad++ }
    END {
        for (m in count) print "    " m ": " count[m]
        printf "baseline: %d instructions, %d of them beyond x86-64-v2\n", all, bad
        exit !(all > 10000) || bad > 0 }'
