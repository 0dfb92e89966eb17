# shellcheck shell=bash
# shellcheck disable=SC2034  # the lists are for the scripts that source this
# Set-up shared by app/run, tests/run and tests/tidy: Debian packages, configuration, build. To be sourced by bash.

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# The packages, kept once. build: to compile everything but the tests.
build_packages=(
  cmake fonts-inter fonts-jetbrains-mono g++ libcli11-dev libembree-dev libepoxy-dev libfmt-dev libfreetype-dev libglm-dev libhwy-dev
  libimgui-dev libmd4c-dev libsdl2-dev libstb-dev ninja-build nlohmann-json3-dev pkgconf
)
window_packages=(bubblewrap libegl1 libgl1 libgl1-mesa-dri)  # shuts listings off; OpenGL, in software if need be
display_packages=(xvfb)                           # a display where there is none
test_packages=(clang-format libgtest-dev librapidcheck-dev openbox xdotool)
sanitizer_packages=(clang libclang-rt-dev)        # a compiler whose sanitizers and fuzzer are used
emulated_packages=(qemu-user)                     # other processors
web_packages=(chromium)                           # a browser for the handouts
tidy_packages=(clang clang-tidy libc++-dev libc++abi-dev)

fail() {
  printf '%s\n' "$@" >&2
  exit 1
}

# need_without_apt PACKAGE...: where nothing can be installed, ends with the names of all programs that are missing. If
# none is, CMake looks for the libraries and names all that are missing. What tests can do without is left out here.
need_without_apt() {
  local -A program_of=([cmake]=cmake [ninja-build]=ninja [g++]=c++ [pkgconf]=pkg-config [xvfb]=Xvfb [clang]=clang++
    [clang-tidy]=clang-tidy [qemu-user]=qemu-x86_64 [chromium]=chromium)
  local package program missing=() libraries=()
  for package in "$@"; do
    program=${program_of[$package]:-}
    if [[ -n $program ]]; then
      command -v "$program" >/dev/null || missing+=("$program")
    elif [[ $package == *-dev ]]; then
      libraries+=("$package")
    fi
  done
  if ((${#missing[@]} == 0)); then return 0; fi
  fail "This system has no apt, so nothing can be installed by itself. These programs are missing: ${missing[*]}" \
    "Pixelscope also needs the libraries of these Debian packages, whatever their names are here:" "  ${libraries[*]}" \
    "Install what is missing, then start this again."
}

# need PACKAGE...: installs those that are missing; quiet and quick if none is.
need() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    need_without_apt "$@"
    return
  fi
  local -A installed=()
  local state package missing=()
  while read -r state package; do
    if [[ $state == ?i ]]; then installed[${package%%:*}]=1; fi
  done < <(dpkg-query -W -f '${db:Status-Abbrev} ${Package}\n' "$@" 2>/dev/null)
  for package in "$@"; do
    if [[ -z ${installed[$package]:-} ]]; then missing+=("$package"); fi
  done
  if ((${#missing[@]} == 0)); then return 0; fi

  echo "Installing Debian packages: ${missing[*]}"
  local root=()
  if ((EUID != 0)); then
    root=(sudo)
    command -v sudo >/dev/null || fail \
      "These packages are missing, and there is no sudo to install them with. As root, run:" \
      "  apt-get update && apt-get install --no-install-recommends ${missing[*]}"
  fi
  local apt=("${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300)
  "${apt[@]}" update || echo "apt-get update failed; going on with the package lists at hand." >&2
  "${apt[@]}" install -y --no-install-recommends "${missing[@]}" || fail "The packages could not be installed." \
    "As root, run: apt-get update && apt-get install --no-install-recommends ${missing[*]}"
}

# leave_sudo SCRIPT ARGUMENT...: under `sudo SCRIPT` in a folder that is not root's, goes on as the user who called sudo
# (packages are installed by then), so that nothing built belongs to root.
leave_sudo() {
  if ((EUID != 0)) || [[ -z ${SUDO_USER:-} || ${SUDO_USER} == root || $(stat -c %u "$repository") == 0 ]]; then
    return 0
  fi
  exec runuser -u "$SUDO_USER" -- env HOME="$(getent passwd "$SUDO_USER" | cut -d: -f6)" "$@"
}

# configured FOLDER [-DNAME=ON...]: whether the build folder belongs to this checkout and has these values.
configured() {
  local cache value
  [[ -f $repository/$1/build.ninja ]] || return 1
  cache=$(<"$repository/$1/CMakeCache.txt")
  [[ $cache == *$'\n'"CMAKE_HOME_DIRECTORY:INTERNAL=$repository"$'\n'* ]] || return 1
  for value in "${@:2}"; do
    value=${value#-D}
    [[ $cache == *$'\n'"${value%%=*}:BOOL=${value#*=}"$'\n'* ]] || return 1
  done
}

# configure PRESET FOLDER [-DNAME=ON...]: runs CMake unless the folder is already configured so.
configure() {
  configured "${@:2}" && return
  local fresh=()
  configured "$2" || fresh=(--fresh)  # which throws away what was compiled: only for a folder that came from elsewhere
  (cd "$repository" && cmake "${fresh[@]}" --preset "$1" "${@:3}")
}

# build PRESET TARGET...: a compiler for each core. Ninja's own choice, one or two more, took 3 % longer on two cores.
build() {
  local preset=$1
  shift
  (cd "$repository" && cmake --build --preset "$preset" --parallel "$(nproc)" --target "$@")
}

# large_pages: what is started from here takes its memory from the system 64 MB at a time and on pages of 2 MB, where the
# system has them: the window then starts in three quarters of the time. glibc reads this; other C libraries do not.
large_pages() {
  local wish=glibc.malloc.hugetlb=1:glibc.malloc.mmap_threshold=33554432:glibc.malloc.top_pad=67108864
  export GLIBC_TUNABLES=$wish${GLIBC_TUNABLES:+:$GLIBC_TUNABLES}
}
