# radiosity solve --keep-rows and --relight: other materials with the same form factors, like a solution made for them.
. "$(dirname "$0")/radiosity_program.sh"

for kind in cube columns; do "$radiosity" generate $kind -o $kind.obj >/dev/null; done
solve() { "$radiosity" solve "$@" >out 2>err; }
# same A B [SHARE]: two solutions with the same elements, whose light is the same to 1e-5 of the largest, or to SHARE
same() {
    "$radiosity" export "$1" --csv a.csv && "$radiosity" export "$2" --csv b.csv || return
    lacks '(^|,)[-+]?(nan|inf)' b.csv && awk -F, -v share="${3:-1e-5}" 'FNR == 1 { next } NR == FNR { for (k = 9; k < 12; ++k) { a[FNR, k] = $k; if ($k > most) most = $k }; n = FNR; next }
        { for (k = 2; k < 9; ++k) if ($k == "") bad = 1; for (k = 9; k < 12; ++k) { d = $k - a[FNR, k]; if (d < 0) d = -d; if (d > off) off = d } end = FNR }
        END { if (n < 100 || end != n || bad || !(off <= share * most)) { print "off " off " of " most ", " end " lines of " n; exit 1 } }' a.csv b.csv
}
# like_fresh WHAT MODEL METHOD CHANGES [SHARE]: relights base.rad, and compares with a solution made for these materials
like_fresh() {
    local what=$1 model=$2 method=$3 changes=$4 share=${5-}
    rm -f fresh.rad relit.rad
    check "$what" solve $model --relight base.rad -o relit.rad $changes
    cp out printed
    solve $model -o fresh.rad $method $changes
    check "... is like a fresh one" same fresh.rad relit.rad $share
}
quick() { grep -q '^kept ' printed; }
scaled() { grep -q '^kept light, scaled' printed; }
slow() { grep -q '^processor seconds: dividing' printed; }
light="--sky .2,.3,.5 --sun 30,60,5,5,5 --lamp 0,5,0,1,9,9,9"
rays="--rays 32 --element 2"

for method in "$rays" "$rays $light --scale 2 --two-sided" "--hemicube 16 --element 2" "--hemicube 32 --patch 8 --element 2 $light" \
    "--direct hemicube --element 2" "--adaptive --element 1" "--rays 64 --bounces 2 --element 2" "$rays --final 32"; do
    check "solve $method" solve columns.obj -o base.rad --keep-rows $method
    check "... keeps rows" test -s base.rad.rows
    like_fresh "... other materials" columns.obj "$method" "--power 3 --reflectance white=0.9 --reflectance red=.1,.5,.9"
    if [ "${method%--final*}" = "$method" ]; then check "... without dividing" quick; else check "... with final rays" slow; fi
    like_fresh "... lamps of another colour" columns.obj "$method" "--power 1,20,5"
    like_fresh "... of three times the power" columns.obj "$method" "--power 3"
    case $method in *--final* | *--sky*) ;; *) check "... which is not solved" scaled ;; esac
done

# Extremes
for method in "$rays" "--hemicube 16 --element 2"; do
    solve cube.obj -o base.rad --keep-rows --residual 1e-6 $method
    for changes in "--power 0" "--reflectance 0" "--power 1e-20" "--power 1e10" "--power lamp=1e-9,1e9,0" \
        "--reflectance 0.99,0.99,0.99" "--reflectance 1,0,0.5" "--power 0 --reflectance 0"; do
        like_fresh "$changes ($method)" cube.obj "$method --residual 1e-6" "$changes --bounces 200"
        check "... without dividing" quick
    done
