# Materials with pictures (map_Kd): what elements reflect, against closed forms. And pictures that cannot be read.
. "$(dirname "$0")/radiosity_program.sh"
skip_unless convert

# A furnace of fine checks, black and sRGB 188, which is 0.5029: all surfaces emit 1, so all have 1 / (1 - 0.2514)
convert -size 512x512 pattern:gray50 +level 0,73.7255% -depth 8 -type TrueColor checks.png
room() { # room MTL-LINES: room.obj, with the picture once on each wall
    printf "newmtl all\n$1" >room.mtl
    awk 'BEGIN {
        print "mtllib room.mtl\nusemtl all\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1"
        for (k = 0; k < 8; ++k) print "v", k % 2, int(k / 2) % 2, int(k / 4)
        n = split("1 5 6 2|3 4 8 7|1 3 7 5|2 6 8 4|1 2 4 3|5 7 8 6", f, "|")
        for (i = 1; i <= n; ++i) { split(f[i], p, " "); print "f " p[1] "/1 " p[2] "/2 " p[3] "/3 " p[4] "/4" } }' >room.obj
    rm -f room.rad room.csv
    "$radiosity" solve room.obj -o room.rad --hemicube 32 --patch 0.01 >out 2>err && "$radiosity" export room.rad --csv room.csv
}
even() { # even FILE COLUMN VALUE: the mean over the area, within 0.8 %
    table "$1" "a += \$8; s += \$8 * \$$2" "s / a > 0.992 * $3 && s / a < 1.008 * $3"
}
check "a furnace of checks" room 'Kd 1 1 1\nKe 1 1 1\nmap_Kd checks.png\n'
check "... has their mean" even room.csv 9 1.3359
check "... silently" test ! -s err
for kind in jpg tga bmp; do
    convert checks.png -quality 100 -compress None -type TrueColor ${kind/bmp/bmp3}:checks.$kind
    check "... as $kind" room "Ke 1 1 1\nmap_Kd checks.$kind\n"
    check "... too, and without Kd" even room.csv 10 1.3359
done
check "Kd multiplies the picture" room 'Kd 0.5 1 0.25\nKe 1 1 1\nmap_Kd checks.png\n'
check "... red" even room.csv 9 1.1438
check "... green" even room.csv 10 1.3359
check "... blue" even room.csv 11 1.0671
check "a Kd of 0 leaves it alone" room 'Kd 0 0 0\nKe 1 1 1\nmap_Kd checks.png\n'
check "... as it is" even room.csv 9 1.3359

# A floor under an even sky of 1 shows what it reflects: red to the left of its middle, blue to the right, black above
mkdir -p 'sub/my pictures'
convert -size 32x16 xc:red -fill blue -draw 'rectangle 16,0 31,15' -fill black -draw 'rectangle 0,0 31,7' 'sub/my pictures/Floor.png'
floor() { # floor MTL-LINES [OPTION...]: floor.csv
    printf "newmtl m\nKd 1 1 1\n$1" >sub/floor.mtl
    printf 'mtllib sub\\floor.mtl\nusemtl m\nv -1 0 -1\nv -1 0 1\nv 1 0 1\nv 1 0 -1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/4 2/1 3/2\nf 1/4 3/2 4/3\n' >floor.obj
    rm -f floor.rad floor.csv
    "$radiosity" solve floor.obj -o floor.rad "${@:2}" >out 2>err && "$radiosity" export floor.rad --csv floor.csv
}
shows() { # shows RED BLUE: conditions on a place X, Y of the floor, -1 .. 1 from below; not within 0.02 of a border
    table floor.csv "X = \$2; Y = -\$4; if (X * X > 0.0004 && Y * Y > 0.0004 && (X - 0.5) ^ 2 > 0.0004 && (X + 0.5) ^ 2 > 0.0004 && (Y - 0.5) ^ 2 > 0.0004 && (Y + 0.5) ^ 2 > 0.0004) {
        ++n; off += \$9 < ($1) - 0.005 || \$9 > ($1) + 0.005 || \$11 < ($2) - 0.005 || \$11 > ($2) + 0.005 || \$10 > 0.005 }" 'n > 1000 && off == 0'
}
below='map_Kd my pictures\\\\floor.PNG\n'
check "a floor, its picture in another folder, by backslashes and other capitals" floor "$below" --sky 1,1,1
check "... shows it where it lies" shows 'X < 0 && Y < 0' 'X > 0 && Y < 0'
check "... in two triangles and in two colours" floor "$below" --sky 1,1,1 --element 0.01 --adaptive --sun 90,0,0,0,0
check "... and over the area as much as it has" table floor.csv 'r += $8 * $9; b += $8 * $11' 'r > 0.99 && r < 1.01 && b > 0.99 && b < 1.01'
check "a picture that is scaled" floor 'map_Kd -s 2 2 my pictures/Floor.png\n' --sky 1,1,1
check "... repeats" shows '(X < -0.5 || (X > 0 && X < 0.5)) && (Y < -0.5 || (Y > 0 && Y < 0.5))' '(X > 0.5 || (X < 0 && X > -0.5)) && (Y < -0.5 || (Y > 0 && Y < 0.5))'
check "... with -clamp on goes on as its border is" floor 'map_Kd -clamp on -s 2 2 my pictures/Floor.png\n' --sky 1,1,1
check "... which is half red, half blue" shows 'X < -0.5 && Y < -0.5' 'X > -0.5 && Y < -0.5'
check "one that is moved" floor 'map_Kd -o 0.5 0 my pictures/Floor.png\n' --sky 1,1,1
check "... is" shows 'X > 0 && Y < 0' 'X < 0 && Y < 0'
check "both sides" floor "$below" --sky 1,1,1 --two-sided
check "... have it" shows 'X < 0 && Y < 0' 'X > 0 && Y < 0'
check "it is seen" "$radiosity" render floor.rad -o floor.png --eye 0,2.5,0.01 --at 0,0,0 --size 200x200 --exposure -1
colour() { convert floor.png -format "%[fx:p{$1}.r>0.1] %[fx:p{$1}.b>0.1]" info:; }
check "... red below on the left" test "$(colour 60,140)" = "1 0"
check "... blue on the right" test "$(colour 140,140)" = "0 1"
check "... black above" test "$(colour 60,60)" = "0 0"
check "lightmaps have it" "$radiosity" export floor.rad --atlas shown --map radiosity
check "... or beside them what is reflected" "$radiosity" export floor.rad --atlas light
check "... as a page" test "$(convert light/reflectance-0.png -format '%[fx:maxima.r] %[fx:maxima.g] %[fx:maxima.b]' info:)" = "1 0 1"

