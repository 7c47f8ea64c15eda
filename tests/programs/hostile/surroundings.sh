# In odd environments the film draws the same picture, or prints one line: limits; no /proc, /dev or /sys; setuid;
# personalities; empty or huge environment variables; folders that are gone, read-only or full; a display that does not
# exist. Fewer than 4 descriptors and stacks below 64 KB are not tried: the loader and the kernel refuse them.
#   surroundings.sh BUILD odraz|odraz-safe
# (commandline.sh closes descriptors; machine.sh tests missing libraries, old processors and little memory; machine.sh
# and packed.sh test MDWE)
. "$(dirname "$0")/../common.sh"
name=${2:-odraz-safe}
odraz=$BUILD/$name
unset DISPLAY WAYLAND_DISPLAY
# Close descriptors that the caller left open: they would count towards the limit
for fd in /proc/self/fd/*; do fd=${fd##*/}; [ "$fd" -lt 3 ] || [ "$fd" = 255 ] || eval "exec $fd>&-"; done
chmod 711 "$WORK"
cd "$WORK" || exit 1
plain=(--dump - --from 20 --to 20.04 --size 64x36)
hall=(--dump - --from 120 --to 120.04 --size 64x36)
"$odraz" "${plain[@]}" >plain.ppm || exit 1
"$odraz" "${hall[@]}" >hall.ppm || exit 1

# same plain|hall COMMAND...: runs the film by the command; succeeds if the picture is the same and nothing is printed
same() {
    local kind=$1
    shift
    local -n arguments=$kind
    timeout "$PATIENCE" "$@" "$odraz" "${arguments[@]}" >got.ppm 2>err </dev/null && cmp $kind.ppm got.ppm && [ ! -s err ] && return
    head -c 300 err >&2
    return 1
}
# limited OPTION VALUE COMMAND...: runs the command under a limit (ulimit). under OPTION VALUE: sets UNDER to the same
limited() { local limit="ulimit $1 $2"; shift 2; bash -c "$limit"' && exec "$@"' limited "$@"; }
export -f limited
under() { local limit="ulimit $1 $2"; shift 2; UNDER=(bash -c "$limit"' && exec "$@"' under); }

# --- Limits ---
under -n 4; check "with 4 descriptors" same plain "${UNDER[@]}"
under -s 256; check "with a stack of 256 KB" same plain "${UNDER[@]}"
under -s unlimited; check "with an unlimited stack" same plain "${UNDER[@]}"
under -c 0; check "without core files" same plain "${UNDER[@]}"
under -l 0; check "without locked memory" same plain "${UNDER[@]}"
check "the hall, with all of these" same hall bash -c 'ulimit -n 4 -s 256 -c 0 -l 0 && exec "$@"' under
under -s unlimited; check "... with an unlimited stack" same hall "${UNDER[@]}"
under -s 64; check "with a stack of 64 KB" same plain "${UNDER[@]}"
# With any limit on address space the film draws the picture or prints one line
any_room() {
    local kb status refused=0 drawn=0
    for kb in $(seq 6000 11000 250000); do
        limited -v "$kb" timeout "$PATIENCE" "$odraz" "${plain[@]}" >got.ppm 2>err </dev/null
        status=$?
        if [ $status = 0 ] && cmp -s plain.ppm got.ppm && [ ! -s err ]; then drawn=$((drawn + 1))
        elif [ $status = 1 ] && [ "$(wc -l <err)" = 1 ] && [ ! -s got.ppm ]; then refused=$((refused + 1))
        else echo "with a limit of $kb KB: exit status $status, $(head -c 300 err)" >&2; return 1; fi
    done
    echo "    too little $refused times, enough $drawn times"
    [ $refused -gt 0 ] && [ $drawn -gt 0 ]
}
check "with any limit of memory: the frame, or one line" any_room
for blocks in 0 1 4; do # 1024 bytes each; a frame has 6,925
    no_room() {
        local line
        rm -rf limit
        line=$(limited -f $blocks "$odraz" --dump limit --from 20 --to 20.2 --size 64x36 2>&1 >/dev/null | cat)
        [[ $line = "odraz: cannot write limit/frame-000500.ppm: the limit on a file's size is reached (ulimit -f)" ]] && [ -z "$(ls limit)" ] && return
        echo "$line" >&2
        return 1
    }
    check "with a limit of $blocks KB for a file" no_room
