# Sourced by the scripts: prints progress, installs missing Debian packages, and builds.

# progress TEXT: prints it on stderr: on a terminal as one changing line, otherwise only every 5 s, later every 30 s
printed=
progress() {
    local pause=$((SECONDS < 50 ? 5 : SECONDS < 300 ? SECONDS / 10 : 30))
    if [ -t 2 ]; then
        printf '\r%s\e[K' "$1" >&2
    elif [ $((SECONDS - ${printed:=$SECONDS})) -ge $pause ]; then
        printed=$SECONDS
        echo "$1" >&2
    fi
}
progress_ends() { [ ! -t 2 ] || printf '\r\e[K' >&2; }

# during WHAT LOG COMMAND...: runs the command. Its progress is WHAT, the last step count of Ninja or Make in the file LOG
# (if not empty), and the seconds
during() {
    local what=$1 log=$2 status=0 printer
    shift 2
    # Print in the background and run the command in the foreground, since Ctrl-C ends only the foreground
    print_progress </dev/null >/dev/null &
    printer=$!
    "$@" || status=$?
    kill $printer 2>/dev/null || true
    wait $printer 2>/dev/null || true
    progress_ends
    return $status
}
print_progress() {
    local began=$SECONDS count=
    while sleep 1 && kill -0 $$ 2>/dev/null; do
        [ -z "$log" ] || count=$(tail -c 4000 "$log" 2>/dev/null | grep -aoE '^\[[^]]*\]' | tail -n 1 || true)
        # Ninja counts a step when it ends, and packing takes half a minute
        [ -z "$count" ] || ! pgrep --session 0 -x 'pack_film|page' >/dev/null 2>&1 || count+=" packing"
        progress "$what: ${count:+$count, }$((SECONDS - began)) s"
    done
}

# need WHY PACKAGE...: installs the packages that are missing
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
        command -v sudo >/dev/null || { echo "${0##*/}: packages are missing, and there is no sudo: as root, run apt-get install ${missing[*]}" >&2; exit 1; }
        root=(sudo)
        sudo true # may ask for a password
    fi
    during installing "" install "${missing[@]}" || { echo "${0##*/}: apt-get could not install ${missing[*]}" >&2; exit 1; }
}
install() { # uses the variable root of need()
    local by_apt=("${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$@")
    # If this fails, fetch the package lists, which may be old or missing, and try again
    "${by_apt[@]}" >/dev/null 2>&1 || { "${root[@]}" apt-get update -qq && "${by_apt[@]}" >/dev/null; }
}

# need_encoders KIND OTHERWISE: refuses a video, mkv or mp4, if ffmpeg lacks an encoder for it
need_encoders() {
    local have encoder
    command -v ffmpeg >/dev/null || need "the video" ffmpeg
    have=$(ffmpeg -loglevel error -encoders) || refuse "ffmpeg does not run here"
    for encoder in utvideo $([ "$1" = mkv ] && echo ffv1 flac || echo libx264 aac); do
        grep -q "^ [^ ]* $encoder " <<<"$have" || refuse "this ffmpeg lacks the encoder $encoder: use one that has it, or $2"
    done
}

need_for_building() {
    need "building" g++ binutils cmake ninja-build git ca-certificates libx11-dev libgl-dev libegl-dev libgl1 libgl1-mesa-dri libegl1
}

# build TARGET... [-DOPTION...]: configures and builds in $BUILD (default build/)
build() {
    local to=${BUILD:-$ODRAZ/build} targets=() options=() word generator
    for word in "$@"; do case $word in -D*) options+=("$word") ;; *) targets+=("$word") ;; esac; done
    # Keep the generator of a folder that is already configured
    generator=$(sed -n 's/^CMAKE_GENERATOR:INTERNAL=//p' "$to/CMakeCache.txt" 2>/dev/null || true)
    mkdir -p "$to"
    during building "$to/build.log" by_cmake ||
        { tail -n 40 "$to/build.log" >&2; echo "${0##*/}: the build failed; its whole output is in $to/build.log" >&2; exit 1; }
    grep -A 3 'warning: ' "$to/build.log" >&2 || true
}
by_cmake() { # uses the variables of build()
    cmake -S "$ODRAZ" -B "$to" -G "${generator:-Ninja}" "${options[@]}" >"$to/build.log" 2>&1 &&
        cmake --build "$to" -j "$(nproc)" --target "${targets[@]}" >>"$to/build.log" 2>&1
}
