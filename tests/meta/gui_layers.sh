#!/usr/bin/env bash
# The layers of app/gui (app/gui/layers.txt, lowest first): folders of one line do not include each other, and none
# includes a later line. The folders inside panels/ have an order of their own, the last line below.
set -euo pipefail
shopt -s globstar nullglob
export LC_ALL=C
layers=app/gui/layers.txt
panels="kept pictures techniques options scenes lesson story space microscope studies"  # lowest first

# Each include of another folder: PLACE FOLDER INCLUDED-FOLDER HEADER. $1: the folder whose folders are looked at.
includes() {
  grep -nHP "^\s*#\s*include\s*\"${1#app/}/[a-z]+/" "$1"/*/**/*.{h,cpp} "$1"/*/*.{h,cpp} | sort -u |
    sed -nE "s#^($1/([a-z]+)/[^:]*:[0-9]+):[^\"]*\"${1#app/}/(([a-z]+)/[^\"]*)\".*#\1 \2 \4 \3#p" | awk '$2 != $3'
}

# $1: folder, $2: its layers, one a line
upwards() {
  includes "$1" | awk -v of="$1" '
    FNR == NR { for (i = 1; i <= NF; ++i) rank[$i] = FNR; next }
    !($2 in rank) { print $1 ": the folder " $2 " is in no layer of " of; next }
    !($3 in rank) { print $1 ": the folder " $3 " is in no layer of " of; next }
    rank[$3] >= rank[$2] { print $1 ": " $2 " includes " $4 }' <(echo "$2") -
}

found=$(upwards app/gui "$(cat "$layers")"; upwards app/gui/panels "$(tr ' ' '\n' <<<"$panels")")
if [[ -n $found ]]; then
  printf 'Includes in app/gui that do not point to a lower layer:\n%s\n' "$found"
  exit 1
fi
