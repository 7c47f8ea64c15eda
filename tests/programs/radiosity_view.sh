# `radiosity view`: its pictures against the pictures of `radiosity render`; its layers, keys, mouse and wheel; and
# models that are solved while they are shown.
. "$(dirname "$0")/radiosity_window.sh"

view() { "$radiosity" view "$@" >printed 2>err; }
pixels() { identify -format '%#' "$1"; } # equal for equal pictures
shows() { shot && [ "$(pixels shot.png)" = "$(pixels "$1")" ]; } 2>/dev/null
alters() { shot && [ "$(pixels shot.png)" != "$(pixels "$1")" ]; } 2>/dev/null
# part FILE WIDTHxHEIGHT+X+Y r|g|b: prints the mean of a channel in a part of a picture. most: prints 0.7 times as much
part() { convert "$1" -crop "$2" +repage -format "%[fx:255*mean.$3]" info:; }
most() { convert "$1" -crop "$2" +repage -format "%[fx:255*mean.$3*0.7]" info:; }

"$radiosity" generate cube -o cube.obj >out
check "solve a cube" prints '^processor' "$radiosity" solve cube.obj -o cube.rad --element 0.1 --rays 64
# Bumps of hundreds of small triangles, where z is up
awk 'BEGIN { n = 20; print "mtllib bumps.mtl\nusemtl grey"
    for (j = 0; j <= n; ++j) for (i = 0; i <= n; ++i) printf "v %g %g %g\n", i / n * 8 - 4, 4 - j / n * 8, 0.4 * sin(i / 3) * cos(j / 3)
    for (j = 0; j < n; ++j) for (i = 0; i < n; ++i) { a = j * (n + 1) + i + 1; print "f", a, a + n + 1, a + 1; print "f", a + 1, a + n + 1, a + n + 2 } }' >bumps.obj
printf 'newmtl grey\nKd 0.5 0.4 0.3\n' >bumps.mtl
sky=(--sun 30,90,3,3,3 --sky 0.2,0.3,0.5 --up z --element 0.02 --rays 32)
check "solve bumps" prints '^800 triangles' "$radiosity" solve bumps.obj -o bumps.rad "${sky[@]}"

# --- Pictures are the tracer's, except on edges, where the samples differ, and within elements, where triangles
# interpolate a little differently. Measured: 48 to 56 dB; 30 in the log tone, whose darkest pixels are edges ---
compared() { # compared DB SOLUTION OPTION...: succeeds if view and render draw alike
    local least=$1
    shift
    view "$@" --screenshot view.png && "$radiosity" render "$1" -o render.png "${@:2}" >out && like view.png render.png "$least"
}
size=(--size 300x200) inside=(--size 300x200 --eye 0,5,4.9 --at 0,4,-5)
check "bumps look as render shows them" compared 44 bumps.rad "${size[@]}" --up z
check "... from the camera that render prints" cmp -s out <(grep -e --eye printed)
check "... and the cube from inside" compared 44 cube.rad "${inside[@]}" --lens 100 --exposure -1
check "... in the logarithmic tone" compared 28 cube.rad "${inside[@]}" --tone log

# --- Models that are solved while they are shown ---
for kind in "bumps ${sky[*]}" "cube --direct hemicube --bounces 3 --patch 2"; do
    set -- $kind
    model=$1 && shift
    "$radiosity" solve "$model.obj" -o model.rad "$@" >out
    up=() && [ $model = cube ] || up=(--up z)
    view model.rad "${size[@]}" "${up[@]}" --screenshot file.png
    check "$kind, solved while it is shown" view "$model.obj" "${size[@]}" --screenshot live.png "$@"
    check "... ends with the light of the file" eval '[ "$(pixels live.png)" = "$(pixels file.png)" ]'
done

