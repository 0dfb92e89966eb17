#!/usr/bin/env bash
# Texts for users are in plain English and in the field's terms: none has a word of words.txt or a sentence of more than
# 30 words (tests/meta/README.md, "Words"). In comments, the habits of comment_words.txt become rarer; `--write` counts them again.
set -euo pipefail
shopt -s globstar nullglob
export LC_ALL=C

if ! command -v perl >/dev/null; then
  echo "perl is not installed"
  exit 77
fi
check() { perl tests/meta/words.pl tests/meta/words.txt "$@"; }

# What is planted must be found, in its line, and what is like it but right must not.
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cat > "$scratch/planted.cpp" <<'END'
// A comment may be told anything.
const char* right = "Shows the vertex at the pixel's corner.";
const char* wrong =
    "The kernel tells "
    "its caller.";
END
{
  echo 'A page on `told`.'
  echo
  printf 'word %.0s' {1..31}
} > "$scratch/planted.md"
expected="$scratch/planted.cpp:4: \"tells\": write report, show, return or encode"
if found=$(check "$scratch/planted.cpp") || [[ $found != "$expected" ]]; then
  printf 'A planted word gives:\n%s\nexpected:\n%s\n' "$found" "$expected"
  exit 1
fi
echo 'The lamp is dark.' > "$scratch/planted.bug"
if found=$(check "$scratch/planted.bug") || [[ $found != "$scratch/planted.bug:1: \"lamp\""* ]]; then
  printf 'A planted word in the sentence of a bug gives:\n%s\n' "$found"
  exit 1
fi
if found=$(check "$scratch/planted.md") || [[ $found != "$scratch/planted.md:"*"a sentence of 31 words"* ]]; then
  printf 'A planted sentence of 31 words gives:\n%s\n' "$found"
  exit 1
fi

# count_habits: the lines of comment_words.txt with today's counts.
count_habits() {
  local pattern kept instead
  grep -hoP '(^|[^:"])//[/<!]* ?\K.*' {core,app,chapters,tests}/**/*.{h,cpp,glsl} >"$scratch/comments"
  while IFS=$'\t' read -r pattern kept instead; do
    if [[ -n $kept ]]; then kept=$(grep -cP "$pattern" "$scratch/comments" || true); fi
    printf '%s\n' "$pattern${kept:+$'\t'$kept$'\t'$instead}"
  done <tests/meta/comment_words.txt
}
# The two pages that a person reads first are read at one sitting.
for page in README.md CONTRIBUTING.md; do
  if (($(wc -w <"$page") > 1200)); then
    echo "$page has $(wc -w <"$page") words, expected at most 1200: move a part beside its code"
    exit 1
  fi
done

habits=$(count_habits)
if [[ ${1:-} == --write ]]; then echo "$habits" >tests/meta/comment_words.txt; fi
more=$(awk -F'\t' 'FNR == NR { kept[$1] = $2; next }
  NF == 3 && $2 > kept[$1] { print "Comments: " $2 " lines match " $1 ", where " kept[$1] " did: write " $3 }' \
  tests/meta/comment_words.txt - <<<"$habits")
if [[ -n $more ]]; then
  echo "$more"
  exit 1
fi

check {core,app,chapters}/**/*.{h,cpp} chapters/*/bugs/*.bug {assets/scenes,chapters}/**/*.scene chapters/{,*/}*.md README.md \
  {core,app,chapters,tests}/**/README.md CONTRIBUTING.md assets/gallery/*.md {assets/*,tests/golden/reference}/ORIGIN.md
