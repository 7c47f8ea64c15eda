# `radiosity view` of a room: its pictures against the pictures of `render`; the sky, which the mouse turns; lamps,
# bands and clusters, which keys change.
. "$(dirname "$0")/radiosity_window.sh"
skip_unless perl
shows() { shot && like shot.png "$1" 46; } 2>/dev/null

# A sky whose name has characters that a shell interprets
sky="it's a \$sky\" "
perl -e 'print "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 64\n";
    for $j (0 .. 31) { for $i (0 .. 63) { print pack("C4", $i < 32 ? (200, 90, 40, 129) : (30, 60, 120, 128)) } }' >"$sky"
open_room hall
check "transfer" prints 'lamps 1 lamp, 2 spot' "$radiosity" transfer hall.obj -o hall.prt --rays 32 --element 0.04 --glossy red --rank 8 --clusters 40
at=(--size 240x150 --eye 0,1.5,7 --at 0,1.5,0)
render() { "$radiosity" render hall.prt -o "$1" "${at[@]}" --sky "$sky" "${@:2}" >out; }
view() { "$radiosity" view hall.prt --sky "$sky" "${at[@]}" "$@" >printed 2>err; }
for more in "" "--turn 70 --tilt 40 --bands 2 --lamps 2=3" "--clusters 20 --rank 3 --lamps none"; do
    check "a picture $more" view $more --screenshot view.png
    render render.png $more
    check "... is render's" like view.png render.png 44
done
# What the window shows is compared with its own screenshots
view --screenshot plain.png
view --screenshot one.png --lamps 2
view --screenshot bands.png --bands 1
view --screenshot clusters.png --rank 8
view --screenshot axes.png --rank 7
view --screenshot turned.png --turn 50
for other in one bands turned; do check "$other.png is another picture" eval "! like $other.png plain.png 46"; done
check "a window" begin "$radiosity" view hall.prt --sky "$sky" "${at[@]}"
check "... has the keyboard" await focused
check "... prints its keys" await grep -q '1 .. 9 0  *lamps' out
check "... shows the picture" await shows plain.png
check "... and describes it in the title" await titled 'turn 0  tilt 0  5 bands  exact rows  lamps 1 2'
on_key 1 "key 1: without the first lamp" shows one.png
check "... and the title lists the other" await titled 'lamps 2 '
on_key 1 "... and back" shows plain.png
on_key 'bracketleft bracketleft bracketleft bracketleft' "key [: fewer bands" titled '1 bands'
check "... shows" await shows bands.png
on_key 'bracketright bracketright bracketright bracketright' "key ]: and back" shows plain.png
on_key p "key P: clusters" titled '40 clusters of 8 axes'
check "... show" await shows clusters.png
on_key minus "key -: one axis less" titled 'of 7 axes'
check "... shows" await shows axes.png
on_key equal "key =: and back" titled 'of 8 axes'
on_key period "key .: twice as many clusters" titled '80 clusters of 8 axes  lamps'
on_key p "key P: exact rows again" titled 'exact rows'
await shows plain.png
on_key F3 "key F3: outlines of elements" titled '  elements'
on_key F3 "... and back" shows plain.png
xdotool mousemove --window "$window" 50 100 mousedown 3 mousemove --window "$window" 80 100 mousemove --window "$window" 200 100 mouseup 3
check "the right button turns the sky" await shows turned.png
check "... by a third of a degree for a pixel" await titled 'turn 50 '
# A shell can read the line that key C prints, with clusters, a tilt, and the sky's name
xdotool mousemove --window "$window" 100 100 mousedown 3 mousemove --window "$window" 100 85 mouseup 3
await titled 'tilt 5  '
on_key 'p comma minus' "other clusters" titled '40 clusters of 7 axes  lamps'
on_key c "key C prints the light too" grep -qE -- '--turn 50 --tilt 5 --bands 5 --clusters 40 --rank 7 --lamps 1,2$' out
line=$(grep -e '^--eye' out | tail -n 1)
again() { eval "\"$radiosity\" $1 $line" >printed; }
check "... for render, and for view" eval "again 'render hall.prt -o render.png' && again 'view hall.prt --screenshot view.png'"
like_both() { shot && like shot.png view.png 46 && like shot.png render.png 44; }
check "... which show the same" await like_both
check "ESC ends it with status 0, silently" escapes

# More lamps than number keys, some of strengths other than 1
balls=()
for k in $(seq 11); do balls+=(--lamp "-1.$((9 - k % 10)),0.$((k % 9 + 1)),-1.$((k % 9)),0.2,$((k % 3)),2,$((k % 2))"); done
check "a room of 13 lamps" prints '13 ball 11$' "$radiosity" transfer hall.obj -o many.prt --rays 16 --element 0.04 --bands 2 "${balls[@]}"
many() { "$radiosity" view many.prt "${at[@]}" "$@" >printed 2>err; }
many --screenshot three.png --lamps 1,2=3,12=9
many --screenshot without.png --lamps 1,2=3
check "without the twelfth lamp the picture differs" eval "! like without.png three.png 46"
check "a window" begin "$radiosity" view many.prt "${at[@]}" --lamps 1,2=3,12=9
await focused
check "... with three of them" await titled 'lamps 1 2 12 '
await shows three.png
on_key shift+2 "Shift and 2: without the twelfth" shows without.png
on_key shift+2 "... which comes back with its strength" shows three.png
on_key shift+3 "Shift and 3: the thirteenth, which was off" titled 'lamps 1 2 12 13 '
on_key c "key C prints strengths" grep -qE -- '--lamps 1,2=3,12=9,13$' out
on_key 'shift+4 shift+9' "Shift and numbers of no lamp do nothing" titled 'lamps 1 2 12 13 '
check "ESC ends it" escapes
check "--spin turns the sky" prints '^[0-9.]+ pictures a second of 240 x 150' "$radiosity" view hall.prt --sky "$sky" "${at[@]}" --spin 1
check "--spin with a model that cannot be relit" refuses 2 "--spin is for a room" "$radiosity" view hall.obj --spin 1
finish
