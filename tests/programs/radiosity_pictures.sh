# Materials with pictures (map_Kd): the light of elements against closed forms. (pictured_test compares each element's
# part of its picture, picture_file_test reads and refuses files.)
. "$(dirname "$0")/radiosity_program.sh"
skip_unless convert

# A furnace of fine checks, black and sRGB 188, which is 0.5029: all surfaces emit 1, so all have 1 / (1 - Kd 0.2514)
convert -size 512x512 pattern:gray50 +level 0,73.7255% -depth 8 -type TrueColor checks.png
printf 'newmtl all\nKd 0.5 1 0.25\nKe 1 1 1\nmap_Kd checks.png\n' >room.mtl
awk 'BEGIN {
    print "mtllib room.mtl\nusemtl all\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1"
    for (k = 0; k < 8; ++k) print "v", k % 2, int(k / 2) % 2, int(k / 4)
    n = split("1 5 6 2|3 4 8 7|1 3 7 5|2 6 8 4|1 2 4 3|5 7 8 6", f, "|")
    for (i = 1; i <= n; ++i) { split(f[i], p, " "); print "f " p[1] "/1 " p[2] "/2 " p[3] "/3 " p[4] "/4" } }' >room.obj
check "a furnace with a checkerboard" solved room room.obj --hemicube 32 --patch 0.01 --element 0.01
check "... reflects their mean times Kd, and prints nothing" eval '[ ! -s room.err ] && table room.csv "a += \$8; r += \$8 * \$9; g += \$8 * \$10; b += \$8 * \$11" "r / a > 1.135 && r / a < 1.153 && g / a > 1.325 && g / a < 1.347 && b / a > 1.059 && b / a < 1.076"'

# A floor under an even sky of 1 has its reflectance as radiance: red on the left, blue on the right, black above
mkdir -p 'sub/my pictures'
convert -size 32x16 xc:red -fill blue -draw 'rectangle 16,0 31,15' -fill black -draw 'rectangle 0,0 31,7' 'sub/my pictures/Floor.png'
printf 'mtllib sub\\floor.mtl\nusemtl m\nv -1 0 -1\nv -1 0 1\nv 1 0 1\nv 1 0 -1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/4 2/1 3/2\nf 1/4 3/2 4/3\n' >floor.obj
floor() { # floor MTL-LINES: solves the floor, and writes floor.csv
    printf "newmtl m\nKd 1 1 1\n$1" >sub/floor.mtl
    solved floor floor.obj --element 0.0016 --rays 16 --sky 1,1,1
}
shows() { # shows RED BLUE: what is red and what is blue, by X and Y (-1 .. 1, Y up). Skips 0.04 around borders
    table floor.csv "X = \$2; Y = -\$4; if (X * X > 0.0016 && Y * Y > 0.0016 && (X - 0.5) ^ 2 > 0.0016 && (X + 0.5) ^ 2 > 0.0016 && (Y - 0.5) ^ 2 > 0.0016 && (Y + 0.5) ^ 2 > 0.0016) {
        ++n; off += \$9 < ($1) - 0.005 || \$9 > ($1) + 0.005 || \$11 < ($2) - 0.005 || \$11 > ($2) + 0.005 || \$10 > 0.005 }" 'n > 1000 && off == 0'
}
check "a picture that is scaled" floor 'map_Kd -s 2 2 my pictures/Floor.png\n'
check "... repeats" shows '(X < -0.5 || (X > 0 && X < 0.5)) && (Y < -0.5 || (Y > 0 && Y < 0.5))' '(X > 0.5 || (X < 0 && X > -0.5)) && (Y < -0.5 || (Y > 0 && Y < 0.5))'
check "... with -clamp on, and moved, is continued by its border" floor 'map_Kd -clamp on -s 2 2 -o 0.5 0 my pictures/Floor.png\n'
check "... which is blue" shows 0 'Y < -0.5'
check "a floor whose picture is in another folder, named with backslashes and other capitals" floor 'map_Kd my pictures\\\\floor.PNG\n'
check "... has the picture in its place" shows 'X < 0 && Y < 0' 'X > 0 && Y < 0'
check "it is seen" "$radiosity" render floor.rad -o floor.png --eye 0,2.5,0.01 --at 0,0,0 --size 200x200 --exposure -1
colour() { convert floor.png -format "%[fx:p{$1}.r>0.1] %[fx:p{$1}.b>0.1]" info:; }
check "... red below on the left, blue on the right, black above" eval '[ "$(colour 60,140) $(colour 140,140) $(colour 60,60)" = "1 0 0 1 0 0" ]'
check "lightmaps come with a picture of the reflectance" eval '"$radiosity" export floor.rad --atlas light >out && [ "$(convert light/reflectance-0.png -format "%[fx:maxima.r] %[fx:maxima.g] %[fx:maxima.b]" info:)" = "1 0 1" ]'

# Final rays see the picture, too: beneath a board over its red half there is more red than blue
{ cat floor.obj; printf 'usemtl none\nv -1 0.4 -1\nv 0 0.4 -1\nv 0 0.4 1\nv -1 0.4 1\nf 5 6 7 8\n'; } >board.obj
check "a board over a floor" eval 'solved without board.obj --sky 1,1,1 --element 0.01 && solved with board.obj --sky 1,1,1 --element 0.01 --final 256'
beneath() { awk -F, '$6 < -0.5 { a += $8; r += $8 * $9; g += $8 * $10; b += $8 * $11 } END { print r / a, g / a, b / a }' "$1.csv"; }
check "... gets more red than blue; with final gathering the same" \
    awk 'NR == 1 { r = $1; b = $3; bad = !(r - $2 > 3 * (b - $2) && b > $2) } END { exit bad || NR != 2 || ($1 / r - 1) ^ 2 > 0.0016 || ($3 / b - 1) ^ 2 > 0.0016 }' <(beneath without) <(beneath with)

# If a picture cannot be read, a line is printed and Kd is used
mkfifo sub/fifo.png
for missing in none fifo; do
    check "$missing.png" eval 'floor "Kd 0.25 0.25 0.25\nmap_Kd $missing.png\n" && grep -q "the material.s colour is used" floor.err'
    check "... leaves the colour Kd" table floor.csv 'if ($9 < 0.2499 || $9 > 0.2501) ++off' 'off + 0 == 0'
done
finish
