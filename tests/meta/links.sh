#!/usr/bin/env bash
# Every link and picture of a page (*.md) that is a path leads to a file of the repository, and every #part to a heading.
set -euo pipefail
shopt -s globstar nullglob
export LC_ALL=C

# broken PAGE...: "PAGE: LINK" for each link that leads nowhere. Links of lessons to their own parts have a colon.
broken() {
  local page link file part
  for page in "$@"; do
    while read -r link; do
      file=${link%%#*} part=${link#"$file"}
      file=${file:+$(dirname "$page")/$file}
      if [[ ! -e ${file:-$page} ]]; then
        echo "$page: $link"
      elif [[ -n $part ]] && ! headings "${file:-$page}" | grep -qxF "${part#'#'}"; then
        echo "$page: $link"
      fi
    done < <(sed 's/`[^`]*`//g' "$page" | grep -oP '\]\(\K[^():\s]+(?=\))' || true)
  done
}
# headings PAGE: as GitHub names them in links.
headings() { sed -n 's/^##* //p' "$1" | tr 'A-Z ' 'a-z-' | tr -cd 'a-z0-9_\n-'; }

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
printf '# One part\n[there](page.md) [there](#one-part) [gone](gone.md) [gone](page.md#two-parts) `[code](x.md)`\n' >"$scratch/page.md"
expected=$(printf '%s: %s\n' "$scratch/page.md" gone.md "$scratch/page.md" page.md#two-parts)
if [[ $(broken "$scratch/page.md") != "$expected" ]]; then
  printf 'Planted links give:\n%s\nexpected:\n%s\n' "$(broken "$scratch/page.md")" "$expected"
  exit 1
fi

found=$(broken *.md {core,app,chapters,assets,tests}/**/*.md)
if [[ -n $found ]]; then
  printf 'Links that lead nowhere:\n%s\n' "$found"
  exit 1
fi
