# Sourced by tests of programs for Windows, which Wine runs: "$wine" PROGRAM OPTION... One at a time, since they share what
# Wine keeps of Windows, some 700 MB in BUILD/wine, which the first of them makes.
. "$(dirname "$0")/../common.sh"
wine=$(command -v wine64 || echo /usr/lib/wine/wine64)
server=$(command -v wineserver64 || echo /usr/lib/wine/wineserver64)
[ -x "$wine" ] && [ -x "$server" ] || { echo "SKIPPED: Wine (wine64) is not installed"; exit 77; }
export WINEPREFIX=$BUILD/wine WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml=;winemenubuilder.exe=d'
unset DISPLAY

# It serves until the test ends: else each program starts another, which would inherit the pipes that a test reads
mkdir -p "$WINEPREFIX"
"$server" -f -p </dev/null >/dev/null 2>&1 &
PIDS+=($!)
if [ ! -e "$WINEPREFIX/system.reg" ] && ! timeout "$PATIENCE" "$wine" wineboot -i </dev/null >"$WORK/wineboot" 2>&1; then
    cat "$WORK/wineboot" >&2
    exit 1
fi
"$wine" cmd /c exit </dev/null >/dev/null 2>&1 # starts its services
