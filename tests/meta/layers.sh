#!/usr/bin/env bash
# The layers of core/ and chapters/ (core/layers.txt, lowest first): folders of one line do not include each other, and
# none includes a later line. The lessons' listings (chapters/*/listing.cpp) are kernels of the textbook renderer and
# count as its folder. A line "FOLDER: ..." is the order inside a folder, where "." is what lies beside the others.
# core/layers.svg, the picture of all includes between folders, must be of these sources; tests/meta/layers.sh --write
# draws it.
set -euo pipefail
shopt -s globstar nullglob
export LC_ALL=C
layers=$(grep -v : core/layers.txt) picture=core/layers.svg

# A source outside the folders of layers would be checked by nobody.
homeless=$(printf '%s\n' core/*.{h,cpp} chapters/**/*.{h,cpp} |
  grep -vE '^chapters/(engine/[a-z0-9_]+\.(h|cpp)|[a-z0-9_]+/listing\.cpp)$' || true)
if [[ -n $homeless ]]; then
  printf 'Sources outside the folders of layers:\n%s\n' "$homeless"
  exit 1
fi

# Each include of another folder: PLACE FOLDER INCLUDED-FOLDER HEADER.
includes() {
  grep -nHP '^\s*#\s*include\s*"[a-z]+/' {core,chapters}/**/*.{h,cpp} |
    sed -E 's#^chapters/[a-z0-9_]+/listing\.cpp:#core/textbook/&#; s#^chapters/engine/#core/engine/&#' |
    sed -nE 's#^core/([a-z]+)/(chapters/)?([^:]*:[0-9]+):[^"]*"(([a-z]+)/[^"]*)".*#\1 \2\3 \5 \4#p' |
    awk '$1 != $3 { print ($2 ~ /^chapters\// ? $2 : "core/" $1 "/" $2), $1, $3, $4 }'
}

# The same inside the folders that have an order of their own.
includes_inside() {
  grep -nHP "^\s*#\s*include\s*\"$1/" core/"$1"/**/*.{h,cpp} | sed -nE 's#^core/([^:]*:[0-9]+):[^"]*"([^"]*)".*#\1 \2#p'
}
upwards_inside() {
  while read -r room order; do
    includes_inside "$room" | awk -v room="$room" -v order="$order" '
      function folder(path,  part) { return split(path, part, "/") > 2 ? part[2] : "." }
      BEGIN { n = split(order, name, " "); for (i = 1; i <= n; ++i) rank[name[i]] = i }
      { from = folder($1); to = folder($2) }
      !(from in rank) { print "core/" $1 ": the folder " room "/" from " has no place in core/layers.txt"; next }
      rank[to] > rank[from] { print "core/" $1 ": " room "/" from " includes " $2 }'
  done < <(sed -n 's/: / /p' core/layers.txt)
}

# base and math are one layer that may use itself: checks print vectors, and vectors are checked.
upwards=$(upwards_inside; includes | awk '
  FNR == NR { for (i = 1; i <= NF; ++i) rank[$i] = FNR; next }
  !($2 in rank) { print $1 ": the folder " $2 " is in no layer of core/layers.txt"; next }
  $3 in rank && rank[$3] >= rank[$2] && rank[$2] > 1 { print $1 ": " $2 " includes " $4 }' <(echo "$layers") -)
if [[ -n $upwards ]]; then
  printf 'Includes that do not point to a lower layer:\n%s\n' "$upwards"
  exit 1
fi

# One name a row, the highest layer on top; an arc for each folder that includes another: on the right where
# no way through third folders leads there, on the left and pale where one does.
draw() {
  awk '
    # side: 1 = right, 0 = left
    function arc(from, to, side,  x, r) {
      x = side ? right : left
      r = (y[to] - y[from]) / 2
      printf "    <path d=\"M%d %dA%.1f %.1f 0 0 %d %d %d\"/>\n", x, y[from], 14 + r * 0.62, r, side, x, y[to]
    }
    function arcs(implied, colour,  i, j, k, by_way, a, b) {
      print "  <g fill=\"none\" stroke=\"" colour "\" stroke-width=\"" (implied ? 1 : 1.6) "\">"
      for (i = 1; i <= folders; ++i)
        for (j = i + 1; j <= folders; ++j) {
          a = folder[i]; b = folder[j]; by_way = 0
          for (k = i + 1; k < j; ++k) if (reach[a, folder[k]] && reach[folder[k], b]) by_way = 1
          if (((a, b) in edge) && by_way == implied) arc(a, b, !implied)
        }
      print "  </g>"
    }
    FNR == NR { row[++rows] = $0; next }
    { edge[$2, $3] = 1; known[$2] = known[$3] = 1 }
    END {
      left = 330; right = 470; at = 30
      for (i = rows; i >= 1; --i) {
        names = split(row[i], name, " "); first = at
        for (j = names; j >= 1; --j) if (name[j] in known) { folder[++folders] = name[j]; y[name[j]] = at; at += 30 }
        if (at > first) { band_y[++bands] = first - 17; band_h[bands] = at - first + 4; at += 12 }
      }
      print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"800\" height=\"" at "\" viewBox=\"0 0 800 " at "\">"
      print "  <title>Which folder of core/ and chapters/ includes which: every arc leads down</title>"
      print "  <rect width=\"800\" height=\"" at "\" fill=\"#ffffff\"/>"
      for (i = 1; i <= bands; ++i)
        printf "  <rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" fill=\"#eef1f5\"/>\n",
               left, band_y[i], right - left, band_h[i]
      for (i = 1; i <= folders; ++i)
        for (j = i + 1; j <= folders; ++j) reach[folder[i], folder[j]] = (folder[i], folder[j]) in edge
      for (k = 1; k <= folders; ++k)
        for (i = 1; i < k; ++i)
          for (j = k + 1; j <= folders; ++j)
            if (reach[folder[i], folder[k]] && reach[folder[k], folder[j]]) reach[folder[i], folder[j]] = 1
      arcs(1, "#b9c2cf")
      arcs(0, "#2c5f9e")
      print "  <g font-family=\"sans-serif\" font-size=\"16\" text-anchor=\"middle\" fill=\"#1a1a1a\">"
      for (i = 1; i <= folders; ++i)
        printf "    <text x=\"%d\" y=\"%d\">%s</text>\n", (left + right) / 2, y[folder[i]] + 5, folder[i]
      print "  </g>"
      print "</svg>"
    }' <(echo "$layers") <(includes | sort -u -k2,3)
}

drawn=$(draw)
if [[ ${1:-} == --write ]]; then
  echo "$drawn" >"$picture"
elif ! cmp -s "$picture" - <<<"$drawn"; then
  echo "$picture is not of these sources: draw it again with tests/meta/layers.sh --write"
  exit 1
fi
