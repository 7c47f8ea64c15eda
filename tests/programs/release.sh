# tools/release makes archives that are equal in two runs, unpack with their file modes, and contain a film that runs.
. "$(dirname "$0")/common.sh"
skip_unless zip unzip tar gzip sha256sum
git -C "$SOURCE" rev-parse HEAD >/dev/null 2>&1 || { echo "SKIPPED: a release needs a git repository"; exit 77; }
needs_built portable/radiosity
export BUILD
release=$SOURCE/tools/release
made=("$release" --built --unclean --no-capture --poster "$SOURCE/intro/film.png")

check "archives are made" prints ' .*/odraz-.*\.zip$' "${made[@]}" --to "$WORK/one"
pages=$(ls "$BUILD/odraz.html" 2>/dev/null | wc -l)
check "... three, or five with the page and its index, and nothing else" test "$(ls -A "$WORK/one" | wc -l)" = $((3 + 2 * pages))
sleep 1.1 # another second
again=("$release" --built --unclean --poster "$SOURCE/intro/film.png" --capture-span 20,20.1 --to "$WORK/two")
command -v ffmpeg >/dev/null || again+=(--no-capture)
check "... and again, with another umask and time zone, and a short video" bash -c 'umask 077; TZ=Asia/Tokyo; export TZ; exec "$@" >/dev/null 2>&1' - "${again[@]}"
check "... with the same bytes" test "$(diff -r "$WORK/one" "$WORK/two" | grep -v "^Only in $WORK/two: odraz-1080p60\.")" = ""
if command -v ffmpeg >/dev/null; then
    check "the video is 1080p60, with sound" test "$(ffprobe -v error -show_entries stream=codec_name,width,height,r_frame_rate,nb_frames -of csv=p=0 "$WORK/two/odraz-1080p60.mp4" | tr '\n' ' ' | grep -cE '^h264,1920,1080,60/1,6 aac,')" = 1
    check "... with its manifest, and nothing more" test "$(ls -A "$WORK/two" | wc -l)" = $((5 + 2 * pages))
