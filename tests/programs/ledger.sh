# tools/ledger: the table of rooms and its warning; and what tools/measure/sweep/flags refuses.
. "$(dirname "$0")/common.sh"
ledger=$SOURCE/tools/ledger
# report BYTES: a report on a film of two objects, of which the second lies in the sky's room
report() {
    mkdir -p "$WORK/build"
    cat >"$WORK/build/odraz.json" <<END
{
"file": $((2600 + $1)),
"overhead": 2500,
"sections": {
".text": {"bytes": 9000, "bits": 9000}
},
"objects": {
"main.cpp.o": {"bytes": 300, "bits": 800},
"sky.cpp.o": {"bytes": 9000, "bits": $(($1 * 8))}
},
"symbols": {
"sky.cpp.o": {"bytes": 9000, "bits": 9000}
}
}
END
}
rooms() { BUILD=$WORK/build "$ledger" rooms 2>"$WORK/err"; }

report 4000
check "a room's bytes" prints '^trace +4000 ' rooms
check "... those of the programs" prints '^intro +100 ' rooms
check "... stub and headers" prints '^stub +2500 ' rooms
check "... and the film's" prints '^the film +6600 +65536 +58936$' rooms
check "... and the rooms' shares are at most 65,536 together" test "$(awk '$1 != "the" && $3 ~ /^[0-9]+$/ { sum += $3 } END { print (sum <= 65536) }' "$WORK/printed")" = 1
check "nothing on stderr while all rooms keep to their shares" test ! -s "$WORK/err"
report 40000
check "a room that outgrows its share" prints '^trace +40000 .*more than its share$' rooms
check "... is reported on stderr, in one line" test "$(grep -c 'trace has outgrown its share' "$WORK/err")/$(wc -l <"$WORK/err")" = 1/1
rm "$WORK/build/odraz.json"
check "a film that is not built" refuses 1 "build film and pack first" env BUILD="$WORK/build" "$ledger" rooms
check "... whose ledger cannot be renewed" refuses 1 "build film and pack first" env BUILD="$WORK/build" "$ledger" renew
check "the ledger in the repository names no folder of a machine" eval '! grep -q "\"room\"\|\"/" "$SOURCE/intro/size_ledger.json"'
check "an unknown word" refuses 2 "cannot use 'colour'" "$ledger" colour
# Every folder of the engine has its row; maker is of odraz-debug
(cd "$SOURCE/intro" && find . -mindepth 2 -name '*.cpp' -not -path './maker/*') | cut -d/ -f2 | sort -u >"$WORK/folders"
report 4000
check "no room is forgotten" test "$(rooms | awk 'NR == FNR { row[$1] = 1; next } !($1 in row)' - "$WORK/folders")" = ""

# lines: a repository with two rooms and the rest
git init -q "$WORK/house"
cd "$WORK/house" || exit 1
mkdir -p tools/build intro/trace tests intro/tests
cp "$ledger" tools/ledger
echo "FILM=odraz" >intro/film.conf
printf '%s\n' ". 1000" "intro 5" "intro/trace 10" "tests 9" "tools 1000" "(free) 7" >tools/build/lines
commit() { git add -A && git -c user.name=a -c user.email=a@b commit -qm "$1"; }
seq 4 >intro/main.cpp && seq 3 >tests/unit.cpp && seq 8 >intro/trace/README.md
commit first
lines() { tools/ledger lines "$@" 2>"$WORK/err"; }
check "lines: a room's code, budget, rest and change" prints '^intro +4 +0 +1 +0 +5 +5 +0 +\+0$' lines
check "... no line on stderr while all rooms keep their budgets" test ! -s "$WORK/err"
seq 11 >intro/trace/trace.cpp && seq 2 >intro/trace/run && seq 5 >tests/run.sh
check "... files that git does not track do not count" prints '^intro/trace +0 +0 +0 +8 +0 +10 +10 +\+0$' lines
seq 20 | tee intro/trace/picture.svg intro/trace/data.csv >/dev/null
git add -A
check "... a planted file moves the number, and the room is over" prints '^intro/trace +11 +0 +2 +8 +13 +10 +-3 +\+13  over$' lines
check "... which one line on stderr reports" test "$(cat "$WORK/err")" = "ledger: intro/trace has 13 lines, its budget is 10: make it smaller, or another room (tools/build/lines)"
check "... tests are tests, whatever they are written in" prints '^tests +0 +8 +0 +0 +8 +9 +1 +\+5$' lines
commit second
check "... the change is that since the budgets were renewed" prints '^intro/trace .* \+13  over$' lines
check "... or since a commit that is named" prints '^intro/trace .* \+0  over$' lines HEAD
check "... the sum and its budget" prints '^all .* 2031 +[0-9]+ +\+18$' lines
check "... a commit that is not there" refuses 1 "there is no commit 'colour'" tools/ledger lines colour
cd "$SOURCE" || exit 1
check "the budgets of the repository are at most 76,000 lines together" test "$(awk '!/^#/ { sum += $2 } END { print (sum <= 76000) }' tools/build/lines)" = 1
check "... and every room is a folder" eval '! grep -v "^#\|^(free)" tools/build/lines | while read -r room _; do [ -d "$room" ] || echo; done | grep -q .'

flags=$SOURCE/tools/measure/sweep/flags
check "flags: an unknown word" refuses 2 "cannot use 'colour'" "$flags" colour
check "flags: an unknown set" refuses 2 "there is no set 'colour'; there are: " "$flags" files colour
check "flags: nothing to try" refuses 2 "try needs a set and flags" "$flags" try small
check "flags: help" prints 'tools/measure/sweep/flags drop SET' "$flags" --help
finish
