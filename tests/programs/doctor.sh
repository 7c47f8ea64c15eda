# --doctor tells what this machine has and lacks, one line for each.
. "$(dirname "$0")/display.sh"
packed=$BUILD/odraz
odraz=$BUILD/odraz-safe # the same program, as is checked: it need not be unpacked first
export HOME=$WORK ALSA_CONFIG_PATH=$WORK/alsa.conf
unset DISPLAY WAYLAND_DISPLAY LD_LIBRARY_PATH
device() { echo "pcm.!default { type $1 }" >"$ALSA_CONFIG_PATH"; }
# finds STATUS NAME PATTERN COMMAND...: exits with STATUS, and what it says after "NAME: " matches
finds() {
    local status=$1 name=$2 pattern=$3 got
    shift 3
    timeout "$PATIENCE" "$@" >"$WORK/told" 2>"$WORK/err"
    got=$?
    [ $got = "$status" ] && sed -n "s/^$name: //p" "$WORK/told" | grep -qE -- "$pattern" && return 0
    echo "exit $got, wanted $status; told: $(cat "$WORK/told" "$WORK/err")" >&2
    return 1
}
told() { [ "$(cut -d: -f1 "$WORK/told" | tr '\n' ,)" = "$1" ]; } # told NAME,NAME,: these lines, in this order

device 'hw card 31'
check "without a display" finds 1 "OpenGL" "^no X display: set DISPLAY" "$odraz" --doctor
all="$("$odraz" --version),processor,memory,write and run,OpenGL,OpenGL for --dump,sound,"
check "... all else is told too" told "$all"
check "... and not on standard error" test ! -s "$WORK/err"
start_display 640x400
[ -e /usr/share/alsa/alsa.conf ] || { echo "SKIPPED: libasound2 is not installed"; exit 77; }
device null
check "with all that it needs" finds 0 "sound" "^fine$" "$odraz" --doctor
check "... it tells who draws" grep -qE '^OpenGL: .*(llvmpipe|softpipe|Mesa)' "$WORK/told"
check "... and who for dumps" grep -qE '^OpenGL for --dump: .*(llvmpipe|softpipe)' "$WORK/told"
check "... the processors" grep -qE "^processor: $(nproc) x ." "$WORK/told"
check "... in these lines" told "$all"
check "the packed film tells the same" finds 0 "memory" "^fine$" "$packed" --doctor
check "... line for line" told "$all"
device 'hw card 31'
check "without a device" finds 1 "sound" "silence$" "$odraz" --doctor
device null
check "without libasound.so.2" finds 1 "sound" "^no libasound.so.2" env LD_LIBRARY_PATH="$(lacking libasound.so.2)" "$odraz" --doctor
for missing in libX11.so.6 libGL.so.1; do
    check "without $missing" finds 1 "OpenGL" "^$missing is missing: install" env LD_LIBRARY_PATH="$(lacking $missing)" "$odraz" --doctor
    check "... all else is told too" told "$all"
done
check "without libEGL.so.1" finds 1 "OpenGL for --dump" "^no headless OpenGL 3.3: install" env LD_LIBRARY_PATH="$(lacking libEGL.so.1)" "$odraz" --doctor
check "without a driver" finds 1 "OpenGL" "^no OpenGL 3.3 on this display: install" env LIBGL_DRIVERS_PATH=/none "$odraz" --doctor
check "... of which Mesa may tell more here" grep -q 'swrast' "$WORK/err"
check "in little memory" finds 1 "memory" "^too little" bash -c "ulimit -v 500000; exec '$odraz' --doctor"
if can_be_unwritten; then
    check "where written memory may not be executed" finds 1 "write and run" "^MemoryDenyWriteExecute" "${UNWRITTEN[@]}" "$odraz" --doctor
fi
check "on a full disk" refuses 1 "no space left" bash -c "exec '$odraz' --doctor >/dev/full"
check "on a closed stdout" refuses 1 "it is closed" bash -c "exec '$odraz' --doctor >&-"
finish
