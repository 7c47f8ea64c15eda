# Odd models, as other programs write them: every valid one gives a lit picture, unchanged; every other one gives one
# line.
. "$(dirname "$0")/radiosity_program.sh"
skip_unless convert
printf 'newmtl m\nKd 0.5 0.5 0.5\nnewmtl red\nKd 0.8 0.1 0.1\n' >m.mtl
square='v 0 0 0\nv 0 0 1\nv 1 0 1\nv 1 0 0\n'

# lit NAME TEXT [NOTE]: it is solved, all light is finite, some is above 0, and the picture is not black. It prints one
# line for each note; without a note it prints at most that the sky shines
lit() {
    printf "$2" >model.obj
    rm -f m.rad m.csv m.png
    timeout $PATIENCE "$radiosity" solve model.obj -o m.rad >out 2>err || { cat err >&2; return 1; }
    "$radiosity" export m.rad --csv m.csv && table m.csv 'light += $8 * ($9 + $10 + $11); a += $8' 'a > 0 && light > 0' &&
        "$radiosity" render m.rad -o m.png --size 80x60 >/dev/null &&
        [ "$(convert m.png -format '%[fx:maxima>0.15]' info:)" = 1 ] || { echo "light or picture is black: $(cat err)" >&2; return 1; }
    grep -v 'nothing in the model emits light: an even sky is added' err >notes || true
    if [ $# = 2 ]; then [ ! -s notes ]; else [ "$(wc -l <notes)" = 1 ] && grep -q -- "$3" notes; fi || { cat err >&2; return 1; }
}
area() { table m.csv 'a += $8' "a > 0.999 * $1 && a < 1.001 * $1"; }
reflects() { table m.csv 'a += $8; r += $8 * $9; b += $8 * $11' "r / a > $1 - 0.02 && r / a < $1 + 0.02 && b / a > $2 - 0.02 && b / a < $2 + 0.02"; }
sound() { # sound WHAT TEXT [NOTE]
    check "$1" lit "$@"
}
one_line() { # one_line WHAT TEXT WHY
    printf "$2" >model.obj
    check "$1" refuses 2 "$3" "$radiosity" solve model.obj -o x.rad
}

# --- How it is written ---
sound "no material file" "${square}f 1 2 3 4\n"
check "... reflects 0.7 of a sky of 1, everywhere" table m.csv 'if ($9 < 0.6999 || $9 > 0.7001) ++off' 'off + 0 == 0'
check "... which is reported" grep -q 'nothing in the model emits light: an even sky is added' err
sound "one that is missing" "mtllib none.mtl\nusemtl m\n${square}f 1 2 3 4\n" 'its materials cannot be read: cannot read none.mtl'
sound "an undefined material" "mtllib m.mtl\nusemtl Rd\n${square}f 1 2 3 4\n" 'no material file has Rd: it reflects 0.7; the nearest name is red$'
sound "... that no polygon has" "mtllib m.mtl\nusemtl Rd\nusemtl red\n${square}f 1 2 3 4\n"
sound "materials without a file" "usemtl m\n${square}f 1 2 3 4\n" 'no material file has m: it reflects 0.7$'
sound "usemtl without a name" "mtllib m.mtl\nusemtl\n${square}f 1 2 3 4\n"
sound "mtllib without a name" "mtllib\nusemtl m\n${square}f 1 2 3 4\n" 'no material file has m'
sound "mtllib behind its use" "usemtl red\n${square}f 1 2 3 4\nmtllib m.mtl\n"
check "... counts" reflects 0.8 0.1
sound "several material files" "mtllib a.mtl m.mtl\nusemtl red\n${square}f 1 2 3 4\n" 'cannot read a.mtl'
check "... count" reflects 0.8 0.1
cp m.mtl 'two words.MTL'
sound "one whose name has blanks and other capitals" "mtllib two words.mtl\nusemtl red\n${square}f 1 2 3 4\n"
check "... counts" reflects 0.8 0.1
sound "one in another system's folder" "mtllib C:\\\\\\\\my\\\\\\\\m.mtl\nusemtl red\n${square}f 1 2 3 4\n"
check "... counts" reflects 0.8 0.1
sound "negative numbers" "${square}f -4 -3 -2 -1\n"
sound "points that follow their polygon" "f 1 2 3 4\n${square}"
sound "lines that end with CR LF" "${square//\\n/\\r\\n}f 1 2 3 4\r\n"
sound "... with CR" "${square//\\n/\\r}f 1 2 3 4\r"
tr '\n' '\r' <m.mtl >cr.mtl
sound "... in the materials, too" "mtllib cr.mtl\rusemtl red\r${square//\\n/\\r}f 1 2 3 4\r"
check "... count" reflects 0.8 0.1
sound "... with blanks, and blank ones" "  \n${square//\\n/  \\t\\n}\n \t \nf 1 2 3 4  \n\n"
sound "tabs" "${square// /\\t}f\t1\t2\t3\t4\n"
sound "no end of the last line" "${square}f 1 2 3 4"
sound "a mark of UTF-8" "\xef\xbb\xbfv 0 0 0\nv 0 0 1\nv 1 0 1\nv 1 0 0\nf 1 2 3 4\n"
sound "lines that go on" "v 0 0 0\nv 0 \\\\\n0 1\nv 1 0 1\nv 1 0 0\nf 1 2 \\\\\n 3 \\\\\n 4\n"
check "... are whole" area 1
sound "comments behind and between" "# first \\\\\nv 0 0 0 # a\nv 0 0 1\nv 1 0 1#b\nv 1 0 0\n  # f 1 2 9\nf 1 2 3 4 # the floor\n#"
sound "numbers of all kinds" "v -0 +0.0 0\nv .0 0. 1\nv 1e0 0 1.0E+00\nv 100e-2 0 .0e5\nf 1 2 3 4\n"
sound "leading blanks" "  v 0 0 0\n  v 0 0 1\n\tv 1 0 1\n v 1 0 0\n  f 1 2 3 4\n"
sound "colours behind the points" "v 0 0 0 1 0 0\nv 0 0 1 0 1 0\nv 1 0 1 0 0 1\nv 1 0 0 .5 .5 .5\nf 1 2 3 4\n"
sound "weights behind the points" "v 0 0 0 1.0\nv 0 0 1 1.0\nv 1 0 1 1.0\nv 1 0 0 1.0\nf 1 2 3 4\n"
sound "coordinates and normals in all forms" "${square}vt 0\nvt 0 1\nvt 1 1 0\nvn 0 1 0\nf 1/1 2/2 3/3\nf 1//1 3//-1 4//1\n"
sound "... that are not there" "${square}f 1/7 2/8/9 3//9 4/1\n"
sound "groups, objects, smoothing, without names too" "o\ng\ng a b c\no thing\ns off\ns 1\n${square}g\nf 1 2 3\ns\nf 1 3 4\n"
sound "unknown keywords" "mg 1 0.5\nbevel on\nc_interp on\nlod 3\nshadow_obj x\n${square}f 1 2 3 4\ncall x.obj\n\$!?\n"
sound "faces by their old keyword" "${square}fo 1 2 3 4\n"
check "... are there" area 1
sound "bytes of 0" "v 0 0 0\nv 0 0 1\nv 1 0 1\nv 1 0 0\0\nf 1 2 3 4\n"

# --- What is in it ---
sound "points and lines beside a polygon" "${square}p 1 2\nl 1 2 3\nf 1 2 3 4\n"
sound "polygons of one and two points" "${square}f 1 2\nf 3\nf\nf 1 2 3 4\n" '3 polygons with fewer than three points left out'
sound "free-form curves beside a polygon" "${square}vp 0 1\ncstype bezier\ndeg 3 3\nsurf 0 1 0 1 1 2 3 4\nparm u 0 1\nend\nf 1 2 3 4\n"
sound "a polygon that is not convex" "v 0 0 0\nv 0 0 3\nv 1 0 3\nv 1 0 1\nv 3 0 1\nv 3 0 0\nf 1 2 3 4 5 6\n"
check "... as large as it is" area 5
sound "a star" "$(awk 'BEGIN { for (k = 0; k < 16; ++k) { r = k % 2 ? 1 : 2; printf "v %.6f 0 %.6f\\n", r * cos(k * .3926990817), -r * sin(k * .3926990817) } printf "f"; for (k = 1; k <= 16; ++k) printf " %d", k; print "\\n" }')"
check "... as large as it is" area 6.1229
sound "polygons given twice" "${square}f 1 2 3 4\nf 1 2 3 4\n" '2 triangles given twice left out'
sound "... turned over" "${square}f 1 2 3 4\nf 1 2 3 4\nf 4 3 2 1\n" 'given twice left out'
sound "slivers" "${square}v 0.5 0.000002 0.5\nv 1.2 0.5 0.0001\nf 1 4 5\nf 4 6 1\nf 1 2 3 4\n"
sound "polygons without area" "${square}f 1 1 2\nf 1 2 2\nf 1 2 3 4\n" 'without area left out'
sound "points given twice" "$square${square}f 1 2 3 4\n"
sound "unused points" "${square}v 5 5 5\nf 1 2 3 4\n"
sound "a triangle alone" "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
sound "... that faces away" "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 3 2\n"
sound "a floor seen from below alone" "${square}f 4 3 2 1\n"
box='v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0 1 0\nv 1 1 0\nv 1 1 1\nv 0 1 1\n'
sound "a box" "${box}f 1 2 3 4\nf 5 8 7 6\nf 1 5 6 2\nf 3 7 8 4\nf 1 4 8 5\nf 2 6 7 3\n"
sound "... turned inside out" "${box}f 4 3 2 1\nf 6 7 8 5\nf 2 6 5 1\nf 4 8 7 3\nf 5 8 4 1\nf 3 7 6 2\n" 'no light reaches the fronts'
for size in 1e-9 1e-5 1e-3 1e4 1e7 5e8; do
    sound "of size $size" "${square//1/$size}f 1 2 3 4\n"
done
for far in 1000 500000 1e7 1e12; do
    coarse=
    [ $far != 1e12 ] || coarse='too far from the origin for precise coordinates'
    sound "a metre, $far away" "$(awk -v f=$far 'BEGIN { split("0 0 0 1 1 1 1 0", p); for (i = 0; i < 4; ++i) printf "v %.1f 0 %.1f\\n", f + p[2 * i + 1], f + p[2 * i + 2] }')f 1 2 3 4\n" ${coarse:+"$coarse"}
done
far_room() { # far_room FILE X Y Z: a room with a lamp, moved by X Y Z
    awk -v x="$2" -v y="$3" -v z="$4" 'BEGIN { print "mtllib room.mtl"
        for (k = 0; k < 8; ++k) printf "v %.3f %.3f %.3f\n", x - 1 + 2 * int(k / 4), y + 2 * (int(k / 2) % 2), z - 1 + 2 * (k % 2)
        for (k = 0; k < 4; ++k) printf "v %.3f %.3f %.3f\n", x + (k == 0 || k == 3 ? -.3 : .3), y + 1.998, z + (k < 2 ? -.3 : .3)
        print "usemtl floor\nf 1 2 6 5\nusemtl wall\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\nf 1 3 4 2\nf 5 6 8 7\nusemtl lamp\nf 9 10 11 12" }' >"$1.obj"
    "$radiosity" solve "$1.obj" -o "$1.rad" --rays 64 --lamp "$(awk "BEGIN { printf \"%.3f,%.3f,%.3f\", $2 + .5, $3 + 1, $4 }"),0.2,3,3,3" >/dev/null && "$radiosity" export "$1.rad" --csv "$1.csv"
}
printf 'newmtl floor\nKd .7 .7 .7\nnewmtl wall\nKd .5 .5 .5\nnewmtl lamp\nKd 0 0 0\nKe 10 10 10\n' >room.mtl
check "a room with two lamps" far_room near 0 0 0
check "... in survey coordinates" far_room survey 460123.5 210 5411234.25
check "... and in earth-centred ones" far_room earth 3980581.25 -12345.5 4966824.75
for far in survey earth; do
    # Places, normals, areas and light of every element
    check "... has the same light ($far)" eval "paste -d, near.csv $far.csv | awk -F, 'function off(a, b) { return a > b ? a - b : b - a }
        NR > 1 { ++n; s += off(\$9, \$20); light += \$9; if (off(\$6, \$17) > 1e-6 || off(\$8, \$19) > 1e-5 * \$8) ++bad
            for (k = 2; k < 5; ++k) { d = \$(k + 11) - \$k; if (n == 1) first[k] = d; if (off(d, first[k]) > 2e-6) ++bad } }
        END { exit !(n > 1000 && s < 0.001 * light && bad + 0 == 0) }'"
