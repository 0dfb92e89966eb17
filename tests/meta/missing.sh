#!/usr/bin/env bash
# What a person reads where something is missing and cannot be installed: one message with all of it.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
status=0

# expect OUTPUT NAME...: each name is in the output.
expect() {
  local name
  for name in "${@:2}"; do
    if [[ $1 != *"$name"* ]]; then
      printf 'Not named: %s. What was printed:\n%s\n' "$name" "$1"
      status=1
    fi
  done
}

# Programs: without dpkg, CMake and Ninja.
mkdir "$folder/bin"
ln -s /usr/bin/* "$folder/bin"
rm -f "$folder"/bin/{dpkg-query,cmake,ninja}
if output=$(PATH=$folder/bin app/run 2>&1); then
  echo "app/run went on without CMake"
  status=1
fi
expect "$output" "These programs are missing: cmake ninja" libimgui-dev libsdl2-dev
if [[ $output == *c++\ * || $output == *pkg-config* ]]; then
  printf 'Named, and not missing:\n%s\n' "$output"
  status=1
fi

# Libraries: CMake does not find three of them.
if output=$(cmake -G Ninja -S . -B "$folder/build" -DPIXELSCOPE_TESTS=OFF -DCMAKE_DISABLE_FIND_PACKAGE_{glm,CLI11,Freetype}=ON 2>&1); then
  echo "CMake went on without three libraries"
  status=1
fi
expect "$output" "GLM (libglm-dev)" "CLI11 (libcli11-dev)" "FreeType (libfreetype-dev)"
if [[ $(grep -c '(lib[a-z0-9]*-dev)' <<<"$output") != 3 ]]; then
  printf 'More or fewer than the three are named:\n%s\n' "$output"
  status=1
fi
exit "$status"
