#!/usr/bin/env bash
# All sources are as clang-format 14 (Debian 12's) leaves them. `tests/meta/format.sh --fix` mends them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

if [[ $(clang-format --version 2>/dev/null) != *"version 14."* ]]; then
  echo "clang-format 14 is not installed"
  exit 77
fi
how=(-n --Werror)
if [[ ${1:-} == --fix ]]; then how=(-i); fi
shopt -s globstar nullglob
printf '%s\0' {core,chapters,app,tests}/**/*.{h,cpp} | xargs -0 -P2 -n20 clang-format "${how[@]}" || {
  echo "To mend this: tests/meta/format.sh --fix"
  exit 1
}