done
check "the camera, too" "$radiosity" render survey.rad -o survey.png --eye 460123.5,211,5411235.15 --at 460123.5,211,5411233.25 --size 80x60
check "... sees the same" eval '"$radiosity" render near.rad -o near.png --eye 0,1,.9 --at 0,1,-1 --size 80x60 && [ "$(compare -metric AE -fuzz 2% near.png survey.png null: 2>&1)" -lt 20 ]'
check "... is placed by itself" prints '^--eye 4601[0-9]{2}\.[0-9]+,2[0-9]+\.[0-9]+,54112[0-9]{2}\.[0-9]+ --at 460123\.[0-9]+,' "$radiosity" render survey.rad -o survey.png --size 80x60
for kind in ply obj; do
    "$radiosity" export survey.rad --$kind survey.$kind
    check "... $kind has all digits" eval '[ "$(grep -cE "460122\.[0-9]{3,} 21[0-9.]+ 54112[0-9]{2}\.[0-9]{3,}" survey.'$kind')" -gt 100 ]'
done
check "lightmaps" "$radiosity" export survey.rad --atlas survey
check "... in OBJ" grep -qE '^v 460122\.5[0-9]* 21[0-9.]* 54112[0-9]{2}\.' survey/model.obj
check "... in glTF by a node" grep -q '"translation":\[460123' survey/model.gltf
# A decal in the plane of a wall: the first in the file is in front, in the light by both methods and in the picture
printf 'newmtl decal\nKd .9 .9 .9\nnewmtl wall\nKd .1 .1 .1\n' >decal.mtl
decal_room() { # decal_room FILE before|after Z: the decal lies at Z; the wall at -1
    local face='usemtl decal\nf 13 14 15 16\n'
    { printf 'mtllib decal.mtl\n'; [ "$2" = after ] || printf "$face"; cat near.obj
        printf 'v -.9 .1 %s\nv .9 .1 %s\nv .9 1.9 %s\nv -.9 1.9 %s\n' "$3" "$3" "$3" "$3"; [ "$2" = before ] || printf "$face"; } >"$1.obj"
    for way in "--rays 256" "--hemicube 32"; do
        # shellcheck disable=SC2086 # options are several words
        "$radiosity" solve "$1.obj" -o "$1.rad" $way 2>err >/dev/null && "$radiosity" export "$1.rad" --csv "$1.csv" || return
        awk -F, '$6 > .9 { a += $8; s += $8 * $9 } END { print s / a }' "$1.csv"
    done >"$1.floor"
    "$radiosity" render "$1.rad" -o "$1.png" --eye 0,1,.9 --at 0,1,-1 --size 160x120
}
alike() { # alike A B: floors within .5 %, and pictures
    paste "$1.floor" "$2.floor" | awk '{ d = ($1 - $2) / $2; if (d * d > 0.000025) off = 1 } END { exit NR != 2 || off }' &&
        [ "$(compare -metric AE -fuzz 4% "$1.png" "$2.png" null: 2>&1)" -lt 100 ]
}
check "a room with a decal a millimetre in front of a wall" decal_room front after -.999
check "... with it far behind" decal_room behind after -9
check "... behind the wall that comes first" decal_room last after -1
check "... with a note" grep -q 'polygons overlap in one plane, and the first is in front: line [0-9]* (decal) behind line [0-9]* (wall)$' err
check "... has the light and the picture without it" alike last behind
check "... in front of the wall that comes later" decal_room first before -1
check "... has those with it in front" alike first front
sound "one part far away" "${square}v 15 0 0\nv 15 0 1\nv 16 0 0\nf 1 2 3 4\nf 5 6 7\n"

