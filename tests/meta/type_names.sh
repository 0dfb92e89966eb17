#!/usr/bin/env bash
# One word, one thing: no two headers of core/ define types of the same name, whatever their namespaces. Types inside
# types and those of one .cpp file are not looked at. Specialisations of a template are the template's.
set -euo pipefail
shopt -s globstar nullglob
export LC_ALL=C

doubles=$(grep -HoP '^(enum class|enum|class|struct) (alignas\(\d+\) )?\K[A-Z]\w*(?=( final)?( :.*)? \{)' core/**/*.h |
  awk -F: '{ files[$2] = files[$2] " " $1; if (++count[$2] == 2) twice[$2] = 1 }
    END { for (name in twice) print "  " name ":" files[name] }' | sort)
if [[ -n $doubles ]]; then
  printf 'Type names that two headers use for different things:\n%s\n' "$doubles"
  exit 1
fi