fi
tgz=$(echo "$WORK"/one/odraz-[0-9]*.tar.gz) zip=$(echo "$WORK"/one/*.zip)
name=$(basename "$tgz" .tar.gz)
check "the name has the version" test "$name" = "odraz-$("$BUILD/odraz-safe" --version | cut -d' ' -f2)-unclean"

modes() { (cd "$WORK/$1/$name" && find . -type f -printf '%m %f\n' | LC_ALL=C sort | tr '\n' ,); }
unpacked() { # unpacked HOW PROGRAMS-FOR-WINDOWS COMMAND...: unpacks by the command, and checks the files
    local how=$1 exe=${2#0} files=$((7 + $2))
    shift 2
    mkdir "$WORK/$how"
    check "$how unpacks" eval "(umask 022; cd '$WORK/$how' && $*)"
    check "... with its modes" test "$(modes "$how")" = "644 LICENSE.txt,644 README.txt,644 SHA256SUMS,644 file_id.diz,${exe:+644 odraz-safe.exe,644 odraz.exe,}644 odraz.nfo,644 poster.png,755 odraz,755 odraz-safe,"
    check "... and its checksums are right" eval "(cd '$WORK/$how/$name' && sha256sum -c --quiet --strict SHA256SUMS)"
    check "... and cover all files" test "$(wc -l <"$WORK/$how/$name/SHA256SUMS")" = $files
}
unpacked tar 0 tar -xzf "$tgz"
unpacked unzip 2 unzip -q "$zip"
if command -v bsdtar >/dev/null; then unpacked bsdtar 2 bsdtar -xf "$zip"; fi
inside=$WORK/unzip/$name
check "the film is the one that was built" cmp "$inside/odraz" "$BUILD/odraz"
for exe in odraz odraz-safe; do check "... for Windows, too, $exe.exe" cmp "$inside/$exe.exe" "$BUILD/$exe.exe"; done
check "... and runs" "$inside/odraz" --dump "$WORK/frames" --from 20 --to 20.04 --size 64x36

# The texts (tools/release itself counts their columns)
filled() { ! grep -rn '@[A-Z][A-Z_]*@' "$inside"/*.{txt,nfo,diz}; }
plain() { ! LC_ALL=C grep -naP '[^\x20-\x7e\r]' "$inside"/*.{txt,nfo,diz}; }
check "no placeholder is left" filled
check "every character is ASCII, and so has the same code in CP437" plain
check "the NFO's lines end with CR LF" test "$(grep -c $'\r$' "$inside/odraz.nfo")" = "$(wc -l <"$inside/odraz.nfo")"
check "... and has the size for Windows" grep -q "$(stat -c %s "$BUILD/odraz.exe" | sed 's/...$/,&/') bytes" "$inside/odraz.nfo"
check "... and has the size" grep -q "$(stat -c %s "$BUILD/odraz" | sed 's/...$/,&/') bytes" "$inside/odraz.nfo"
for word in ESC 'chmod +x' scanner libdl.so.2 --doctor AVX2 Wine odraz.exe; do check "README.txt mentions $word" grep -qF -e "$word" "$inside/README.txt"; done

# The index links to all files, and to no others
if [ "$pages" = 1 ]; then
    links() { grep -oE '(href|src)="[^"]*"' "$WORK/one/index.html" | cut -d'"' -f2 | sort -u; }
    check "the index has links to all files" test "$(links)" = "$(ls "$WORK/one" | grep -vx index.html | LC_ALL=C sort)"
    check "... and no placeholder is left" lacks '@[A-Z_]*@' "$WORK/one/index.html"
fi
check "the tools' archive alone" prints "odraz-tools-.*gz\$" "$release" --built --unclean --only tools --to "$WORK/tools"
check "... have the same files, in one archive" diff <(tar -tzf "$WORK"/tools/*) <(tar -tzf "$WORK"/one/odraz-tools-*)
check "... nothing else can be made alone" refuses 2 "--only needs tools, not 'film'" "$release" --only film

# The tools' archive, which also runs on older systems
tools=odraz-tools-${name#odraz-}-linux-x86_64
check "the tools unpack" tar -C "$WORK" -xzf "$WORK/one/$tools.tar.gz"
cd "$WORK/$tools" || exit 1
check "... and their checksums are right" sha256sum -c --quiet --strict SHA256SUMS
check "... and cover all files" test "$(wc -l <SHA256SUMS)" = "$(find . -type f ! -name SHA256SUMS | wc -l)"
check "... with their READMEs and licences" test -s doc/pack/README.md -a -s doc/radiosity/README.md -a -s doc/radiosity/METHOD.md -a -s doc/CI.md -a -s LICENSE.txt -a -s NOTICES.txt
check "no placeholder is left" eval '! grep -nE "@[A-Za-z][A-Za-z_-]*@" README.txt'
check "their README has 80 columns" test "$(wc -L <README.txt)" -le 80
for program in compare pack radiosity; do
    check "$program runs, and prints its help" prints '^[Uu]sage: ' "./$program" --help
    check "... README.txt lists it" grep -q "^  $program  " README.txt
    objdump -p $program >"$WORK/needs"
    if [ $program = radiosity ]; then
        check "... it needs glibc alone" test "$(sed -n 's/^ *NEEDED *//p' "$WORK/needs" | grep -cvE '^(libc|libm|libdl|libpthread|ld-linux-x86-64)\.so\.[0-9]$')" = 0
        newest=$(grep -oE 'GLIBC_[0-9.]+' "$WORK/needs" | sort -uV | tail -n 1)
        check "... of 2.31 or earlier ($newest)" test "$(printf '%s\n' GLIBC_2.31 "$newest" | sort -V | tail -n 1)" = GLIBC_2.31
    else
        check "... it needs no library" lacks 'NEEDED' "$WORK/needs"
    fi
done
check "radiosity solves" bash -c './radiosity generate cube -o "$1/cube.obj" >/dev/null && ./radiosity solve "$1/cube.obj" -o "$1/cube.rad" >/dev/null 2>&1' - "$WORK"
check "... with the same result as the one in build/" bash -c '"$2" solve "$1/cube.obj" -o "$1/same.rad" >/dev/null 2>&1 && cmp "$1/cube.rad" "$1/same.rad"' - "$WORK" "$BUILD/radiosity"
check "... and reports what is wrong with a file" refuses 2 "cannot read" ./radiosity solve "$WORK/needs.obj" -o "$WORK/x"
cd "$WORK" || exit 1

# Wrong arguments and programs are refused
check "a poster that is not a picture" refuses 2 "is not a PNG" "$release" --poster "$BUILD/odraz"
check "a folder that cannot be made" refuses 1 "cannot write to" "${made[@]}" --to /proc/here
check "programs that are not built" env BUILD="$WORK" bash -c '"$@" 2>&1 | grep -q "is not built"' - "${made[@]}" --to "$WORK/three"
refuses_unclean() { # a + after the version: the program was built from a tree that differs from its commit
    mkdir "$WORK/other"
    printf '#!/bin/sh\necho odraz 1.2.3 0123456789ab+\n' >"$WORK/other/odraz"
    chmod +x "$WORK/other/odraz"
    for other in odraz-safe odraz.exe odraz-safe.exe; do cp "$WORK/other/odraz" "$WORK/other/$other"; done
    BUILD=$WORK/other refuses 1 "the tree differs from its commit" "$release" --built --no-capture --poster "$SOURCE/intro/film.png" --to "$WORK/three"
}
check "a build of a tree that differs from its commit" refuses_unclean
sed -i 's/ab+/ab/' "$WORK"/other/odraz*
check "a build of another commit" env BUILD="$WORK/other" bash -c '"$@" 2>&1 | grep -q "is from commit 0123456789ab, not from"' - "$release" --built --no-capture --poster "$SOURCE/intro/film.png" --to "$WORK/three"
cp "$BUILD/odraz" "$BUILD/odraz-safe" "$WORK/other"
check "a build for Windows of another commit" env BUILD="$WORK/other" bash -c '"$@" 2>&1 | grep -q "odraz-safe.exe is from another build"' - "${made[@]}" --to "$WORK/three"
cp "$BUILD/odraz-safe.exe" "$BUILD/pack" "$WORK/other"
check "... a packed film of another build" env BUILD="$WORK/other" bash -c '"$@" 2>&1 | grep -q "odraz.exe is from another build"' - "${made[@]}" --to "$WORK/three"
check "refusals leave nothing" test -z "$(ls -A "$WORK/three")"
# In a small repository the programs are built from the commit, but the figures are stale
mkdir -p "$WORK"/house/{intro,build,tools/measure}
cd "$WORK/house" || exit 1
cp "$SOURCE/intro/film.conf" intro
cp -r "$SOURCE"/tools/{release,build} tools
printf '#!/bin/sh\necho "stale: size: since 0123456789ab intro"\nexit 1\n' >tools/measure/all
chmod +x tools/measure/all
git init -q . && git add --all tools intro && git -c user.name=test -c user.email=test commit -q -m one
for program in odraz odraz-safe odraz.exe odraz-safe.exe; do
    printf '#!/bin/sh\necho odraz 1.2.3 %s\n' "$(git rev-parse --short=12 HEAD)" >build/$program
    chmod +x build/$program
done
stale=(env BUILD="$PWD/build" tools/release --built --no-capture --poster "$SOURCE/intro/film.png" --to "$WORK/three")
check "stale figures are refused" bash -c '! "$@" 2>"$0" && grep -q "^stale: size:" "$0"' "$WORK/err" "${stale[@]}"
check "... but not with --unclean" bash -c '! "$@" 2>"$0" && ! grep -q stale "$0"' "$WORK/err" "${stale[@]}" --unclean
finish