# --- Materials ---
material() { # material WHAT MTL [NOTE] [RED BLUE]
    printf "$2" >m.mtl
    sound "$1" "mtllib m.mtl\nusemtl m\nvt 0 0\n${square}f 1/1 2/1 3/1 4/1\n" ${3:+"$3"}
    [ $# -lt 5 ] || check "... reflects $4 and $5" reflects "$4" "$5"
}
material "all that a material can have" 'newmtl m\nKd 0.8 0.6 0.4\nKa 0.1 0.1 0.1\nKs 1 1 1\nTf 1 1 1\nillum 7\nd -halo 0.5\nTr 0.5\nNs 100\nsharpness 60\nNi 1.5\nPr 0.5\n' '' 0.8 0.4
material "a picture that is not used" 'newmtl m\nKd 0.8 0.6 0.4\nmap_Ks none.png\nnewmtl n\nKd 1 1 1\nmap_Ks none.png\n' 'map_Ks is not used: material m and 1 more' 0.8 0.4
material "keywords in capitals" 'NEWMTL m\nKd 0.8 0.6 0.4\n' 'm.mtl: NEWMTL is read as newmtl'
material "names with blanks at their ends" '\tnewmtl  m \t\n  Kd 0.8 0.6 0.4  \n' '' 0.8 0.4
material "no Kd" 'newmtl m\nKs 1 1 1\n' 'it has no Kd: it reflects 0.7' 0.7 0.7
material "Kd of one number" 'newmtl m\nKd 0.5\n' '' 0.5 0.5
material "Kd as xyz" 'newmtl m\nKd xyz 0.4755 0.5 0.5445\n' '' 0.5 0.5
material "Kd as a spectrum" 'newmtl m\nKd spectral a.rfl 1\n' 'is a spectrum, which is not read: it reflects 0.7' 0.7 0.7
material "Kd above 1" 'newmtl m\nKd 2 0.5 0.25\n' 'more counts as 1' 1 0.25
material "Kd of 0 in all" 'newmtl m\nKd 0 0 0\nKs 1 1 1\n' 'everything would be black: it reflects 0.7' 0.7 0.7
material "a picture alone, and missing" 'newmtl m\nmap_Kd none.png\n' "cannot read none.png" 0.7 0.7
printf 'newmtl m\nmap_Kd p.pgm\n' >m.mtl
printf 'P5 1 1 255 x' >p.pgm
sound "a picture without coordinates" "mtllib m.mtl\nusemtl m\n${square}f 1 2 3 4\n" 'coordinates of pictures are missing, and their means are used: m'
material "a material given twice" 'newmtl m\nKd 0.8 0.8 0.8\nnewmtl m\nKd 0.1 0.1 0.1\n' 'material m: it is given again; the first one is used' 0.8 0.8
material "a file that is empty" '' 'm.mtl: has no material'
material "a file of something else" '\x7fELF\0\1\2\n\xff\xfe' 'm.mtl: is not a text file'
printf 'newmtl a b\nKd 0.8 0.1 0.1\nnewmtl a\nKd 0.1 0.1 0.1\nnewmtl a#1\nKd 0.1 0.1 0.8\n' >m.mtl
sound "a name with blanks" "mtllib m.mtl\nusemtl a b\n${square}f 1 2 3 4\n"
check "... is one" reflects 0.8 0.1
sound "a name with #" "mtllib m.mtl\nusemtl a#1\n${square}f 1 2 3 4\n"
check "... is one" reflects 0.1 0.8

# --- Files that are no model of polygons: one line ---
one_line "points alone" "${square}p 1 2 3 4\n" "holds no polygon"
one_line "lines alone" "${square}l 1 2 3 4\n" "holds no polygon"
one_line "curves alone" "${square}vp 0 1\ncstype bezier\ncurv 0 1 1 2 3\nend\n" "holds no polygon"
one_line "points in a line" "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n" "holds no polygon with an area"
one_line "polygons of two points" "${square}f 1 4\n" "holds no polygon"
one_line "polygons without area alone" "${square}f 1 1 1\n" "holds no polygon"
one_line "a point that is not there" "${square}f 1 2 99\n" "model.obj:5: there is no point 99"
one_line "... where lines end with CR" 'v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 99999999\r' "model.obj:4: there is no point 99999999"
one_line "... where there is none at all" 'f 1 2 3\n' "model.obj:1: there is no point 3"
one_line "a point of number 0" "${square}f 0 1 2\n" "model.obj:5: there is no point 0"
one_line "one beyond the first" "${square}f -5 -2 -1\n" "model.obj:5: there is no point -5"
one_line "words for points" "${square}f a b c\n" "model.obj:5: a polygon's points are numbers"
one_line "two coordinates" "v 0 0\n" "model.obj:1: a point needs three coordinates"
one_line "a coordinate that is no number" "${square}v 1 x 0\n" "model.obj:5: a point needs three coordinates"
one_line "... that is NaN" "${square}v 1 nan 0\n" "model.obj:5: a coordinate is not a number"
one_line "larger than anything" "v 1e30 0 0\n${square}f 2 3 4 5\n" "model.obj:1: a coordinate is not a number below 1e18"
one_line "larger than can be traced" "${square//1/1e12}f 1 2 3 4\n" "is larger than 1e9: give --scale"
one_line "something else" '\x89PNG\r\n\x1a\n' "holds no point"
one_line "nothing" '' "model.obj: holds no point"
printf 'newmtl m\nKd -2 0 0\n' >m.mtl
one_line "a reflectance below 0" "mtllib m.mtl\nusemtl m\n${square}f 1 2 3 4\n" "Kd must lie between 0 and 1"
mkfifo fifo
for endless in fifo /dev/zero .; do
    check "$endless is no model" refuses 2 "not a regular file" "$radiosity" solve $endless -o x.rad
    printf "mtllib $endless\nusemtl m\n${square}f 1 2 3 4\n" >model.obj
    check "... and no materials" prints 'materials cannot be read.*not a regular file|nothing in the model emits light' bash -c "timeout $PATIENCE '$radiosity' solve model.obj -o m.rad 2>&1"
    check "... and no solution" refuses 2 "not a regular file" "$radiosity" export $endless --csv x.csv
done
check "none of them left a file" test ! -e x.rad -a ! -e x.csv
finish
