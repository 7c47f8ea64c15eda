# radiosity study --quick: the page, its numbers, a command on it, and interrupts. Its figures are the same on every
# machine and at any load.
. "$(dirname "$0")/radiosity_program.sh"

"$radiosity" generate cube -o cube.obj >/dev/null
check "the study of a cube" prints '^page/index.html: 9 solutions$' "$radiosity" study cube.obj -o page --quick

# --- The page ---
parts() { # parts FOLDER LEAST: succeeds if the folder has the page, the files that it shows or links to (at least LEAST), no others
    grep -oE '(src|href)="[^"]*"' "$1/index.html" | sed 's/.*="//; s/"$//' | sort -u >parts
    (echo index.html && cat parts) | sort >wanted
    [ "$(wc -l <parts)" -ge "$2" ] && ls "$1" | sort | diff - wanted >&2
}
check "a page with all its parts, and nothing else" parts page 25
check "... that needs no network" eval '! grep -rlE "(https?:)?//[a-z]|@import|url\(" page --include=*.html >&2'
if command -v xmllint >/dev/null; then check "... well-formed, as its plots" xmllint --noout page/index.html page/*.svg; fi
for csv in page/*.csv; do
    check "$(basename "$csv"): only numbers below its titles" lacks '(^|,)[-+]?(nan|inf)' "$csv"
done

# --- Figures ---
cell() { awk -F, -v n="$2" "$3 { print \$n; exit }" "page/$1.csv"; } # cell TABLE COLUMN CONDITION: prints a cell
check "passes: the light so far and the light that is left add up" table page/passes.csv 'if ($2 != "") { all += $2; d = all + $3 - 100; if (d < 0) d = -d; if (d > 1) bad = 1 }' '!bad'
# Each pass reflects the light of the last one in the same room
check "... each adds about half of the one before, which is what the room reflects" table page/passes.csv 'if (NR > 3 && NR < 12) { share = $2 / last; if (share < 0.45 || share > 0.6) bad = 1 } last = $2' '!bad'
check "... with new light used at once, half as many reach .01 %" table page/orders.csv 'if ($1 == 0.01) good = $3 <= 0.6 * $2' good
for method in gathering Gauss-Seidel 'shooting over'; do
    check "$method converges to the same light" less "$(cell methods_within 5 "/^$method/")" 0.01
done
# Shooting uses the form factors of the other direction, which differ where hemicubes are coarse
check "shooting by hemicubes ends within a tenth of it" less "$(cell methods_within 6 '/by hemicubes, single/')" 10
check "one gather: four times the pixels have at most a third of the error" less "$(cell gathering 6 '/^one/ && $2 == 100')" "$(cell gathering 6 '/^one/ && $2 == 25 { $6 /= 3 } /^one/ && $2 == 25')"
check "... one hemicube of 50 is nearer to the finest than four of 25" less "$(cell gathering 6 '/^one/ && $2 == 50')" "$(cell gathering 6 '/^four rotated/ && $2 == 25')"
check "whole solutions: twice the pixels are better" table page/rasters.csv 'if (NR > 2 && !($5 < last)) bad = 1; last = $5' 'NR == 5 && !bad'
check "interpolated light has at most half the error of flat light" less "$(cell display 5 '/interpolated/')" "$(cell display 5 '/flat/ { $5 /= 2 } /flat/')"
check "two sizes by two rasters: finer ones are nearer in the median" table page/table.csv 'm[NR] = $9' 'NR == 5 && m[3] < m[2] && m[5] < m[4] && m[4] < m[2] && m[5] < m[3]'
check "the reference was compared with path tracing" grep -qE 'The reference itself differs from path tracing, .*, by (less than )?[0-9.]+ % \(rms; median [0-9.]+ %\)' page/index.html
# A command on the page repeats the solution of its row: it has the same number of patches
follow() {
    local row command
    row=$(grep -m1 -E '^"[0-9]+ patches, shot by' page/solutions.csv) || return
    command=${row#*radiosity solve} && command=${command%\"}
    eval "\"$radiosity\" solve ${command/OUT.rad/followed.rad}" >out 2>err && row=${row#\"} && grep -q "[^0-9]${row%% *} patches" out
}
check "a command on the page repeats its solution" follow

# --- Interrupts and errors ---
interrupted() { # interrupted CHAPTER LINE: fails if the next chapter had begun: then it is tried again
    rm -rf x
    in_background "$radiosity" study cube.obj -o x --progress --quick
    ! stopped_at "^progress: $1.* %" err && grep -qx "radiosity: $2" err && [ ! -e x/rasters.csv ]
}
check "an interrupt during the reference ends it, with a line" await interrupted reference "interrupted: no page is written"
check "... and nothing is left" test -z "$(find . -maxdepth 1 -name 'x*')"
check "an interrupt during the table ends it" await interrupted table "interrupted: x/index.html has what was measured until then"
check "... and leaves the chapters that are done, with all their parts" eval '[ -s x/methods.csv ] && parts x 1'
check "... on a page that lists what is missing" grep -q "<li>rasters: interrupted" x/index.html
check "a folder that is not empty" refuses 2 "page: already exists" "$radiosity" study cube.obj -o page
finish
