#!/usr/bin/env bash
# Files stay small: none above 500 lines, and half of them under 120.
set -euo pipefail
shopt -s globstar nullglob

lengths=$(wc -l {core,chapters,app,tests}/**/*.{h,cpp} | awk '$2 != "total"' | sort -n)
long=$(awk '$1 > 500' <<<"$lengths")
median=$(awk '{n[NR] = $1} END {print n[int((NR + 1) / 2)]}' <<<"$lengths")
echo "median ${median:-0} lines"

status=0
if [[ -n $long ]]; then
  printf 'Over 500 lines, to be split along their ideas:\n%s\n' "$long"
  status=1
fi
if ((${median:-0} >= 120)); then
  echo "The median is not under 120 lines."
  status=1
fi
exit "$status"
