# Who includes whom, the house's first rule, read from the #include lines of intro/: only rooms below, so there is no
# cycle.
. "$(dirname "$0")/common.sh"

# A file or a folder, and what it may include besides itself. The longest matching name counts: a folder's rule does not
# apply to a file that has its own.
cat >"$WORK/rules" <<'END'
base
timeline        base
trace/quality.h base
trace/texture   trace/quality.h base
trace/scene     trace/quality.h base trace/texture
trace/rays      trace/quality.h base trace/texture trace/scene
trace/shade     trace/quality.h base trace/texture trace/scene trace/rays
trace/picture   trace/quality.h base trace/texture trace/scene trace/rays trace/shade
sound           base
radiosity       base trace
transfer        base trace radiosity
show            base timeline trace sound radiosity transfer
host            base film.h
host/linux      base host film.h
host/windows    base host film.h
start/linux     base host
start/windows   base host host/windows start
start           base host options.h output/output.h version.h film.h show/length.h timeline/track.h
options.h       base trace/quality.h base
options.cpp     base trace/quality.h trace/picture/frame.h options.h film.h
intro.h         base timeline trace/quality.h base
inside.h        base timeline trace sound radiosity transfer show intro.h
intro.cpp       base timeline trace sound radiosity transfer show intro.h inside.h
output          base host intro.h options.h
play            base host intro.h options.h output
doctor.h        base
doctor.cpp      base host start output doctor.h
main.cpp        base host start intro.h options.h output play doctor.h
record.h        base trace/quality.h options.h
record.cpp      base host intro.h options.h output play record.h
maker           base host timeline intro.h film.h maker/panel/backstage.h maker/source
maker/source    base timeline maker/source
maker/live_content.cpp base timeline trace sound radiosity transfer show intro.h inside.h maker
maker/live_tables.cpp base timeline trace sound radiosity transfer show intro.h inside.h maker
maker/panel     base timeline intro.h show/font.h trace/rays/view.h maker/panel
maker/panel/compare.cpp base maker/panel tools/picture/flip.h
maker/panel/backstage.cpp base inside.h show maker/panel
maker/panel/probe.cpp base show trace maker/panel
main_debug.cpp  base host timeline intro.h options.h play record.h film.h maker maker/panel/input.h maker/panel/steps.h
END
# ... and of the system's headers
cat >"$WORK/system" <<'END'
.               stddef.h stdint.h initializer_list
base/avx.h      immintrin.h smmintrin.h avxintrin.h avx2intrin.h fmaintrin.h x86gprintrin.h
base/gl.h       GL
host            stddef.h stdint.h
host/cpu.cpp    cpuid.h
host/linux      *
start           stddef.h stdint.h
record.cpp      *
maker           *
main_debug.cpp  *
END

# includes QUOTE: lines of FILE INCLUDED, for "..." or <...>
includes() {
    (cd "$SOURCE/intro" && grep -rE --include='*.h' --include='*.cpp' "^ *# *include *$1" .) |
        sed -E 's|^\./([^:]*):[^"<]*["<]([^">]*).*|\1 \2|'
}
# judge RULES: reads lines of FILE INCLUDED and prints those that no rule allows
judge() {
    awk '
        function inside(name, of) { return of == "*" || of == "." || name == of || index(name, of "/") == 1 }
        function rule(name, best, i) {
            for (i = 1; i <= n; ++i) if (inside(name, known[i]) && length(known[i]) > length(best)) best = known[i]
            return best
        }
        FNR == NR { known[++n] = $1; has[$1] = 1; for (i = 2; i <= NF; ++i) may[$1, ++count[$1]] = $i; next }
        {
            from = rule($1); to = rule($2)
            good = from != "" && from != "." && from == to
            for (i = 1; i <= count[from]; ++i) {
                name = may[from, i]
                if (inside($2, name) && (name == to || !has[name])) good = 1
            }
            if (!good) print "    " $1 " includes " $2 (from == "" ? ", and no rule names it" : "")
        }' "$1" -
}
obeys() { # obeys RULES QUOTE
    includes "$2" >"$WORK/includes"
    [ "$(wc -l <"$WORK/includes")" -ge 20 ] || { echo "no includes were found" >&2; return 1; }
    judge "$1" <"$WORK/includes" >"$WORK/wrong"
    cat "$WORK/wrong" >&2
    [ ! -s "$WORK/wrong" ]
}
there() { # what is included lies in intro/, unless it is generated; makers also have FLIP
    local file included missing=0
    while read -r file included; do
        [ -e "$SOURCE/intro/$included" ] || [ "$included" = version.h ] || [ "$included" = film.h ] || [ "$file $included" = "maker/panel/compare.cpp tools/picture/flip.h" ] || { echo "    $file includes $included, which is not in intro/" >&2; missing=1; }
    done <"$WORK/includes"
    return $missing
}
check "rooms include what is below them" obeys "$WORK/rules" '"'
check "... and nothing outside intro/" there
check "platforms stay behind host/linux" obeys "$WORK/system" '<'

