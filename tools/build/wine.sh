# Sourced by scripts that run programs for Windows: $wine PROGRAM OPTION... runs a program. Wine keeps its copy of
# Windows, about 700 MB, in $BUILD/wine; the first script makes it. Only one script may use it at a time.
wine=$(command -v wine64 || echo /usr/lib/wine/wine64)
wine_server=$(command -v wineserver64 || echo /usr/lib/wine/wineserver64)
have_wine() { [ -x "$wine" ] && [ -x "$wine_server" ]; }

# Starts a server, which the caller must end, and sets WINE_PID. Without it each program would start its own server,
# which would inherit the pipes of the program's output and keep them open
start_wine() {
    export WINEPREFIX=$BUILD/wine WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml=;winemenubuilder.exe=d'
    mkdir -p "$WINEPREFIX"
    "$wine_server" -k || true # end the server of an interrupted run, which would show windows on another display
    "$wine_server" -f -p </dev/null >/dev/null 2>&1 &
    WINE_PID=$!
    if [ ! -e "$WINEPREFIX/system.reg" ] && ! env -u DISPLAY "$wine" wineboot -i </dev/null >"$WINEPREFIX/wineboot" 2>&1; then
        cat "$WINEPREFIX/wineboot" >&2
        return 1
    fi
    env -u DISPLAY "$wine" cmd /c exit </dev/null >/dev/null 2>&1 # starts its services
}
