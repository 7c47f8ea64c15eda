# Sourced by the scripts: installs Debian packages that are missing.

# need WHY PACKAGE...
need() {
    local why=$1 missing=() package
    shift
    for package in "$@"; do
        dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
    done
    [ ${#missing[@]} -eq 0 ] && return 0
    echo "installing for $why: ${missing[*]}" >&2
    local root=()
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || { echo "${0##*/}: packages are missing and there is no sudo: as root, run apt-get install ${missing[*]}" >&2; exit 1; }
        root=(sudo)
    fi
    # The package lists may be old or absent: fetch them when the first try fails
    local install=("${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}")
    "${install[@]}" >/dev/null 2>&1 ||
        { "${root[@]}" apt-get update -qq && "${install[@]}" >/dev/null; } ||
        { echo "${0##*/}: apt-get could not install ${missing[*]}" >&2; exit 1; }
}

need_for_building() {
    need "building" g++ binutils cmake ninja-build git ca-certificates libx11-dev libgl-dev libegl-dev libgl1 libgl1-mesa-dri libegl1
}

# build TARGET...: configures where needed and builds in build/
build() {
    cmake -S "$ODRAZ" -B "$ODRAZ/build" -G "$(generator)" >"$ODRAZ/build.log" 2>&1 && cmake --build "$ODRAZ/build" -j "$(nproc)" --target "$@" >>"$ODRAZ/build.log" 2>&1 ||
        { tail -n 40 "$ODRAZ/build.log" >&2; echo "${0##*/}: the build failed; its whole output is in build.log" >&2; exit 1; }
    mv "$ODRAZ/build.log" "$ODRAZ/build/build.log"
}

# What build/ was configured with stays.
generator() {
    sed -n 's/^CMAKE_GENERATOR:INTERNAL=//p' "$ODRAZ/build/CMakeCache.txt" 2>/dev/null | grep . || echo Ninja
}
