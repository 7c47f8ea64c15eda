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
    # The package lists may be old or missing: fetch them if the first try fails
    local install=("${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}")
    "${install[@]}" >/dev/null 2>&1 ||
        { "${root[@]}" apt-get update -qq && "${install[@]}" >/dev/null; } ||
        { echo "${0##*/}: apt-get could not install ${missing[*]}" >&2; exit 1; }
}

need_for_building() {
    need "building" g++ binutils cmake ninja-build git ca-certificates libx11-dev libgl-dev libegl-dev libgl1 libgl1-mesa-dri libegl1
}

# build TARGET... [-DOPTION...]: configures and builds in $BUILD (build/ if not set)
build() {
    local to=${BUILD:-$ODRAZ/build} targets=() options=() word generator
    for word in "$@"; do case $word in -D*) options+=("$word") ;; *) targets+=("$word") ;; esac; done
    # A folder that was configured with one generator stays with it
    generator=$(sed -n 's/^CMAKE_GENERATOR:INTERNAL=//p' "$to/CMakeCache.txt" 2>/dev/null || true)
    mkdir -p "$to"
    cmake -S "$ODRAZ" -B "$to" -G "${generator:-Ninja}" "${options[@]}" >"$to/build.log" 2>&1 &&
        cmake --build "$to" -j "$(nproc)" --target "${targets[@]}" >>"$to/build.log" 2>&1 ||
        { tail -n 40 "$to/build.log" >&2; echo "${0##*/}: the build failed; its whole output is in $to/build.log" >&2; exit 1; }
    grep -A 3 'warning: ' "$to/build.log" >&2 || true
}
