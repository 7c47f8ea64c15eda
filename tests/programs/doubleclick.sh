# A double-click starts the film that lies in the unpacked archive of tools/release: in Thunar and PCManFM with their
# default settings, and in Nemo and Caja where these are installed.
#
# By hand, on 2026-11-23, as a user with a system's bus: Nautilus 43.2 starts it; without the x bit it reports that it
# could not display the file. Dolphin 22.12.3 asks, with and without the x bit, and starts it on "Execute".
#   bash tests/programs/doubleclick.sh BUILD [ARCHIVE.tar.gz]
. "$(dirname "$0")/display.sh"
skip_unless openbox thunar pcmanfm dbus-run-session convert
archive=${2-}
if [ -z "$archive" ]; then
    skip_unless zip unzip
    git -C "$SOURCE" rev-parse HEAD >/dev/null 2>&1 || { echo "SKIPPED: a release is made of a commit, and here is no repository"; exit 77; }
    BUILD=$BUILD "$SOURCE/tools/release" --built --unclean --no-capture --poster "$SOURCE/intro/film.png" --to "$WORK/release" >/dev/null || exit 1
    archive=$(echo "$WORK"/release/*.tar.gz)
fi
mkdir "$WORK/unpacked" "$WORK/film"
tar -C "$WORK/unpacked" -xf "$archive"
mv "$(find "$WORK/unpacked" -name odraz -type f)" "$WORK/film/odraz" || exit 1

start_display 1024x768
start_window_manager
does() { # does RESULT MANAGER
    local result
    result=$("$SOURCE/tests/support/double_click" "$2" "$WORK/film/odraz")
    [ "$result" = "$1" ] || { echo "$2: '$result', wanted '$1'" >&2; return 1; }
}
check "Thunar starts it" does "starts it" thunar
check "PCManFM asks, and starts it" does "asks, then starts it" pcmanfm
for manager in nemo caja; do
    ! command -v $manager >/dev/null || check "$manager starts it" does "starts it" $manager
done
chmod a-x "$WORK/film/odraz"
does_not() { "$SOURCE/tests/support/double_click" "$1" "$WORK/film/odraz"; [ $? = 1 ]; }
check "without the x bit Thunar does not" does_not thunar
check "... nor PCManFM" does_not pcmanfm
for manager in nemo caja; do
    ! command -v $manager >/dev/null || check "... nor $manager" does_not $manager
done
finish
