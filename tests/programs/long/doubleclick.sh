# A double-click starts the film in an unpacked archive of tools/release: in Thunar and PCManFM with their default
# settings, and in Nemo and Caja where these are installed.
#
# Tried by hand on 2026-11-23, as a user with a system bus: Nautilus 43.2 starts it; without the x bit it reports that
# it could not display the file. Dolphin 22.12.3 asks, with and without the x bit, and starts it on "Execute".
#   bash tests/programs/long/doubleclick.sh BUILD [ARCHIVE.tar.gz]
. "$(dirname "$0")/../display.sh"
skip_unless openbox thunar pcmanfm dbus-run-session convert
export LC_ALL=C # Alt-E answers the question, which must be in English
QUIET=20        # seconds after which a film that has not started will not start
archive=${2-}
if [ -z "$archive" ]; then
    skip_unless zip unzip
    git -C "$SOURCE" rev-parse HEAD >/dev/null 2>&1 || { echo "SKIPPED: a release needs a git repository"; exit 77; }
    BUILD=$BUILD "$SOURCE/tools/release" --built --unclean --no-capture --poster "$SOURCE/intro/film.png" --to "$WORK/release" >/dev/null || exit 1
    archive=$(echo "$WORK"/release/*.tar.gz)
fi
mkdir "$WORK/unpacked" "$WORK/film"
tar -C "$WORK/unpacked" -xf "$archive"
file=$WORK/film/odraz
mv "$(find "$WORK/unpacked" -name odraz -type f)" "$file" || exit 1

running() { # sets film: the process that runs the file
    local exe
    for exe in /proc/[0-9]*/exe; do
        [ "$(readlink "$exe" 2>/dev/null)" != "$file" ] || { film=${exe//[^0-9]/}; return 0; }
    done
    return 1
}
windows() { xdotool search --onlyvisible --name . 2>/dev/null | sort; }
opened() { windows >"$WORK/now"; [ -n "$(comm -13 "$WORK/before" "$WORK/now")" ]; }
found() { # sets spot, the icon's position: the middle of the tallest region that changes when it is selected
    xdotool key Escape
    sleep 0.5
    import -window root "$WORK/folder.png"
    xdotool key ctrl+a
    sleep 1
    import -window root "$WORK/selected.png"
    spot=$(convert "$WORK/folder.png" "$WORK/selected.png" -compose difference -composite -colorspace gray -threshold 3% \
        -morphology close square:4 -define connected-components:verbose=true -connected-components 8 null: | awk '
        /gray\(255\)/ {
            split($2, box, /[x+]/)
            if (box[1] > 30 && box[2] > height) { height = box[2]; at = int(box[3] + box[1] / 2) " " int(box[4] + height / 2) }
        }
        END { if (height >= 18) print at }')
    [ -n "$spot" ]
}
clicks() { xdotool mousemove $spot sleep 0.3 click --repeat 2 --delay 120 1; last=$SECONDS; }
answered() { # succeeds when the film's window is there; answers a question, and repeats a click without effect
    ! seen || return 0
    running || ! opened || {
        sleep 1 # the question may not have the keyboard yet
        ! seen || return 0
        asks=1 last=$SECONDS
        xdotool key alt+e
    }
    running || opened || [ $SECONDS -le $((last + QUIET)) ] || clicks
    return 1
}
clicked() { # double-clicks the icon; sets outcome
    await opened || { outcome="no window: $(tail -n 1 "$WORK/log")"; return; }
    await found || { outcome="no icon"; return; }
    xdotool key Escape
    windows >"$WORK/before"
    clicks
    asks=
    PATIENCE=$patience await answered || { running && await seen; } || { outcome="${asks:+asks, and }does not start it"; return; }
    outcome="${asks:+asks, then }starts it"
    running || outcome="starts another film"
    sleep 1
    await eval 'xdotool key Escape; ! running' || outcome+=", which ESC does not end"
}
# double_click MANAGER: opens the folder with default settings and double-clicks the film; sets outcome
double_click() {
    local home=$WORK/$1.$RANDOM group
    mkdir -m 700 "$home"
    windows >"$WORK/before"
    set -m
    env HOME="$home" XDG_CONFIG_HOME="$home/.config" XDG_DATA_HOME="$home/.local/share" XDG_CACHE_HOME="$home/.cache" \
        XDG_RUNTIME_DIR="$home" GTK_A11Y=none NO_AT_BRIDGE=1 dbus-run-session -- "$1" "$WORK/film" >"$WORK/log" 2>&1 &
    group=$!
    set +m
    clicked
    ! running || kill "$film"
    # The process group contains the manager, its bus, and all that they started
    kill -TERM -- "-$group"
    PATIENCE=5 await eval "! kill -0 -- -$group" 2>/dev/null || kill -KILL -- "-$group" 2>/dev/null
}
does() { # does OUTCOME MANAGER: succeeds if the double-click has that outcome
    local patience=$PATIENCE
    [[ $1 != *not* ]] || patience=$QUIET
    double_click "$2"
    [[ $outcome = $1 ]] || { echo "$2: '$outcome', wanted '$1'" >&2; return 1; }
}

start_display 1024x768
start_window_manager
check "Thunar starts it" does "starts it" thunar
check "PCManFM asks, and starts it" does "asks, then starts it" pcmanfm
others=()
for manager in nemo caja; do ! command -v $manager >/dev/null || others+=($manager); done
for manager in "${others[@]}"; do check "$manager starts it" does "starts it" $manager; done
chmod a-x "$file"
for manager in thunar pcmanfm "${others[@]}"; do check "without the x bit $manager does not start it" does "*does not start it" $manager; done
finish
