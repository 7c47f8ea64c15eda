# The film on Windows if its output is closed, full, or a console: status and line are those of Linux, nothing crashes
# or hangs, and no file is half-written. The probe starts the film as Windows does (probe start, probe console), because
# Wine would reuse descriptors that were closed on Linux.
. "$(dirname "$0")/wine.sh"
start_display 640x400
needs_built tests/probe-safe.exe
linux=$BUILD/odraz-safe windows=$BUILD/odraz-safe.exe probe=$BUILD/tests/probe-safe.exe
cd "$WORK" || exit 1
small=(--size 64x36 --from 20 --to 20.04 --quality draft)
lines=("--version" "--nope" "--to 999" "--dump - ${small[*]}" "--wav - --to 0.1" "--dump no/where ${small[*]}")
films=("--window --mute --stats --size 64x36 --from 161") # these play the film
run() { timeout "$PATIENCE" "$@"; } # 124: it hangs

# --- Closed ---

# as_linux HOW CLOSED LINE...: compares the status, and the output on descriptors that are open
as_linux() {
    local how=$1 closed=$2 line=$3 in=/dev/null out=out.linux err=err.linux status wanted by
    rm -f out.* err.*
    touch out.{linux,windows} err.{linux,windows}
    (
        case $closed in *0*) exec <&- ;; esac
        case $closed in *1*) exec >&- ;; esac
        case $closed in *2*) exec 2>&- ;; esac
        run "$linux" $line
    ) </dev/null >out.linux 2>err.linux
    wanted=$?
    # If neither output is there a box opens, so take the display away
    local quiet=()
    [[ $line = *--window* ]] || quiet=(env -u DISPLAY)
    run "${quiet[@]}" "$wine" "$probe" start "$how" "$closed" "\"Z:${windows//\//\\}\" $line" </dev/null >out.windows 2>err.windows
    status=$?
    [[ $line != *--stats* ]] || sed -i 's/[0-9.]*//g; /^credits/!d; s/ .*//' out.*
    [ $status = $wanted ] && cmp out.linux out.windows && { [ -s out.linux ] || [ -s err.linux ] || [[ $closed = *1* || $closed = *2* ]]; } &&
        cmp err.linux err.windows && [ "$(wc -l <err.windows)" -le 1 ] && return
    echo "$line without $closed ($how): status $status, Linux's $wanted; $(head -c 200 err.windows)" >&2
    return 1
}
all_as_linux() { # all_as_linux HOW CLOSED: for every command line
    local line bad=0
    for line in "${lines[@]}" "${films[@]}"; do as_linux "$1" "$2" "$line" || bad=1; done
    return $bad
}
for closed in "" 0 1 2 01 02 12 012; do
    check "standard handles that are null: ${closed:-none}" all_as_linux null "$closed"
done
films=()
for closed in 1 2 12 012; do check "... that are invalid: $closed" all_as_linux invalid "$closed"; done
check "... that were closed before: 12" all_as_linux stale 12
whole() {
    run "$wine" "$probe" start null 012 "\"Z:${windows//\//\\}\" --dump frames ${small[*]} --wav frames/a.wav" </dev/null >out 2>err &&
        run "$linux" --dump wanted "${small[@]}" && run "$linux" --wav wanted/a.wav "${small[@]:2:4}" && diff -r frames wanted
}
mkdir frames wanted
check "frames dumped without any of them are whole" whole

# Start it as from a shortcut: without either output and without a console
no_handles() { exec "$wine" "$probe" start null 012 "\"Z:${windows//\//\\}\" --nope" </dev/null >out 2>err; }
check "an error opens a box where there is no standard handle, with the status that it has" boxed 2 odraz-safe.exe no_handles

# --- Full ---

refused_alike() { # refused_alike STATUS TEXT COMMAND: for the output of $film; both print the same line
    local film
    for film in "$linux" "$wine $windows"; do
        refuses "$1" "$2" bash -c "set -o pipefail; film='$film'; $3" || return
        [[ $film = *.exe ]] || mv err err.linux
    done
    cmp err.linux err
}
full="cannot write standard output: no space left on the device"
check "--help into a full disk" refused_alike 1 "$full" 'exec $film --help >/dev/full'
check "--version, too" refused_alike 1 "$full" 'exec $film --version >/dev/full'
check "--stats, too" refused_alike 1 "$full" 'exec $film --window --mute --stats --size 64x36 --from 161 >/dev/full'
check "--stats into a closed pipe" refused_alike 1 "the pipe was closed" '{ sleep 0.2; $film --window --mute --stats --size 64x36 --from 161; } | true'
check "music into one" refused_alike 1 "the pipe was closed" '{ sleep 0.2; $film --wav -; } | true'

mkdir disk
left() { # left FILM OPTION...: dumps until the disk is full; prints the names and sizes of the files left
    local film=$1
    shift
    rm -rf disk/*
    refuses 1 "no space left on the device" $film "$@" || return
    (cd disk && find . -printf '%p %s %y\n' | sed 's/ [0-9]* d$//' | sort)
}
left_alike() {
    left "$linux" "$@" >left.linux && mv err err.linux && left "$wine $windows" "$@" >left.windows && cmp left.linux left.windows && cmp err err.linux && lacks part left.windows
}
if mount -t tmpfs -o size=64k odraz disk 2>/dev/null; then
    trap 'status=$?; umount "$WORK/disk"; (exit $status); end_wine; leave' EXIT
    check "frames on a disk that gets full" left_alike --dump disk/frames --size 64x36 --from 20 --to 21 --quality draft
    check "... leave those that are whole" test "$(wc -l <left.windows)" -gt 5
    check "music on a disk that is too small" left_alike --wav disk/a.wav --to 1
    check "... leaves nothing" test "$(wc -l <left.windows)" = 1
else
    echo "not checked: a full disk, which only root can make"
fi

# --- A console ---

# in_console CLOSED STATUS OPTION...: starts the film from a console, without the CLOSED handles; writes the console's
# rows, each after a '|', to `shown`
in_console() {
    local closed=$1 wanted=$2
    shift 2
    run "$wine" "$probe" console "$closed" "\"Z:${windows//\//\\}\" $*" </dev/null >shown 2>err
    [ $? = "$wanted" ] || { echo "not $wanted: $(head -c 300 shown err)" >&2; return 1; }
}
shows() { diff <("$linux" "$@" 2>&1 | sed 's/^/|/') shown; } # the console shows this and nothing else
check "from a console, --version" in_console 012 0 --version
check "... gets there" shows --version
check "an unknown option" in_console 12 2 --nope
check "... is shown there" shows --nope
check "with a file for standard output, --version" in_console 2 0 --version
check "... gets into that" cmp shown <("$linux" --version)
check "... an error goes to the console" in_console 2 2 --nope
check "... in its line" shows --nope
check "with both, --version" in_console "" 0 --version
check "... gets into the file" cmp shown <("$linux" --version)
check "... an unknown option" in_console "" 2 --nope
check "... into the other" test ! -s shown -a "$(cat err)" = "$("$linux" --nope 2>&1)"
check "pictures do not get into a console" in_console 12 2 --dump - "${small[@]}"
check "... which is reported" grep -q 'what goes to - is not text' shown
finish
