# --doctor lists what this machine has and lacks, one line for each.
. "$(dirname "$0")/display.sh"
odraz=$BUILD/odraz-safe # starts without unpacking
export HOME=$WORK ALSA_CONFIG_PATH=$WORK/alsa.conf
unset DISPLAY WAYLAND_DISPLAY LD_LIBRARY_PATH
device() { echo "pcm.!default { type $1 }" >"$ALSA_CONFIG_PATH"; }
# finds STATUS NAME PATTERN COMMAND...: succeeds if the command exits with STATUS and its text after "NAME: " matches
finds() {
    local status=$1 name=$2 pattern=$3 got
    shift 3
    timeout "$PATIENCE" "$@" >"$WORK/lines" 2>"$WORK/err"
    got=$?
    [ $got = "$status" ] && sed -n "s/^$name: //p" "$WORK/lines" | grep -qE -- "$pattern" && return 0
    echo "exit $got, wanted $status; printed: $(cat "$WORK/lines" "$WORK/err")" >&2
    return 1
}
lists() { [ "$(cut -d: -f1 "$WORK/lines" | tr '\n' ,)" = "$1" ]; } # lists NAME,NAME,: succeeds if it printed these lines in this order

device 'hw card 31'
check "without a display" finds 1 "OpenGL" "^no X display: set DISPLAY" "$odraz" --doctor
all="$("$odraz" --version),processor,memory,write and run,OpenGL,OpenGL for --dump,sound,"
check "... all else is listed too" lists "$all"
check "... and not on standard error" test ! -s "$WORK/err"
start_display 640x400
[ -e /usr/share/alsa/alsa.conf ] || { echo "SKIPPED: libasound2 is not installed"; exit 77; }
device null
check "with everything that it needs" finds 0 "sound" "^fine$" "$odraz" --doctor
check "... it names the OpenGL of the display" grep -qE '^OpenGL: .*(llvmpipe|softpipe|Mesa)' "$WORK/lines"
check "... and the OpenGL of --dump" grep -qE '^OpenGL for --dump: .*(llvmpipe|softpipe)' "$WORK/lines"
check "... the processors" grep -qE "^processor: $(nproc) x ." "$WORK/lines"
check "... in these lines" lists "$all"
device 'hw card 31'
check "without a device" finds 1 "sound" "silence$" "$odraz" --doctor
device null
check "without libasound.so.2" finds 1 "sound" "^no libasound.so.2" env LD_LIBRARY_PATH="$(lacking libasound.so.2)" "$odraz" --doctor
check "without libGL.so.1" finds 1 "OpenGL" "^libGL.so.1 is missing: install" env LD_LIBRARY_PATH="$(lacking libGL.so.1)" "$odraz" --doctor
check "... all else is listed too" lists "$all"
check "without libEGL.so.1" finds 1 "OpenGL for --dump" "^no headless OpenGL 3.3: install" env LD_LIBRARY_PATH="$(lacking libEGL.so.1)" "$odraz" --doctor
check "without a driver" finds 1 "OpenGL" "^no OpenGL 3.3 on this display: install" env LIBGL_DRIVERS_PATH=/none "$odraz" --doctor
check "... where Mesa may print more" grep -q 'swrast' "$WORK/err"
check "with little memory" finds 1 "memory" "^too little" bash -c "ulimit -v 500000; exec '$odraz' --doctor"
if has_mdwe; then
    check "where written memory may not be executed" finds 1 "write and run" "^MemoryDenyWriteExecute" "${MDWE[@]}" "$odraz" --doctor
fi
check "on a full disk" refuses 1 "no space left" bash -c "exec '$odraz' --doctor >/dev/full"
finish
