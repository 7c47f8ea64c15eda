# `radiosity view` of a room: its pictures against those of `render`, the sky turned by the mouse, lamps, bands and
# clusters by keys, and the rate.
. "$(dirname "$0")/radiosity_window.sh"
skip_unless perl
shows() { shot && like shot.png "$1" 46; } 2>/dev/null

perl -e 'print "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 64\n";
    for $j (0 .. 31) { for $i (0 .. 63) { print pack("C4", $i < 32 ? (200, 90, 40, 129) : (30, 60, 120, 128)) } }' >sky.hdr
open_room hall
check "transfer" prints 'lamps 1 lamp, 2 spot' "$radiosity" transfer hall.obj -o hall.prt --rays 64 --element 0.02 --glossy red --rank 8 --clusters 40
at=(--size 320x200 --eye 0,1.5,7 --at 0,1.5,0)
render() { "$radiosity" render hall.prt -o "$@" "${at[@]}" --sky sky.hdr >out; }
view() { "$radiosity" view hall.prt --relight sky.hdr "${at[@]}" "$@" >printed 2>err; }
render plain.png
check "a picture" view --screenshot view.png
check "... is render's" like view.png plain.png 44
check "... and the loss is printed" grep -q 'sky.hdr: 5 bands hold' printed
for more in "--turn 70" "--lamps none" "--lamps 2=3" "--bands 2" "--rank 3" "--tilt 40" "--clusters 20" "--clusters 3 --rank 1"; do
    check "with $more" view $more --screenshot view.png
    render render.png $more
    check "... is render's" like view.png render.png 44
done
# Where z is up, which the room knows
awk '/^v/ { print $1, $2, -$4, $3; next } 1' hall.obj >tall.obj
"$radiosity" transfer tall.obj -o tall.prt --rays 16 --element 0.1 --up z >out
check "a room whose z is up" "$radiosity" view tall.prt --size 320x200 --screenshot view.png
"$radiosity" render tall.prt -o render.png --size 320x200 --up z >out
check "... is seen so without --up" like view.png render.png 44
# What the window shows is compared with its own screenshots
view --screenshot plain.png
view --screenshot one.png --lamps 2
view --screenshot two.png --lamps 1
view --screenshot bands.png --bands 1
view --screenshot clusters.png --rank 8
view --screenshot axes.png --rank 7
view --screenshot turned.png --turn 50
for other in one two bands turned; do check "$other.png is another picture" eval "! like $other.png plain.png 46"; done
check "a window" begin "$radiosity" view hall.prt --relight sky.hdr "${at[@]}"
check "... has the keyboard" await focused
check "... prints its keys" await grep -q '1 .. 9 0 lamps' out
check "... shows the picture" await shows plain.png
check "... and what it is" titled 'turn 0  tilt 0  5 bands  exact rows  lamps 1 2'
on_key 1 "key 1: without the first lamp" shows one.png
check "... and the title lists the other" await titled 'lamps 2 '
on_key 1 "... and back" shows plain.png
on_key 2 "key 2: without the second" shows two.png
on_key 2 "... and back" shows plain.png
on_key 'bracketleft bracketleft bracketleft bracketleft' "key [: fewer bands" titled '1 bands'
check "... shows" await shows bands.png
on_key 'bracketright bracketright bracketright bracketright' "key ]: and back" shows plain.png
on_key p "key P: clusters" titled '40 clusters of 8 axes'
check "... show" await shows clusters.png
on_key minus "key -: an axis less" titled 'of 7 axes'
check "... shows" await shows axes.png
on_key equal "... and back" titled 'of 8 axes'
on_key period "key .: twice as many clusters" titled '80 clusters of 8 axes  lamps'
on_key comma "... and back" titled '40 clusters'
on_key comma "key ,: half as many" titled '20 clusters'
on_key p "key P: exact rows again" titled 'exact rows'
await shows plain.png
on_key F3 "key F3: outlines of elements" titled '  elements'
on_key F3 "... and back" shows plain.png
xdotool mousemove --window "$window" 100 100 mousedown 3 mousemove --window "$window" 130 100 mousemove --window "$window" 250 100 mouseup 3
check "the right button turns the sky" await shows turned.png
check "... by a third of a degree for a pixel" await titled 'turn 50 '
on_key c "key C prints the light too" grep -qE -- '--tone film --size 320x200 --sky sky.hdr --turn 50 --tilt 0 --bands 5 --lamps 1,2$' out
check "ESC ends it with status 0, silently" escapes