done
# The kernel kills the film after two seconds of processor time; its frames are whole. All frames would take some 15 s
timed_out() {
    local frame
    limited -t 2 "$BUILD/odraz-safe" --dump timed --from 20 --to 60 --size 480x270 --quality draft --threads 2 2>err
    [ $? -gt 128 ] && [ -n "$(ls timed)" ] || return 1
    for frame in timed/*.ppm; do [ ! -e "$frame" ] || [ "$(stat -c %s "$frame")" = $((480 * 270 * 3 + 15)) ] || { echo "$frame" >&2; return 1; }; done
} 2>/dev/null # which hides the shell's "Killed"
check "killed at a limit of processor time: frames that were written are whole" timed_out

# --- The environment, folder, signals and personality that it starts with ---
check "an empty environment" same plain env -i
check "... for the hall" same hall env -i
long=$(head -c 120000 /dev/zero | tr '\0' x)
check "a huge environment" same plain env A="$long" B="$long" C="$long" D="$long"
check "an odd environment" same plain env HOME=/nowhere LC_ALL=tr_TR.UTF-8 LANG=$'\xff' TERM= TZ=:/dev/zero LANGUAGE=xx XDG_RUNTIME_DIR=/ TMPDIR=/nowhere
check "no HOME" same hall env -u HOME -u XDG_RUNTIME_DIR -u XDG_CACHE_HOME
check "an empty program name" same plain bash -c 'exec -a "" "$@"' odd
check "a working folder that was removed" same plain bash -c 'mkdir gone && cd gone && rmdir ../gone && exec "$@"' odd
check "ignored signals" same plain bash -c 'trap "" INT TERM HUP CHLD PIPE USR1; exec "$@"' odd
for personality in -X -Z -B -L -3 -S --uname-2.6; do check "setarch $personality" same plain setarch $personality; done
check "setarch -X, for the hall" same hall setarch -X
for display in :99999999 nowhere.invalid:0 / :0.99 unix/:7 "$long"; do
    check "an invalid display: ${display:0:20}" refuses 1 "no X display" env DISPLAY="$display" "$odraz" --window
done

# --- Environments that only root can make ---
if [ "$(id -u)" != 0 ] || ! unshare --mount true 2>/dev/null; then
    echo "not checked without root: no /proc, full and read-only disks, setuid, another user"
    finish
fi
hide() { # hide FOLDER...: sets HIDDEN, which runs a command where these folders are empty
    local mounts
    mounts=$(printf 'mount -t tmpfs none %s && ' "$@")
    HIDDEN=(unshare --mount bash -c "$mounts"'exec "$@"' hidden)
}
for place in /dev /sys /run /var /proc; do hide $place; check "without $place" same plain "${HIDDEN[@]}"; done
hide /dev /sys /run /var /proc; check "the hall, without all of these" same hall "${HIDDEN[@]}"
# on_disk OPTIONS COMMAND: mounts a disk, runs COMMAND, and dumps onto the disk. The file `report` gets the exit status,
# stderr, and the numbers of frames and of unfinished files
on_disk() {
    unshare --mount bash -c "mkdir -p disk && mount -t tmpfs -o $1 none disk && $2"' && { "$@" 2>err; echo "exit $?"; cat err; ls -R disk | grep -c ppm$; ls -R disk | grep -c part$; true; }' disk \
        "$odraz" --dump disk/d --from 20 --to 20.8 --size 64x36 >report
}
full() { on_disk size=64k true && [ "$(sed -n 1p report)" = "exit 1" ] && grep -qE '^odraz: cannot write disk/d/frame-0005[0-9]{2}.ppm: no space left on the device$' report && [ "$(sed -n 3p report)" -ge 3 ] && [ "$(sed -n 4p report)" = 0 ]; }
check "a full disk: one line, no half-written frame" full
read_only() { on_disk size=64k "mount -o remount,ro disk" && [ "$(sed -n '1,2p' report)" = $'exit 1\nodraz: cannot write disk/d: the file system is read-only' ]; }
check "a read-only disk" read_only
check "the film runs from a read-only disk, too" same plain unshare --mount bash -c 'mkdir -p disk && mount -t tmpfs none disk && cp "$1" disk/odraz && mount -o remount,ro disk && shift && exec disk/odraz "$@"' disk

nobody=(setpriv --reuid 65534 --regid 65534 --clear-groups)
cp "$odraz" setuid
chmod 4755 setuid
mkdir -m 755 evil
for library in libpthread.so.0 libdl.so.2 libEGL.so.1 libc.so.6; do echo "not a library" >evil/$library; done
chmod 644 evil/*
setuid() { "${nobody[@]}" env "$@" ./setuid "${plain[@]}" >got.ppm 2>err && cmp plain.ppm got.ppm && [ ! -s err ]; }
check "setuid, run by nobody" setuid HOME=/
check "... does not load libraries from folders that user nobody names" setuid LD_LIBRARY_PATH=evil LD_PRELOAD=evil/libc.so.6
chmod 755 setuid
check "(a copy that is not setuid does)" eval '! setuid LD_LIBRARY_PATH=evil 2>/dev/null'
check "user nobody may not write here" refuses 1 "cannot write $WORK/mine: permission denied" "${nobody[@]}" ./setuid --dump "$WORK/mine" --from 20 --to 20.04 --size 64x36
under -u 1
threadless() { refuses 1 "without room for another thread: try --threads 1" "${nobody[@]}" "${UNDER[@]}" ./setuid "${plain[@]}" --threads 8; }
check "user nobody may start no threads: one line" threadless
one_thread() { "${nobody[@]}" "${UNDER[@]}" ./setuid "${plain[@]}" --threads 1 >got.ppm 2>err && cmp plain.ppm got.ppm; }
check "... and with --threads 1 it works" one_thread
finish