# The film's build names nothing in tests/, and in tools/ only tools/build/
grep -rnE '\$\{CMAKE_SOURCE_DIR\}/|\.\./' --include=CMakeLists.txt "$SOURCE/intro" "$SOURCE/packer" | sed "s|^$SOURCE/||" >"$WORK/named"
check "the film's build names tools/build" grep -q '/tools/build/' "$WORK/named"
check "... nothing else of tools, and no tests" lacks '\}/(tests|tools/[^b]|tools/b[^u])|\.\./(tests|tools)' "$WORK/named"
if command -v ninja >/dev/null && [ -e "$BUILD/build.ninja" ]; then
    ninja -C "$BUILD" -t inputs odraz odraz-safe | sed "s|^$SOURCE/||" >"$WORK/inputs"
    check "the film is made of files of intro and packer" grep -qx 'intro/main.cpp' "$WORK/inputs"
    check "... and none of tests" lacks '^tests/' "$WORK/inputs"
    check "... and of tools only tools/build" lacks '^tools/([^b]|b[^u])' "$WORK/inputs"
fi

# Violations are found, one of each kind
finds() { [ "$(judge "$1" <<<"$2" | wc -l)" = 1 ]; }
for violation in "base/text.h host/files.h" "timeline/shot.h show/show.h" "trace/texture/noise.cpp trace/scene/scene.h" \
    "trace/quality.h trace/scene/shape.h" "trace/rays/view.h trace/picture/frame.h" "host/window.h start/early.h" "sound/score.h timeline/track.h" \
    "radiosity/solve.h transfer/relight.h" "transfer/room.h show/hall.h" "show/hall.cpp host/headless.h" "start/start.cpp trace/picture/frame.h" \
    "start/early.cpp show/show.h" "play/player.cpp inside.h" "play/player.cpp trace/picture/frame.h" "play/music.cpp start/early.h" \
    "output/dump.cpp inside.h" "output/wav.cpp play/music.h" "output/wav.cpp sound/mixer.h" "start/start.cpp output/dump.h" "show/film.cpp play/film_clock.h" "intro.cpp play/player.h" \
    "main_debug.cpp output/dump.h" "main_debug.cpp maker/panel/probe.h" "maker/panel/strip.cpp show/show.h" "play/player.cpp maker/panel/panel.h" "maker/panel/canvas.cpp tools/picture/flip.h" "main.cpp trace/quality.h" "host/files.h host/linux/sys.h" "host/windows/files.cpp host/linux/sys.h" "start/memory.cpp host/linux/sys.h" "start/start.cpp host/windows/windows.h" "intro.cpp host/files.h" "new/room.cpp base/text.h" "new.cpp base/text.h"; do
    check "(it would be found that ${violation/ / includes })" finds "$WORK/rules" "$violation"
done
for violation in "host/window.h X11/Xlib.h" "show/hall.cpp GL/gl.h" "start/start.cpp unistd.h" "trace/picture/frame.cpp vector"; do
    check "(it would be found that ${violation/ / includes })" finds "$WORK/system" "$violation"
done
finish