# Final rays see the picture, too: beneath a board over its red half there is more red than blue
board() { # board OPTION...: board.csv
    { cat floor.obj; printf 'usemtl none\nv -1 0.4 -1\nv 0 0.4 -1\nv 0 0.4 1\nv -1 0.4 1\nf 5 6 7 8\n'; } >board.obj
    "$radiosity" solve board.obj -o board.rad --sky 1,1,1 "$@" >out 2>err && "$radiosity" export board.rad --csv board.csv
}
beneath() { # beneath COLUMN: the mean over the board, within 4 % of what it is without final rays
    local mean; mean=$(awk -F, '$6 < -0.5 { a += $8; s += $8 * $'"$1"' } END { print s / a }' without.csv)
    table board.csv "if (\$6 < -0.5) { a += \$8; s += \$8 * \$$1 }" "s / a > 0.96 * $mean && s / a < 1.04 * $mean"
}
check "a board over a floor" board
mv board.csv without.csv
check "... has more red than blue beside what is green" table without.csv 'if ($6 < -0.5) { r += $9; g += $10; b += $11 }' 'r - g > 3 * (b - g) && b > g'
check "... with final gathering" board --final 256
check "... as red" beneath 9
check "... and as blue" beneath 11

# For a picture that cannot be read a line is printed, and Kd is used
unread() { # unread TEXT PICTURE
    { floor "Kd 0.25 0.25 0.25\nmap_Kd $2\n" --sky 1,1,1 && grep -q -- "$1" err && grep -q "the material's colour is used" err &&
        table floor.csv 'if ($9 < 0.2499 || $9 > 0.2501) ++off' 'off + 0 == 0'; } || { head -c 400 err >&2; false; }
}
check "a picture that is missing" unread 'sub/none.png: No such file' none.png
check "a file that is no picture" unread 'its format is unknown' floor.mtl
head -c 700 checks.png >sub/cut.png
check "a picture cut short" unread 'it is damaged' cut.png
printf '\211PNG\r\n\032\n\0\0\0\rIHDR\0\0\43\50\0\0\43\50\10\2\0\0\0\342\267\345\355\0\0\0\0IEND\256B`\202' >sub/vast.png
check "a picture that is too large" unread 'no pixels, or more than 2^26' vast.png
truncate -s 300M sub/long.png
check "a long file" unread 'more than 256 MB' long.png
mkfifo sub/fifo.png
check "a pipe in place of a picture" unread 'not a regular file' fifo.png
check "a folder in place of a picture" unread 'not a regular file' "."
check "a scale that is too large" refuses 2 "a scale or offset is not a number below 1e6" bash -c "printf 'newmtl m\nmap_Kd -s 1e30 1 a.png\n' >sub/floor.mtl; '$radiosity' solve floor.obj -o x.rad"
finish
