# tools/ledger prints the tables of rooms and of lines, and fails for a tree over its budget of lines.
. "$(dirname "$0")/common.sh"
ledger=$SOURCE/tools/ledger
# report BYTES: writes pack's report of a film of two objects. The second, in the room trace, takes BYTES
report() {
    mkdir -p "$WORK/build"
    cat >"$WORK/build/odraz.json" <<END
{"file": $((2600 + $1)), "overhead": 2500,
"objects": {"main.cpp.o": {"bytes": 300, "bits": 800}, "sky.cpp.o": {"bytes": 9000, "bits": $(($1 * 8))}}}
END
}
rooms() { BUILD=$WORK/build "$ledger" rooms 2>"$WORK/err"; }

report 4000
check "a room's bytes" prints '^trace +4000 ' rooms
check "... and the programs' bytes" prints '^intro +100 ' rooms
check "... the film's, and the change since the ledger" prints "^the film +6600 +65536 +58936 +$((6600 - $(sed -n 's/^ "file": \([0-9]*\),/\1/p' "$SOURCE/intro/size_ledger.json")))\$" rooms
echo '"file": 65000,' >"$WORK/build/odraz-windows.json"
check "... and the bytes used of the film for Windows" prints '^the \.exe +65000 +65536 +536$' rooms
check "nothing on stderr while all rooms keep to their shares" test ! -s "$WORK/err"
# Every folder of the engine has its row; maker belongs to odraz-debug
(cd "$SOURCE/intro" && find . -mindepth 2 -name '*.cpp' -not -path './maker/*') | cut -d/ -f2 | sort -u >"$WORK/folders"
check "every room has a row" test "$(awk 'NR == FNR { row[$1] = 1; next } !($1 in row)' "$WORK/printed" "$WORK/folders")" = ""
report 40000
check "a room over its share" prints '^trace +40000 .*more than its share$' rooms
check "... is reported on stderr" grep -q 'trace is over its share' "$WORK/err"
rm "$WORK/build/odraz.json"
check "a film that is not built" refuses 1 "build film and pack first" env BUILD="$WORK/build" "$ledger" rooms

# lines, in a repository of two rooms and other files
git init -q "$WORK/house"
cd "$WORK/house" || exit 1
mkdir -p tools/build intro/trace tests .ci
cp "$ledger" tools/ledger
echo "FILM=odraz" >intro/film.conf
tree=$((1 + 2 + 4 + 10 + 3 + 1 + $(wc -l <"$ledger"))) # lines of the tree
echo $((tree + 9)) >tools/build/lines
seq 2 >.ci/run && seq 4 >intro/main.cpp && seq 3 >tests/unit.cpp && seq 10 >intro/trace/trace.cpp
git add -A && git -c user.name=a -c user.email=a@b commit -qm first
lines() { tools/ledger lines "$@" 2>"$WORK/err"; }
check "lines: a room's code, sum and change" prints '^intro +4 +0 +1 +0 +5 +\+0$' lines
check "... the budget, and what is left of it" prints "^budget $((tree + 9)), left 9$" lines
check "... no line on stderr while the tree keeps its budget" test ! -s "$WORK/err"
seq 20 | tee intro/trace/{picture.{svg,jpg,exr},model.{gltf,glb,obj,mtl},data.{csv,bin,keys},README.md,film.{nfo,diz}} >/dev/null
seq 9 >intro/trace/run
git add intro/trace/[!r]*
check "... pictures, models, data, texts and untracked files do not count" prints '^intro/trace +10 +0 +0 +60 +10 +\+0$' lines
git add -A
check "... a tree that fills its budget" prints '^intro/trace +10 +0 +9 +60 +19 +\+9$' lines
echo 1 >>intro/trace/run
lines >"$WORK/rows"
check "... a tree over its budget fails" test $? = 1
check "... and a line on stderr says so" grep -q "^ledger: the tree has $((tree + 10)) lines, its budget is $((tree + 9)): " "$WORK/err"
check "... below all rows" grep -q "left -1$" "$WORK/rows"
check "... an unknown commit" refuses 1 "there is no commit 'colour'" tools/ledger lines colour
finish