# The line of key C, read by a shell: clusters, a tilt, and a sky with an odd name
odd="it's a \$sky\" "
cp sky.hdr "$odd"
check "a window" begin "$radiosity" view hall.prt --relight "$odd" --tilt 25 "${at[@]}"
await focused
check "... whose title has the tilt" await titled 'turn 0  tilt 25  5 bands'
on_key 'comma minus' "... and other clusters" titled '20 clusters of 7 axes  lamps'
xdotool mousemove --window "$window" 100 100 mousedown 3 mousemove --window "$window" 130 100 mouseup 3
xdotool mousemove --window "$window" 100 100 mousedown 3 mousemove --window "$window" 100 85 mouseup 3
await titled 'turn 10  tilt 30  '
on_key c "key C prints clusters" grep -qE -- '--turn 10 --tilt 30 --bands 5 --clusters 20 --rank 7 --lamps 1,2$' out
line=$(grep -e '^--eye' out | tail -n 1)
again() { eval "\"$radiosity\" $1 $line" >printed; }
check "... for render" again 'render hall.prt -o render.png'
check "... for view" again 'view hall.prt --screenshot view.png'
like_both() { shot && like shot.png view.png 46 && like shot.png render.png 44; }
check "... which show the same" await like_both
check "ESC ends it" escapes
check "as many clusters as there are" "$radiosity" render hall.prt -o own.png "${at[@]}" --rank 8 --clusters 40
"$radiosity" render hall.prt -o axes.png "${at[@]}" --rank 8 >out
check "... are those" cmp own.png axes.png
check "clusters for what has none" refuses 2 "--clusters is for a room" "$radiosity" view hall.obj --clusters 3
check "more clusters than texels" refuses 2 "--clusters: the room has" "$radiosity" render hall.prt -o x.png --clusters 4000

# More lamps than there are numbers, and of other strengths than 1
balls=()
for k in $(seq 11); do balls+=(--lamp "-1.$((9 - k % 10)),0.$((k % 9 + 1)),-1.$((k % 9)),0.2,$((k % 3)),2,$((k % 2))"); done
check "a room of 13 lamps" prints '13 ball 11$' "$radiosity" transfer hall.obj -o many.prt --rays 16 --element 0.04 --bands 2 "${balls[@]}"
many() { "$radiosity" view many.prt "${at[@]}" "$@" >printed 2>err; }
many --screenshot three.png --lamps 1,2=3,12=9
many --screenshot weak.png --lamps 1,2,12=9
many --screenshot without.png --lamps 1,2=3
many --screenshot first.png --lamps 1,12=9
for other in weak without first; do check "$other.png is another picture" eval "! like $other.png three.png 46"; done
check "a window" begin "$radiosity" view many.prt "${at[@]}" --lamps 1,2=3,12=9
await focused
check "... with three of them" await titled 'lamps 1 2 12 '
await shows three.png
on_key shift+2 "Shift and 2: without the twelfth" shows without.png
on_key shift+2 "... which comes back as strong as it was" shows three.png
on_key 2 "key 2: without the second" shows first.png
on_key 2 "... which comes back, too" shows three.png
on_key shift+3 "Shift and 3: the thirteenth, which was off" titled 'lamps 1 2 12 13 '
on_key c "key C prints strengths" grep -qE -- '--lamps 1,2=3,12=9,13$' out
on_key 'shift+4 shift+9' "Shift and numbers of no lamp do nothing" titled 'lamps 1 2 12 13 '
check "ESC ends it" escapes

# Clusters for which there is no memory: their axes take 65 MB, and 40 are left
if command -v prlimit >/dev/null; then
    check "a room of 2048 clusters" prints '^2048 clusters of 32 axes' "$radiosity" transfer hall.obj -o large.prt --rays 16 --element 0.012 --bands 6 --rank 32 --clusters 2048
    "$radiosity" view large.prt "${at[@]}" --rank 32 --screenshot large.png >out
    check "a window" begin "$radiosity" view large.prt "${at[@]}" --rank 32
    await focused
    await titled '2048 clusters of 32 axes'
    size=$(awk '/^VmSize/ { print $2 * 1024 }' /proc/$pid/status)
    prlimit --pid $pid --as=$((size + 40000000))
    on_key period "too little memory for more clusters is reported" grep -q '^radiosity: 4096 clusters cannot be found: there is not enough memory.*; the 2048 stay$' err
    check "... in one line" test "$(wc -l <err)" = 1
    check "... and the old ones stay" await titled '2048 clusters of 32 axes  lamps'
    on_key p "... while the window goes on" titled 'exact rows'
    on_key p "... and shows them" shows large.png
    xdotool key Escape
    ended $pid
    check "... until ESC ends it" test $? = 0
else
    echo "not checked: prlimit is not installed"
fi

check "a turn of the sky" prints '^[0-9.]+ pictures a second of 320 x 200' "$radiosity" view hall.prt --relight sky.hdr "${at[@]}" --spin 2
sed -n '$p' printed
check "... is more than a few pictures" eval 'less 3 "$(sed -nE "s/^([0-9.]+) pictures a second.*/\1/p" printed)"'
check "--spin for what cannot be relit" refuses 2 "--spin is for a room" "$radiosity" view hall.obj --spin 1
check "--relight for a model" refuses 2 "--relight is for a room" "$radiosity" view hall.obj --relight sky.hdr
check "options of solve for a room" refuses 2 "--rays is an option for models" "$radiosity" view hall.prt --rays 8
finish