# --- Layers. A plate of 2 x 2 with 4 x 4 patches and 8 x 8 elements fills most of a picture ---
printf 'mtllib bumps.mtl\nusemtl grey\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n' >plate.obj
"$radiosity" solve plate.obj -o plate.rad --patch 0.25 --element 0.0625 >out 2>err
check "a plate has 16 patches and 64 elements" grep -q '; 16 patches, 64 elements' out
front=(--size 200x200 --eye 0,0,2 --at 0,0,0 --lens 60)
view plate.rad "${front[@]}" --screenshot plain.png
check "patches" view plate.rad "${front[@]}" --layer patches --screenshot patches.png
# Pixels where patches meet are averages: each of these colours has few pixels
colours() { convert "$1" -format '%c' histogram:info: | awk '$1 + 0 >= 100' | wc -l; }
check "... are 16 colours, before black" eval '[ "$(colours patches.png)" = 17 ] && [ "$(colours plain.png)" -lt 17 ]'
check "elements" view plate.rad "${front[@]}" --layer elements --screenshot elements.png
# lines GEOMETRY: counts the lines across a row or column, by differences from the plain picture
lines() { convert elements.png plain.png -compose difference -composite -crop "$1" +repage -threshold 3% txt: | awk '/white|#FFF|255,255,255/ { if (!on) ++n; on = 1; next } !/^#/ { on = 0 } END { print n }'; }
check "... have 7 lines between 8 of them" eval '[ "$(lines 160x1+20+110)" = 7 ] && [ "$(lines 1x160+110+20)" = 7 ]'
check "wireframe" view plate.rad "${front[@]}" --layer wireframe --screenshot wire.png
# A plate of width 2 at the distance of 2 takes 173 of 200 pixels
check "... is a rectangle's edges, with nothing between" eval '[ "$(convert wire.png -trim -format "%[fx:w>=172&&w<=176]" info:)" = 1 ] && [ "$(convert wire.png -crop 160x160+20+20 -format "%[fx:maxima]" info:)" = 0 ]'
check "the back is not shown" eval 'view plate.rad --size 200x200 --eye 0,0,-2 --at 0,0,0 --screenshot back.png --layer elements && [ "$(convert back.png -format "%[fx:maxima]" info:)" = 0 ]'
# From the middle of the cube's far wall the red wall is on the right, the green one on the left, the lamp above. Its
# hemicube lies in the lower right corner: 4 x 37 pixels wide, 8 from the borders; the top face in its middle
check "hemicube" view cube.rad --size 480x300 "${inside[@]:2}" --layer hemicube --screenshot hemicube.png
check "... red on its right" eval 'less "$(part hemicube.png 20x40+448+198 g)" "$(most hemicube.png 20x40+448+198 r)"'
check "... green on its left" eval 'less "$(part hemicube.png 20x40+326+198 r)" "$(most hemicube.png 20x40+326+198 g)"'
check "... a lamp above, and none below" eval '[ "$(convert hemicube.png -crop 74x37+361+144 -format "%[fx:maxima.b > 0.98]" info:)$(convert hemicube.png -crop 74x37+361+255 -format "%[fx:maxima.b > 0.98]" info:)" = 10 ]'

# --- Keys, mouse and wheel ---
at=(--eye 1,5,4.9 --at 0,4,-5 --lens 50)
for layer in patches elements wireframe; do view cube.rad "${size[@]}" "${at[@]}" --layer $layer --screenshot $layer.png; done
view cube.rad "${size[@]}" "${at[@]}" --screenshot plain.png
view cube.rad "${size[@]}" "${at[@]}" --tone log --screenshot log.png
view cube.rad "${size[@]}" "${at[@]}" --exposure 0.5 --screenshot bright.png
check "a window" begin "$radiosity" view cube.rad "${size[@]}" "${at[@]}"
check "... has the keyboard" await focused
check "... has the size given" measures 300 200
check "... prints its keys" await grep -qx '2          elements' out
check "... shows the picture" await shows plain.png
number=0
for layer in patches elements wireframe; do
    number=$((number + 1))
    on_key "$number" "key $number shows $layer" shows $layer.png
    check "... and names it in the title" await titled "  $layer"
    on_key "$number" "... and hides it when pressed again" shows plain.png