done
check "what was solved last is dark" table b.csv 's += $9 + $10 + $11' 's == 0'
# What the kept light does not have: rows are used, direct light is found again
like_fresh "another lamp" cube.obj "--hemicube 16 --element 2 --residual 1e-6" "--power white=1,2,3"
check "... with dividing" slow
like_fresh "a lamp that went out, and another" cube.obj "--hemicube 16 --element 2 --residual 1e-6" "--power 0 --power red=1,2,3"
solve cube.obj -o base.rad --keep-rows $rays
like_fresh "another lamp, by rays" cube.obj "$rays" "--power white=1,2,3"
check "... with dividing" slow
# Several lamps; their rays are distributed as their power was, which a common factor does not change
sed 's/^usemtl red/usemtl lamp2/' cube.obj >two.obj
printf 'newmtl lamp2\nKd .3 .3 .3\nKe .1 .2 .3\n' >>cube.mtl
for method in "$rays" "--hemicube 16 --element 2"; do
    solve two.obj -o base.rad --keep-rows $method
    like_fresh "two lamps ($method)" two.obj "$method" "--power 2 --reflectance lamp2=2"
    check "... without dividing" quick
    # By rays, lamps that change differently get other shadow rays in a fresh solution: those differ by their noise
    noise=
    [ "$method" != "$rays" ] || noise=0.02
    like_fresh "... one alone ($method)" two.obj "$method" "--power lamp=0" $noise
    like_fresh "... one of another colour ($method)" two.obj "$method" "--power lamp2=3,2,1" $noise
done
# An even sky, which goes where power is given
sed 's/^Ke .*/Ke 0 0 0/' columns.mtl >dark.mtl
sed 's/^mtllib .*/mtllib dark.mtl/; /^usemtl/,$!b; 0,/^f/{/^f/d}' columns.obj >dark.obj # with a hole in its floor
for method in "$rays" "--hemicube 16 --element 2"; do
    solve dark.obj -o base.rad --keep-rows $method
    check "an even sky is reported" grep -q 'an even sky is added' err
    like_fresh "... with other reflectances" dark.obj "$method" "--reflectance white=0.9"
    like_fresh "... and not with power" dark.obj "$method" "--power lamp=1,2,3"
done
# Materials are read again from their files
solve columns.obj -o base.rad --keep-rows $rays
cp columns.mtl kept.mtl
sed -i 's/^Ke .*/Ke 0 0 0/' columns.mtl
check "lamps that are out in the file" refuses 1 "nothing in the model emits light now, and its rows have no sky" "$radiosity" solve columns.obj --relight base.rad -o x.rad
cp kept.mtl columns.mtl
sed -i 's/^Kd .*/Kd 0.6 0.4 0.2/; s/^Ke 20.*/Ke 5 6 7/' columns.mtl
like_fresh "a material file that was edited" columns.obj "$rays" ""
check "... without dividing" quick
sed -i '0,/newmtl white/s//newmtl chalk/' columns.mtl
check "a material that is gone" refuses 2 "columns.obj: the material white is no longer in its files" "$radiosity" solve columns.obj --relight base.rad -o x.rad
sed 's/^newmtl white/map_Kd none.png\n&/' kept.mtl >columns.mtl # on the material before it: nothing changes there
cp kept.mtl columns.mtl
# Pictures: the polygons are needed, rows are used
printf '\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0\30\0\100\100\200' >paint.tga
sed 's/^newmtl white/&\nmap_Kd paint.tga/' kept.mtl >columns.mtl
solve columns.obj -o base.rad --keep-rows $rays
like_fresh "a model with a picture" columns.obj "$rays" "--power 2 --reflectance white=0.5"
check "... with dividing" slow
cp kept.mtl columns.mtl

# By default every element has as many rays as its light needs; that of scaled lamps needs the same
solve columns.obj -o base.rad --keep-rows --element 1
like_fresh "rays as light needs them" columns.obj "--element 1" "--power 4"
# ... and for other light, other numbers of rays: then both differ by their noise
for changes in "--power 1,20,5" "--reflectance white=0.5" "--reflectance 0.9 --power 3,2,5"; do
    like_fresh "rays as light needs them, $changes" columns.obj "--element 1" "$changes" 0.01
    check "... without dividing" quick
done
check "rows of hemicubes" solve columns.obj -o base.rad --keep-rows --hemicube 16
cp base.rad.rows whole.rows

