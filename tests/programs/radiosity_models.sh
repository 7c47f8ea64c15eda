# Models far from the origin, decals, odd shapes, and a pipe as a file of materials. (obj_reader_test tests the forms of
# text, and what the reader repairs, ignores and refuses.)
. "$(dirname "$0")/radiosity_program.sh"
skip_unless convert compare

far_room() { # far_room FILE X Y Z: solves a room with a lamp that is moved by X Y Z
    awk -v x="$2" -v y="$3" -v z="$4" 'BEGIN { print "mtllib room.mtl"
        for (k = 0; k < 8; ++k) printf "v %.3f %.3f %.3f\n", x - 1 + 2 * int(k / 4), y + 2 * (int(k / 2) % 2), z - 1 + 2 * (k % 2)
        for (k = 0; k < 4; ++k) printf "v %.3f %.3f %.3f\n", x + (k == 0 || k == 3 ? -.3 : .3), y + 1.998, z + (k < 2 ? -.3 : .3)
        print "usemtl floor\nf 1 2 6 5\nusemtl wall\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\nf 1 3 4 2\nf 5 6 8 7\nusemtl lamp\nf 9 10 11 12" }' >"$1.obj"
    solved "$1" "$1.obj" --rays 64 --element 0.01 --lamp "$(awk "BEGIN { printf \"%.3f,%.3f,%.3f\", $2 + .5, $3 + 1, $4 }"),0.2,3,3,3"
}
printf 'newmtl floor\nKd .7 .7 .7\nnewmtl wall\nKd .5 .5 .5\nnewmtl lamp\nKd 0 0 0\nKe 10 10 10\n' >room.mtl
check "a room with two lamps" far_room near 0 0 0
check "... in survey coordinates" far_room survey 460123.5 210 5411234.25
check "... and in earth-centred ones" far_room earth 3980581.25 -12345.5 4966824.75
for far in survey earth; do
    # Compare positions, normals, areas and light of every element
    check "... has the same light ($far)" eval "paste -d, near.csv $far.csv | awk -F, 'function off(a, b) { return a > b ? a - b : b - a }
        NR > 1 { ++n; s += off(\$9, \$21); light += \$9; if (off(\$6, \$18) > 1e-6 || off(\$8, \$20) > 1e-5 * \$8) ++bad
            for (k = 2; k < 5; ++k) { d = \$(k + 12) - \$k; if (n == 1) first[k] = d; if (off(d, first[k]) > 2e-6) ++bad } }
        END { exit !(n > 1000 && s < 0.001 * light && bad + 0 == 0) }'"
done
check "a camera in survey coordinates" "$radiosity" render survey.rad -o survey.png --eye 460123.5,211,5411235.15 --at 460123.5,211,5411233.25 --size 80x60
check "... sees the same" eval '"$radiosity" render near.rad -o near.png --eye 0,1,.9 --at 0,1,-1 --size 80x60 && [ "$(compare -metric AE -fuzz 2% near.png survey.png null: 2>&1)" -lt 20 ]'
check "... is placed by itself" prints '^--eye 4601[0-9]{2}\.[0-9]+,2[0-9]+\.[0-9]+,54112[0-9]{2}\.[0-9]+ --at 460123\.[0-9]+,' "$radiosity" render survey.rad -o survey.png --size 80x60
check "PLY has all digits" eval '"$radiosity" export survey.rad --ply survey.ply && [ "$(grep -cE "^460122\.5 21[0-9.]+ 54112[0-9]{2}\.[0-9]{2,} " survey.ply)" -gt 3 ]'
check "... lightmaps in OBJ" eval '"$radiosity" export survey.rad --atlas survey >out && grep -qE "^v 460122\.5[0-9]* 21[0-9.]* 54112[0-9]{2}\." survey/model.obj'
check "... in glTF by a node" grep -q '"translation":\[460123' survey/model.gltf

# If a decal and a wall are in one plane, the first in the file is in front: in both methods' light, and in the picture
printf 'newmtl decal\nKd .9 .9 .9\nnewmtl wall\nKd .1 .1 .1\n' >decal.mtl
decal_room() { # decal_room FILE before|after Z: the decal lies at Z; the wall at -1
    local face='usemtl decal\nf 13 14 15 16\n'
    { printf 'mtllib decal.mtl\n'; [ "$2" = after ] || printf "$face"; cat near.obj
        printf 'v -.9 .1 %s\nv .9 .1 %s\nv .9 1.9 %s\nv -.9 1.9 %s\n' "$3" "$3" "$3" "$3"; [ "$2" = before ] || printf "$face"; } >"$1.obj"
    for way in "--rays 256 --element 0.01" "--hemicube 32 --patch 0.02 --element 0.01"; do
        # shellcheck disable=SC2086 # options are several words
        solved "$1" "$1.obj" $way && awk -F, '$6 > .9 { a += $8; s += $8 * $9 } END { print s / a }' "$1.csv" || return
    done >"$1.floor"
    "$radiosity" render "$1.rad" -o "$1.png" --eye 0,1,.9 --at 0,1,-1 --size 160x120
}
alike() { # alike A B: succeeds if the floors' light differs by at most 1 % and the pictures are alike
    paste "$1.floor" "$2.floor" | awk '{ d = ($1 - $2) / $2; if (d * d > 0.0001) off = 1 } END { exit NR != 2 || off }' &&
        [ "$(compare -metric AE -fuzz 4% "$1.png" "$2.png" null: 2>&1)" -lt 200 ]
}
check "a room with a decal a millimetre in front of a wall" decal_room front after -.999
check "... with the decal far behind" decal_room behind after -9
check "... behind the wall that comes first" decal_room last after -1
check "... with a note" grep -q 'polygons overlap in one plane, and the first is in front: line [0-9]* (decal) behind line [0-9]* (wall)$' last.err
check "... has the light and the picture of the decal far behind" alike last behind
check "... in front of the wall that comes later" decal_room first before -1
check "... has the light and the picture of the decal in front" alike first front