done
on_key h "key H shows the keys" alters plain.png
on_key F1 "key F1 hides them" shows plain.png
on_key t "key T: the logarithm" shows log.png
xdotool key t
xdotool mousemove --window "$window" 150 100 click 4 click 4
check "the wheel: half a stop brighter" await shows bright.png
xdotool click 5 click 5
check "... and back" await shows plain.png
on_key 4 "key 4: the hemicube of the patch under the pointer" alters plain.png
shot && mv shot.png middle.png
xdotool mousemove --window "$window" 30 100
check "... of another one" await alters middle.png
on_key 4 "... and none" shows plain.png

# Flying
camera() { grep -e '^--eye' out | tail -n 1; }
lines=0
printed() { [ "$(grep -ce '^--eye' out)" -gt $lines ]; }
prints_camera() { lines=$(grep -ce '^--eye' out); xdotool key c; await printed; }
check "key C prints the camera" prints_camera
check "... at its first place" eval '[ "$(camera)" = "${at[*]} --up y --exposure 0 --tone film --size 300x200" ]'
flies() { # flies KEY COORDINATE: holds the key until the coordinate changes
    await rests
    from=$(place "$2")
    xdotool keydown "$1"
    await flown "$2"
    xdotool keyup "$1"
}
# A released key moves the camera for one more picture
rests() {
    local was
    was=$(camera)
    prints_camera && [ "$(camera)" = "$was" ]
}
flown() { prints_camera && [ "$(place "$1")" != "$from" ]; }
place() { camera | awk -v k="$1" '{ split($2, eye, ","); split($4, at, ","); print (k > 3 ? at[k - 3] : eye[k]) }'; }
ahead() { # ahead SIGN FROM TO: succeeds if TO is above FROM (SIGN 1) or below it (-1)
    [ $1 = 1 ] && less "$2" "$3" || { [ $1 = -1 ] && less "$3" "$2"; }
}
for move in "w 3 -1" "a 1 -1" "e 2 1"; do
    set -- $move
    check "key $1 flies" flies "$1" "$2"
    check "... the right way" ahead "$3" "$from" "$(place "$2")"
done
on_key r "key R comes back" shows plain.png
xdotool mousemove --window "$window" 130 100 mousedown 1 mousemove --window "$window" 170 85 mouseup 1
check "the mouse looks around" await alters plain.png
await rests
check "... to the right and up" eval 'less 0 "$(place 4)" && less 4 "$(place 5)"'
xdotool windowsize "$window" 400 150
check "another size" await measures 400 150
same() {
    prints_camera && [[ $(camera) = *"--size 400x150" ]] && "$radiosity" render cube.rad -o render.png $(camera) >printed && shot && like shot.png render.png 40
}
check "... is filled; key C prints the camera with which render draws the same" await same
check "ESC ends it with status 0, silently" escapes
check "a plate from behind" begin "$radiosity" view plate.rad --eye 0,0,-2 --at 0,0,0 --size 200x200
await focused
check "... is black" await is_black 200x200+0+0
on_key b "... and with B it is not" eval '! is_black 200x200+0+0'
check "ESC ends it" escapes

# ESC does not wait for form factors. (light_so_far_test tests the light that is shown meanwhile)
"$radiosity" generate columns -o columns.obj >out
check "a model that takes long" begin "$radiosity" view columns.obj --hemicube 1024 --element 1 "${size[@]}"
check "... computes form factors" await titled 'form factors'
check "... ends on ESC without delay, silently" escapes

# --- What is missing ---
check "no display" refuses 1 "no display to open a window on" env -u DISPLAY "$radiosity" view cube.rad
check "an OpenGL that is too old" refuses 1 "no OpenGL 3.3 on this display" env MESA_GL_VERSION_OVERRIDE=2.1 "$radiosity" view cube.rad
check "without GL_ARB_clip_control" env MESA_EXTENSION_OVERRIDE=-GL_ARB_clip_control "$radiosity" view cube.rad "${size[@]}" "${at[@]}" --screenshot view.png >out
check "... the same picture" like view.png plain.png 50
finish
