# tools/ledger: the table of rooms and its warning. And what tools/measure/sweep/flags refuses.
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
check "a room's bytes are told" prints '^trace +4000 ' rooms
check "... those of the programs" prints '^intro +100 ' rooms
check "... stub and headers" prints '^stub +2500 ' rooms
check "... and the film's" prints '^the film +6600 +65536 +58936$' rooms
check "... and the rooms' shares are at most 65,536 together" test "$(awk '$1 != "the" && $3 ~ /^[0-9]+$/ { sum += $3 } END { print (sum <= 65536) }' "$WORK/printed")" = 1
check "nothing is said of rooms that keep to their shares" test ! -s "$WORK/err"
report 40000
check "a room that outgrows its share" prints '^trace +40000 .*more than its share$' rooms
check "... is told on stderr, in one line" test "$(grep -c 'trace has outgrown its share' "$WORK/err")/$(wc -l <"$WORK/err")" = 1/1
rm "$WORK/build/odraz.json"
check "a film that is not built" refuses 1 "build the film first" env BUILD="$WORK/build" "$ledger" rooms
check "... whose ledger cannot be renewed" refuses 1 "build the film first" env BUILD="$WORK/build" "$ledger" renew
check "the ledger in the repository names no folder of a machine" eval '! grep -q "\"room\"\|\"/" "$SOURCE/tools/measure/size_ledger.json"'
check "an unknown word" refuses 2 "cannot use 'colour'" "$ledger" colour
# Every folder of the engine has its row; maker is of odraz-debug
(cd "$SOURCE/intro" && find . -mindepth 2 -name '*.cpp' -not -path './maker/*') | cut -d/ -f2 | sort -u >"$WORK/folders"
report 4000
check "no room is forgotten" test "$(rooms | awk 'NR == FNR { row[$1] = 1; next } !($1 in row)' - "$WORK/folders")" = ""

flags=$SOURCE/tools/measure/sweep/flags
check "flags: an unknown word" refuses 2 "cannot use 'colour'" "$flags" colour
check "flags: an unknown set" refuses 2 "there is no set 'colour'; there are: " "$flags" files colour
check "flags: nothing to try" refuses 2 "try needs a set and flags" "$flags" try small
check "flags: help" prints 'tools/measure/sweep/flags drop SET' "$flags" --help
finish