# --- Odd shapes and sizes: they are solved, lit, and visible, with at most one note ---
odd() { # odd TEXT [NOTE [ELEMENT]]: solves this OBJ, and checks that
    printf "$1" >model.obj
    solved m model.obj --element "${3-0.01}" --rays 16 && table m.csv 'light += $8 * ($9 + $10 + $11); a += $8' 'a > 0 && light > 0' &&
        "$radiosity" render m.rad -o m.png --size 80x60 >/dev/null && [ "$(convert m.png -format '%[fx:maxima>0.15]' info:)" = 1 ] || return
    grep -v 'nothing in the model emits light: an even sky is added' m.err >notes
    if [ -z "${2-}" ]; then [ ! -s notes ]; else [ "$(wc -l <notes)" = 1 ] && grep -q "$2" notes; fi || { cat notes >&2; return 1; }
}
square='v 0 0 0\nv 0 0 1\nv 1 0 1\nv 1 0 0\n'
check "a square" odd "${square}f 1 2 3 4\n"
check "... reflects 0.7 of a sky of 1, everywhere" table m.csv 'if ($9 < 0.6999 || $9 > 0.7001) ++off' 'off + 0 == 0'
check "a square of 5e8" odd "${square//1/5e8}f 1 2 3 4\n" '' 1e16
check "slivers" odd "${square}v 0.5 0.000002 0.5\nv 1.2 0.5 0.0001\nf 1 4 5\nf 4 6 1\nf 1 2 3 4\n"
check "a box that is turned inside out" odd 'v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0 1 0\nv 1 1 0\nv 1 1 1\nv 0 1 1\nf 4 3 2 1\nf 6 7 8 5\nf 2 6 5 1\nf 4 8 7 3\nf 5 8 4 1\nf 3 7 6 2\n' 'no light reaches the fronts'
check "one part far away" odd "${square}v 15 0 0\nv 15 0 1\nv 16 0 0\nf 1 2 3 4\nf 5 6 7\n"

# --- Rooms, turned by an angle. Each line of input has two corners and the materials of ceiling and walls ---
rooms() { # rooms FILE ANGLE: writes FILE.obj
    awk -v t="$2" 'BEGIN { print "mtllib rooms.mtl"; c = cos(t); s = sin(t) }
        { for (k = 0; k < 8; ++k) {
            x = k > 3 ? $4 : $1; y = int(k / 2) % 2 ? $5 : $2; z = k % 2 ? $6 : $3; u = s * x + c * y
            printf "v %.6f %.6f %.6f\n", c * x - s * y, c * u - s * z, s * u + c * z }
          print "usemtl " $8 "\nf -8 -7 -3 -4\nf -8 -4 -2 -6\nf -7 -5 -1 -3\nf -8 -6 -5 -7\nf -4 -3 -1 -2\nusemtl " $7 "\nf -6 -2 -1 -5" }' >"$1.obj"
}
printf 'newmtl wall\nKd .5 .5 .5\nnewmtl lamp\nKd 0 0 0\nKe 10 10 10\nnewmtl glow\nKd .5 .5 .5\nKe 1 1 1\n' >rooms.mtl
for turn in 0 1; do
    for far in 1e4 5e4 1e6 -5e4; do # negative: the room is far from the origin, not the triangle
        rooms m $turn <<<"$(awk "BEGIN { s = $far < 0 ? $far : 0; print s, 0, 0, s + .4, .3, .5, \"glow glow\" }")"
        awk "BEGIN { s = $far > 0 ? $far : 0; printf \"v %f 0 0\nv %f 0 0\nv %f 1 0\nf -3 -2 -1\n\", s, s + 1, s }" >>m.obj
        check "a room of half a metre that glows, with a triangle $far away, turned by $turn" solved m m.obj
        check "... has its bounces" table m.csv 'if ($1 < 6) { ++n; if ($9 < 1.999 || $9 > 2.001) ++off }' 'n > 5 && off + 0 == 0'
    done
    for next in "1 0 0 2 1 1" "0 1 0 1 2 1"; do # next to the lit room: beyond a wall, above the lamp
        rooms m $turn <<<"$(printf '0 0 0 1 1 1 lamp wall\n%s wall wall\n' "$next")"
        check "a room that shares a wall with one that is lit ($next), turned by $turn" solved m m.obj
        check "... is dark" table m.csv 'if ($1 > 5) { ++n; if ($9 > 0) ++off } else light += $9' 'n > 5000 && light > 5000 && off + 0 == 0'
    done
done
mkfifo fifo
printf "mtllib fifo\n${square}f 1 2 3 4\n" >model.obj
check "a pipe is not read for materials" prints 'materials cannot be read.*not a regular file' bash -c "timeout $PATIENCE '$radiosity' solve model.obj -o m.rad --element 0.01 2>&1"
finish
