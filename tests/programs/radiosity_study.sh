# radiosity study, as its users run it: the page, its tables and pictures, and what is refused. With "all" as the second
# argument it takes longer, and is interrupted in more places.
. "$(dirname "$0")/radiosity_program.sh"
all= minutes=0.3
if [ "${2-}" = all ]; then all=1 minutes=0.5; fi

check "a model" prints polygons "$radiosity" generate cube -o cube.obj
# More on a busy machine. On two quiet cores a solution takes .6 of its processor time by the clock
TIMEFORMAT='%R %U'
{ time "$radiosity" solve cube.obj -o cube.rad >out 2>err; } 2>took
minutes=$(awk -v minutes=$minutes '{ slow = $1 / ($2 + 0.01) / 0.6; print minutes * (slow < 1 ? 1 : slow > 6 ? 6 : slow) }' took)
check "its study" prints '^page/index.html: [0-9.]+ minutes, [1-9][0-9]* solutions, [0-9]+ measurements left out$' "$radiosity" study cube.obj -o page --minutes "$minutes"

# --- The page ---
PAGE=page/index.html
parts() { # parts FOLDER LEAST: the files that its page shows or links to are there, LEAST or more, and no others
    grep -oE '(src|href)="[^"]*"' "$1/index.html" | sed 's/.*="//; s/"$//' | sort -u >parts
    (echo index.html && cat parts) | sort >wanted
    [ "$(wc -l <parts)" -ge "$2" ] && ls "$1" | sort | diff - wanted >&2
}
check "a page with all its parts, and nothing else" parts page 22
check "... that needs no network" eval '! grep -rlE "(https?:)?//[a-z]|@import|url\(" page --include=*.html >&2'
check "... nor its plots, but for the name of SVG" eval '! sed "s|http://www.w3.org/2000/svg||" page/*.svg | grep -E "https?://|href|@import|url\(" >&2'
check "... light: below 3 MB" less "$(cat page/* | wc -c)" 3000000
if command -v xmllint >/dev/null; then
    check "... well-formed" xmllint --noout $PAGE
    check "... with plots that are" xmllint --noout page/*.svg
    outline() { # what HTML requires of a page: one title and heading, pictures described, tables with heads
        [ "$(xmllint --xpath 'concat(count(//title), count(//h1), count(//img[not(@alt)]), count(//table[not(.//th)]), count(//body//script))' $PAGE)" = 11000 ]
    }
    check "... and described pictures" outline
else
    echo "not checked: xmllint is not installed"
fi
for words in "What to choose" "Three sizes by three rasters" "Rasters from 25 to 800 pixels" "Gathering, Gauss-Seidel and shooting" "What every pass adds" \
    "Two orders of update" "Flat and interpolated; middle and corners" "Linear, constant and logarithmic mapping"; do
    check "a chapter: $words" grep -q "<h2>$words</h2>" $PAGE
done
check "its plots name their axes" test "$(grep -l 'rotate(-90)' page/*.svg | wc -l)" = "$(ls page/*.svg | wc -l)"

# --- Figures ---
cell() { awk -F, -v n="$2" "$3 { print \$n; exit }" "page/$1.csv"; } # cell TABLE COLUMN CONDITION
check "passes: the light that came and the light that is left add up" table page/passes.csv 'if ($2 != "") { all += $2; d = all + $3 - 100; if (d < 0) d = -d; if (d > 1) bad = 1 }' '!bad'
check "... less is left with each" table page/passes.csv 'if ($3 != "") { if (NR > 2 && $3 > last) bad = 1; last = $3 }' '!bad'
check "... at once is ahead of the next pass" less "$(cell passes 7 'NR == 3')" "$(cell passes 4 'NR == 3')"
check "gathering converges" less "$(cell methods_within 5 '/^gathering/')" 0.01
check "... to what Gauss-Seidel finds" less "$(cell methods_within 5 '/^Gauss-Seidel/')" 0.01
check "... and shooting" less "$(cell methods_within 5 '/^shooting over/')" 0.1
check "shooting with hemicubes of its own was measured" table page/methods.csv 'n += /^"?shooting by hemicubes/' 'n >= 3'
check "a raster of 25 pixels" less 0.01 "$(cell rasters 5 '$1 == 25')"
check "... is worse than one of 100" less "$(cell rasters 5 '$1 == 100')" "$(cell rasters 5 '$1 == 25')"
check "one gather by 100 pixels beats 25" less "$(cell gathering 4 '$2 == 100')" "$(cell gathering 4 '$2 == 25')"
# Where there was little time, the reference is off by more than these two differ
check "interpolated light is nearer than flat light" less "$(cell display 5 '/interpolated/')" "$(cell display 5 '/flat/ { $5 *= 1.1 } /flat/')"
check "one gather: the finest raster has no difference from itself" table page/gathering.csv 'if (/^one/ && $2 > most) { most = $2; left = $6 } if ($6 != "") { ++n; bad = bad || !($6 > 0) }' 'n > 2 && left == "" && !bad'
check "... 25 pixels are further from it than 100" less "$(cell gathering 6 '/^one/ && $2 == 100')" "$(cell gathering 6 '/^one/ && $2 == 25')"
check "... one hemicube of 50 is nearer to it than four of 25" less "$(cell gathering 6 '/^one/ && $2 == 50')" "$(cell gathering 6 '/^four turned/ && $2 == 25')"
check "the reference was compared with path tracing" grep -qE 'The reference itself differs from path tracing, .*, by (less than )?[0-9.]+ % \(rms; median [0-9.]+ %\)' $PAGE
check "sizes have as many patches as they were divided into" table page/table.csv 'if (!seen[$1]++) { ++sizes; bad = bad || $1 <= last; last = $1 }' '!bad && sizes >= 1'
legend() { # every size that has a row, and no other
    cut -d, -f1 page/table.csv | sed 1d | sort -u >sizes && grep -oE '>[0-9]+ patches<' page/table.svg | tr -dc '0-9\n' | sort -u | diff - sizes >&2
}
check "... which the plot names" legend
# A command on the page makes the solution of its row: it has the same number of patches
follow() { # the first row of solutions.csv that matches
    local row
    row=$(grep -m1 -E "^\"[0-9]+ $1" page/solutions.csv) || return
    local command=${row##*,\"} count=${row#\"}
    command=${row#*radiosity solve} && command=${command%\"}
    eval "\"$radiosity\" solve ${command/OUT.rad/followed.rad}" >out 2>err && grep -qE "(^|[^0-9])${count%% *} ${2:-patches}" out
}
check "a command of a raster gives it" follow 'patches, by'
check "a command of shooting gives it" follow 'patches, shot by'
check "a command of elements gives it" follow 'elements, by rays' elements
for csv in page/*.csv; do
    check "$(basename "$csv"): numbers alone below its heads" lacks '(^|,)[-+]?(nan|inf)' "$csv"
done
same_front() { # the front's solutions are among all of them
    sort page/solutions.csv >all && sort page/front.csv | comm -23 - all | wc -l | grep -qx 0
}
check "what nothing beats was measured" same_front
check "there is advice" test "$(grep -c '^<li>' $PAGE)" -ge 5

# --- What is refused ---
check "no model" refuses 2 "name a model" "$radiosity" study -o x
check "no folder" refuses 2 "name a folder" "$radiosity" study cube.obj
check "a folder that holds something" refuses 2 "page: exists already" "$radiosity" study cube.obj -o page
check "no place for a folder" refuses 2 "cannot write" "$radiosity" study cube.obj -o none/x
check "a missing model" refuses 2 "cannot read" "$radiosity" study none.obj -o x
echo "f 1 2 3" >bad.obj
check "a bad model" refuses 2 "bad.obj" "$radiosity" study bad.obj -o x
check "what is varied" refuses 2 "cannot use '--hemicube'" "$radiosity" study cube.obj -o x --hemicube 32
check "no time" refuses 2 "from 0.1 to" "$radiosity" study cube.obj -o x --minutes 0
check "a model and the thesis's table" refuses 2 "--table41 takes no model" "$radiosity" study cube.obj -o x --table41
check "a time for the thesis's table" refuses 2 "--table41 takes no --minutes" "$radiosity" study --table41 -o x --minutes 3
check "what cannot be written" refuses 1 "cannot write" bash -c "trap '' XFSZ; ulimit -f 4; '$radiosity' study cube.obj -o x --minutes 0.1"

interrupted() { # in this chapter, with this line
    behind "$radiosity" study cube.obj -o x --progress --minutes 0.2
    ! stopped_at "^progress: $1.* %" err && grep -qx "radiosity: $2" err
}
for chapter in reference ${all:+methods}; do
    check "an interrupt ends its $chapter, with a line" interrupted $chapter "interrupted: no page is written"
done
check "... and nothing is left" test -z "$(find . -maxdepth 1 -name 'x*')"
check "an interrupt ends its rasters" interrupted rasters "interrupted: x/index.html has what was measured until then"
PAGE=x/index.html
done_or_listed() { [ -s "x/$1.csv" ] || grep -q "<li>$1: " $PAGE; } # as there was time, or not
check "... and leaves the chapters that are done" eval 'done_or_listed methods && done_or_listed table && [ ! -e x/rasters.csv ]'
check "... on a page" grep -q '<h2>Three sizes by three rasters</h2>' $PAGE
check "... which lists what is missing" eval 'grep -q "<li>rasters: interrupted" $PAGE && grep -q "<li>display: interrupted" $PAGE && ! grep -q "<h2>Rasters" $PAGE'
check "... and has all its parts, and nothing else" parts x 1
rm -rf x

# The thesis's table, with the options of reading; after its first cell it is interrupted
if [ -n "$all" ]; then
    table41() {
        behind "$radiosity" study --table41 -o x --reflectance 0.5 --scale 2
        ! stopped_at '^[0-9]* patches by 100 pixels: ' out && grep -q '^radiosity: interrupted: x/index.html' err
    }
    check "the thesis's table" table41
    check "... is written as far as it came" table x/table.csv 'rows += $2 == 100 && $11 == 4.667' 'rows == 1'
    check "... its command has the options" grep -q 'radiosity solve columns.obj -o OUT.rad --reflectance 0.5 --scale 2 --direct hemicube --hemicube 100' x/solutions.csv
fi

# --- Extremes ---
# Each takes its whole time, so they run at once. Light arrives at a surface even in a colour that it does not reflect
altered() { sed "$2" cube.mtl >"$1.mtl" && sed "s/cube.mtl/$1.mtl/" cube.obj >"$1.obj"; } # altered NAME SED
altered pure 's/^Kd 0.65 .*/Kd 0.65 0 0/; s/^Kd 0.12 .*/Kd 0 0.5 0/'
altered black 's/^Kd .*/Kd 0 0 0/'
altered bright 's/^Kd .*/Kd 0.99 0.99 0.99/'
altered dark 's/^Ke .*/Ke 0 0 0/'
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >one.obj
studies=()
for kind in pure one dark ${all:+black bright}; do
    "$radiosity" study $kind.obj -o $kind --minutes 0.1 >/dev/null &
    PIDS+=($!) studies+=($!)
done
number=0
for what in "a room of pure colours:pure" "one triangle:one" "a closed room without lamps:dark" \
    ${all:+"a room that reflects nothing:black" "a room that reflects nearly all:bright"}; do
    check "${what%:*}" ended "${studies[number++]}"
    check "... has a page" test -s "${what#*:}/index.html"
done
check "the reference of pure colours is near the paths" less "$(grep -oE 'differs from path tracing, [^:]* by (less than )?[0-9.]+ %' pure/index.html | grep -oE '[0-9.]+ %$' | tr -d ' %')" 5
finish