# Files that do not belong together
"$radiosity" generate corner -o other.obj >/dev/null
relight=("$radiosity" solve columns.obj --relight base.rad -o x.rad)
check "another model" refuses 2 "belongs to another model, or other.obj has changed" "$radiosity" solve other.obj --relight base.rad -o x.rad
check "another raster" refuses 2 "its rows were found with --hemicube 16, not with --hemicube 32" "${relight[@]}" --hemicube 32
check "another subdivision" refuses 2 "its rows were found with no --element, not with --element 3" "${relight[@]}" --element 3
check "another method" refuses 2 "its rows were found with hemicubes, not with rays" "${relight[@]}" --rays 32
check "another way of direct light" refuses 2 "its rows were found with --direct analytic, not with --direct hemicube" "${relight[@]}" --direct hemicube
check "adaptive" refuses 2 "its rows were found with no --adaptive, not with --adaptive" "${relight[@]}" --adaptive
check "another sky" refuses 2 "its rows were found with no --sky, not with --sky 1,1,1" "${relight[@]}" --sky 1,1,1
check "options that are the same are no error" prints residual "${relight[@]}" --hemicube 16 --residual 1e-3
rm x.rad
solve cube.obj -o cube.rad --keep-rows --hemicube 16 --element 4
cp cube.rad.rows base.rad.rows
check "rows of another solution" refuses 2 "base.rad.rows: belongs to another solution, or base.rad has changed" "${relight[@]}"
cp base.rad base.rad.rows
check "a solution as rows" refuses 2 "base.rad.rows: holds no rows of" "${relight[@]}"
rm base.rad.rows
check "no rows" refuses 2 "cannot read base.rad.rows" "${relight[@]}"
check "no solution" refuses 2 "cannot read none.rad: No such file" "$radiosity" solve columns.obj --relight none.rad -o x.rad
check "a model as a solution" refuses 1 "was not written by" "$radiosity" solve columns.obj --relight cube.obj -o x.rad
cp whole.rows base.rad.rows
check "over the solution itself" refuses 2 "give the new one another name" "$radiosity" solve columns.obj --relight base.rad -o base.rad
check "keeping rows that are kept" refuses 2 "do not go together" "${relight[@]}" --keep-rows
check "a material that is not there" refuses 2 "no polygon has this material; there are " "${relight[@]}" --power sun=1
check "too little memory" refuses 1 "more than the 3 of --memory" "${relight[@]}" --memory 3

# (the unit test damages every byte of such a file)
head -c 1000 whole.rows >base.rad.rows
check "rows cut short" refuses 2 "base.rad.rows: is damaged" "${relight[@]}"
cp whole.rows base.rad.rows
check "none of them left a file" test ! -e x.rad

# Failing outputs
mkdir full.rad.rows
check "rows that cannot be written" bash -c "! '$radiosity' solve cube.obj -o full.rad --keep-rows --element 4 >out 2>err && grep -q '^radiosity: cannot write full.rad.rows' err && [ \$(wc -l <err) = 1 ]"
check "a full disk" bash -c "! '$radiosity' solve columns.obj --relight base.rad -o /dev/full >out 2>err && grep -q 'cannot write /dev/full' err"
check "... left nothing behind" test -z "$(find . -name '*.part')"
"${relight[@]}" --progress 2>&1 | true
check "a closed pipe leaves it whole or not at all" bash -c "[ ! -e x.rad ] || '$radiosity' export x.rad --csv x.csv"

# Ctrl-C while it solves: the light so far is written
behind "${relight[@]}" --reflectance 1,1,1 --residual 1e-7 --progress
check "Ctrl-C ends it well while it solves" stopped_at '^progress: solving' err
check "... and is reported" grep -q '^stopped: ' out
check "... and what to do" grep -qx 'run it again to find all of its light: the rows are kept' out
check "... and writes what is there" "$radiosity" export x.rad --csv x.csv
check "... all of it" table x.csv 'a += $8' 'lines > 1000 && a > 0'
check "... and no state" test ! -e x.rad.state
# Ctrl-C while rows are found: none are kept, until they are whole
behind "$radiosity" solve columns.obj -o y.rad --keep-rows --hemicube 40 --progress
check "rows that are stopped end well" stopped_at '^progress: form factors' err
check "... and are not kept" test ! -e y.rad.rows
check "... go on" prints residual "$radiosity" solve --resume y.rad.state 2>err
check "... and are kept then" prints '^kept rows of' "$radiosity" solve columns.obj --relight y.rad -o x.rad --power 2 --reflectance 0.9
"$radiosity" solve columns.obj -o fresh.rad --hemicube 40 --power 2 --reflectance 0.9 >out
check "... like a fresh one" same fresh.rad x.rad
finish
