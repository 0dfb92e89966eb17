#!/usr/bin/env bash
# The top level of the repository holds what it has always held: nothing is left there by accident.
set -euo pipefail

if ! git ls-files --error-unmatch CMakeLists.txt >/dev/null 2>&1; then
  echo "not a checkout of git"
  exit 77
fi
allowed='^(CMakeLists\.txt|CMakePresets\.json|CONTRIBUTING\.md|LICENSE|README\.md|app|assets|chapters|core|cmake|tests|\.[^/]+)$'
found=$(git ls-files | sed 's|/.*||' | sort -u | grep -vE "$allowed" || true)
if [[ -n $found ]]; then
  printf 'Not of the top level:\n%s\n' "$found"
  exit 1
fi
