# cmake --install puts the tools and their READMEs under a prefix, and each tool runs there.
. "$(dirname "$0")/common.sh"
skip_unless cmake
needs_built pack compare radiosity
prefix=$WORK/prefix
check "the tools are installed" eval 'cmake --install "$BUILD" --prefix "$prefix" >/dev/null'
cd "$prefix/bin" || exit 1
here=(*)
echo "${here[*]}"
for program in pack compare radiosity; do check "$program is there" test -x $program; done
for program in "${here[@]}"; do check "$program has a --help" prints '^[Uu]sage: ' "./$program" --help; done
check "the installed pack works" prints 'bytes left' bash "$SOURCE/packer/example/build.sh" ./pack "$WORK"
check "... a program that runs" exits 7 "hello, 1 words, 42" "$WORK/hello"
check "the installed radiosity works" bash -c './radiosity generate cube -o "$1/cube.obj" >/dev/null && exec ./radiosity solve "$1/cube.obj" -o "$1/cube.rad" >/dev/null 2>&1' - "$WORK"
doc=$prefix/share/doc/$FILM
check "their READMEs are there" test -s "$doc/pack/README.md" -a -s "$doc/radiosity/README.md" -a -s "$doc/radiosity/METHOD.md" -a -s "$doc/CI.md" -a -s "$doc/LICENSE.txt"
check "... and nothing else is installed" test "$(cd "$prefix" && echo *)" = "bin share"
finish
