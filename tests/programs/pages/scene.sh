# The scene of intro/show/README.md, made by its steps, word for word, in a copy of the sources. What the change
# touches is compiled and linked with the objects of BUILD. With `long`, the copy is built from nothing instead, by the
# page's commands: bash tests/programs/pages/scene.sh BUILD [long]
. "$(dirname "$0")/../common.sh"
PAGE=intro/show/README.md
HOUSE=$WORK/house

copy_sources "$HOUSE"
follow() { perl "$SOURCE/tests/programs/pages/apply.pl" "$HOUSE/$PAGE" "$HOUSE" | sort -u >"$WORK/changed"; return "${PIPESTATUS[0]}"; }
check "the page's steps name files and places that are there" follow
[ $FAILED = 0 ] || finish

if [ "${2-}" = long ]; then
    . "$SOURCE/tests/programs/display.sh"
    start_display 1280x720
    cd "$HOUSE"
    git init -q . && git add -A && git -c user.name=odraz -c user.email=odraz@localhost commit -qm "A scene more"
    perl "$SOURCE/tests/programs/pages/blocks.pl" "$PAGE" | cut -d ' ' -f 2- >"$WORK/commands"
    while read -r command; do
        case $command in
        *new-film*) ;; # long/new_film.sh tests it
        *show_test*) eval "$command" >"$WORK/printed" 2>&1 ;; # it fails, see below
        *odraz-debug*)
            check "$command" opens "$command" ;;
        *) check "$command" eval "$command >/dev/null </dev/null" ;;
        esac
    done <"$WORK/commands"
else
    needs_built tests/show_test
    command -v ninja >/dev/null && [ -e "$BUILD/build.ninja" ] || { echo "SKIPPED: $BUILD was not built by ninja"; exit 77; }
    # The folder of a build with links to what BUILD has
    mkdir "$HOUSE/build"
    cd "$HOUSE/build"
    of_build() { ninja -C "$BUILD" -t "$@"; }
    for file in $(of_build inputs odraz.elf tests/show_test | grep -E '\.(a|o|so)$' | grep -v '^/'); do
        mkdir -p "$(dirname "$file")"
        ln -s "$BUILD/$file" "$file"
    done
    # What includes a file that changed is compiled again, and what is new in the room's list
    of_build deps >"$WORK/deps"
    awk '
        NR == FNR { changed[$1] = 1; next }
        /^[^ ]/ { object = $1; sub(/:$/, "", object); next }
        { sub(/^.*\/intro\//, "intro/") }
        $1 in changed { print object }' "$WORK/changed" "$WORK/deps" | sort -u >"$WORK/touched"
    : >"$WORK/objects"
    for object in $(cat "$WORK/touched"); do [ ! -L "$object" ] || { rm "$object" && echo "$object"; } >>"$WORK/objects"; done
    here() { sed "s|-Map=$BUILD/|-Map=|; s|$BUILD/|@|g; s|$SOURCE/|$HOUSE/|g; s|-I$SOURCE |-I$HOUSE |g; s|@|$BUILD/|g; s/^ccache //"; }
    for object in $(cat "$WORK/objects"); do of_build commands -s "$object"; done | here >"$WORK/compile"
    engine=intro/CMakeFiles/engine.dir
    for source in $(grep -oE '[a-z_/]+\.cpp' "$HOUSE/intro/show/CMakeLists.txt"); do
        [ -e "$engine/show/$source.o" ] || grep -qx "$engine/show/$source.o" "$WORK/objects" || {
            of_build commands -s $engine/show/film.cpp.o | here | sed "s|show/film\.cpp|show/$source|g" >>"$WORK/compile"
            echo "$engine/show/$source.o" >>"$WORK/objects"
        }
    done
    compile() { xargs -P "$(nproc)" -d '\n' -I COMMAND sh -c COMMAND <"$WORK/compile" 2>"$WORK/printed"; cat "$WORK/printed" >&2; [ ! -s "$WORK/printed" ]; }
    check "it compiles, without a warning" compile
    [ $FAILED = 0 ] || finish
    check "... with the new scene" grep -qx $engine/show/scenes/dawn.cpp.o "$WORK/objects"
    link() {
        rm libengine.a
        ar qcs libengine.a $(find $engine -name '*.o') || return 1
        for program in odraz.elf tests/show_test; do eval "$(of_build commands -s $program | here)" || return 1; done
    }
    mkdir -p tests
    check "it is linked" link
    ./odraz.elf --dump "$HOUSE/frames" --fps 1 --from 164 --to 165 --size 160x90
    tests/show_test >"$WORK/printed" 2>&1
fi

# A picture that is not black: the mean of its bytes
mean() { tail -c +16 "$1" | od -An -v -tu1 | awk '{ for (i = 1; i <= NF; ++i) sum += $i; n += NF } END { print sum / n }'; }
check "the scene is seen" less 20 "$(mean "$HOUSE"/frames/frame-000164.ppm)"
# The film is a second too long, and nothing else
check "show_test finds the length wrong" grep -q 'duration()' "$WORK/printed"
check "... and nothing else" [ "$(sed -n 's/^\[  FAILED  \] \([A-Za-z.]*\)$/\1/p' "$WORK/printed")" = Film.HasTheCutsAndTheLengthOfItsTreatment ]
check "... in one line" [ "$(grep -c ': Failure' "$WORK/printed")" = 1 ]
finish
