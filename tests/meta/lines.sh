#!/usr/bin/env bash
# Prints the lines of C++ and GLSL in each room (the folders of core/ and app/, chapters/, tests/) beside those of the last
# tag or, where there is no tag, of tests/meta/lines.txt. `tests/meta/lines.sh --write` keeps today's lines in that file.
set -euo pipefail
export LC_ALL=C
kept=tests/meta/lines.txt

if ! git rev-parse HEAD >/dev/null 2>&1; then
  echo "not a checkout of git"
  exit 77
fi

# lines [COMMIT]: "ROOM LINES", of the commit or of the files as they are.
lines() {
  local what=(--untracked -e '')
  if (($#)); then what=(-e '' "$1"); fi
  git grep -c "${what[@]}" -- {core,app,chapters,tests}/'*.'{cpp,h,glsl} | awk -v commit="${1:-}" '
    {
      if (commit != "") $0 = substr($0, length(commit) + 2)
      split($0, part, ":")
      names = split(part[1], name, "/")
      room = name[1]
      if ((room == "core" || room == "app") && names > 2) room = room "/" name[2]
      count[room] += part[2]
    }
    END { for (room in count) print room, count[room] }' | sort
}

if [[ ${1:-} == --write ]]; then
  lines >"$kept"
  exit
fi
if tag=$(git describe --tags --abbrev=0 2>/dev/null); then before=$(lines "$tag"); else tag=kept before=$(<"$kept"); fi
today=$(lines)
awk -v tag="$tag" '
  function row(room, before, today) { printf "%-16s %10s %8s %+8d\n", room, before, today, today - before }
  BEGIN { printf "%-16s %10s %8s %8s\n", "room", tag, "today", "change" }
  FNR == NR { before[$1] = $2; all_before += $2; next }
  { row($1, before[$1] + 0, $2); delete before[$1]; all += $2 }
  END {
    for (room in before) row(room, before[room], 0)
    row("all", all_before, all)
  }' <(echo "$before") <(echo "$today")
