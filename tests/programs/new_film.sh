# tools/new-film refuses wrong arguments with one line, and leaves no files. (long/new_film.sh makes and tests a film.)
. "$(dirname "$0")/common.sh"
git -C "$SOURCE" rev-parse HEAD >/dev/null 2>&1 || { echo "SKIPPED: a new film needs a git repository"; exit 77; }
new=$SOURCE/tools/new-film to=$WORK/made
check "--help" prints '^usage: tools/new-film DIR NAME' "$new" --help
check "no arguments" refuses 2 "name a folder and the film" "$new"
for name in "" "twelveletter" "a film" "a_b" "a.b" "a/b" "película" $'a\nb'; do
    check "the name '${name//$'\n'/ }'" refuses 2 "a name has 1 to 11 letters, digits and -" "$new" "$to" "$name"
done
for name in odraz pack Tests film all compare live; do check "the name $name" refuses 2 "the name $name is already used" "$new" "$to" $name; done
check "a folder in a missing folder" refuses 2 "there is no folder $WORK/no" "$new" "$WORK/no/where" mira
mkdir "$WORK/full"
touch "$WORK/full/.file"
check "a folder that is not empty" refuses 2 "already exists: choose a new or empty folder" "$new" "$WORK/full" mira
check "a file" refuses 2 "already exists" "$new" "$WORK/full/.file" mira
check "a folder in this repository" refuses 2 "is in this repository" "$new" "$SOURCE/tools/mira" mira
check "... by another path" refuses 2 "is in this repository" bash -c "ln -s '$SOURCE' '$WORK/link' && cd '$WORK' && exec '$new' link/mira mira"
[ "$(id -u)" = 0 ] || check "a folder that may not be written to" refuses 2 "cannot write to /" "$new" /mira mira
not_copied() { # not_copied FOLDER: prints headers of tools and tests that the copy includes but lacks
    cd "$1" && grep -rhoE '^#include "(tools|tests)/[^"]*"' intro packer tools tests/unit | cut -d'"' -f2 | sort -u |
        while read -r header; do [ -e "$header" ] || echo "$header"; done
}
interrupted() { # interrupted FOLDER: starts a new film there, and interrupts its process group while it builds
    setsid "$new" "$1" mira >/dev/null 2>&1 &
    local pid=$!
    await test -e "$1/build/build.log" && missing=$(not_copied "$1") && kill -TERM -- -$pid 2>/dev/null
    wait $pid
    [ $? = 130 ]
}
if [ -z "$(dpkg-query -W -f '${Status}\n' cmake ninja-build libcli11-dev libstb-dev libtinyexr-dev zlib1g-dev libglfw3-dev 2>&1 | grep -v 'ok installed')" ]; then
    check "it is interrupted" interrupted "$to"
    check "... and leaves nothing" test ! -e "$to"
    check "a new film has what it includes${missing:+, except for $missing}" test "$missing" = ""
    mkdir "$to"
    check "... in a folder that existed before" interrupted "$to"
    check "... which is as empty as before" rmdir "$to"
fi
check "no other files are left" test "$(cd "$WORK" && echo *)" = "err full link out printed"
finish
