# Who knows whom in tools/radiosity/: a room includes rooms named before it, and never one that stands after it.
. "$(dirname "$0")/common.sh"

# A room, and the rooms that it may include besides itself
cat >"$WORK/rules" <<'END_OF_RULES'
read
generate    read
divide      read
solution    read divide
rays        read divide solution
patches     read divide solution rays
solve       read divide solution rays patches
transfer    read divide solution rays solve
export      read divide solution rays transfer
study       read generate divide solution rays patches solve export
view        read solution solve transfer export
END_OF_RULES

# judge: of lines FILE INCLUDED (below tools/radiosity/) those that no rule allows
judge() {
    awk '
        FNR == NR { known[$1] = 1; for (i = 2; i <= NF; ++i) may[$1, $i] = 1; next }
        {
            slash = index($1, "/"); from = substr($1, 1, slash - 1)
            slash = index($2, "/"); to = substr($2, 1, slash - 1)
            if (from == to && known[from] || may[from, to] || $1 == "radiosity.cpp" && known[to]) next
            print "    " $1 " includes " $2 (known[from] || $1 == "radiosity.cpp" ? "" : ", and no rule names it")
        }' "$WORK/rules" -
}
# ordered: no rule names a room that stands below it, so there is no circle
ordered() { awk '{ for (i = 2; i <= NF; ++i) if (!seen[$i]) bad = 1; seen[$1] = 1 } END { exit bad }' "$WORK/rules"; }
obeys() {
    (cd "$SOURCE/tools/radiosity" && grep -rE --include='*.h' --include='*.cpp' '^ *# *include *"tools/radiosity/' .) |
        sed -E 's|^\./([^:]*):[^"]*"tools/radiosity/([^"]*)".*|\1 \2|' >"$WORK/includes"
    [ "$(wc -l <"$WORK/includes")" -ge 100 ] || { echo "no includes were found" >&2; return 1; }
    judge <"$WORK/includes" >"$WORK/wrong"
    cat "$WORK/wrong" >&2
    [ ! -s "$WORK/wrong" ]
}
check "rooms are named in their order" ordered
check "rooms include what is below them" obeys
flat() { [ "$(cd "$SOURCE/tools/radiosity" && ls | grep -E "\.(h|cpp)$" | tr '\n' ' ')" = "radiosity.cpp " ]; }
check "only main lies outside the rooms" flat

# Violations are found
finds() { [ "$(judge <<<"$1" | wc -l)" = 1 ]; }
for violation in "read/mesh.h divide/regions.h" "divide/facets.h solution/solution.h" "solution/solution.h rays/ray_tree.h" \
    "rays/ray_system.h patches/lamps.h" "patches/lamps.h solve/solve.h" "solve/solve.h export/render.h" "export/atlas.h view/mesh.h" \
    "transfer/relight.h export/render.h" "generate/generate.h divide/regions.h" "new/file.h read/mesh.h" "new.cpp read/mesh.h"; do
    check "(it would be found that ${violation/ / includes })" finds "$violation"
done
finish
