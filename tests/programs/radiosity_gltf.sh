# radiosity reads glTF: a file by Blender, lights whose irradiance has a closed form, and its own lightmaps.
. "$(dirname "$0")/radiosity_program.sh"
skip_unless perl
# near A B WITHIN: succeeds if A and B differ by less than that share
near() { awk -v a="$1" -v b="$2" -v within="$3" 'BEGIN { exit !((a / b - 1) ^ 2 < within ^ 2) }'; }

check "a room from Blender's exporter" solved blender "$SOURCE/tests/support/models/blender.glb" --element 4 --rays 16
check "... with a note of its lamps" grep -q ': 2 point or spot lights become balls, up to 0.0139 across; 1 spot shines in all directions$' blender.err
check "... has the right area, and all of it faces the middle" eval 'awk -F, "NR > 1 { area += \$8; away += (10 - \$2) * \$5 + (9 - \$3) * \$6 + (-20 - \$4) * \$7 <= 0 } END { exit !(area > 323.99 && area < 324.01 && !away) }" blender.csv'

# A small floor reflects half of the light. A light of 100 candela at a height of 1 gives it a radiance of
# .5 * 100 / pi; a sun of pi lux gives it .5
floor='{"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":5,"material":0}]}],"materials":[{"name":"floor","pbrMetallicRoughness":{"baseColorFactor":[0.5,0.5,0.5,1],"metallicFactor":0}}],
"accessors":[{"bufferView":0,"componentType":5120,"count":4,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":16,"byteStride":4}],"buffers":[{"byteLength":16,"uri":"data:application/octet-stream;base64,'$(printf '\377\0\1\0\1\0\1\0\377\0\377\0\1\0\377\0' | base64 -w 0)'"}],
"extensionsUsed":["KHR_lights_punctual"],"extensions":{"KHR_lights_punctual":{"lights":[LIGHT]}},
"nodes":[{"mesh":0,"scale":[0.05,0.05,0.05]},{"translation":[0,1,0],"rotation":[-0.70710678,0,0,0.70710678],"extensions":{"KHR_lights_punctual":{"light":0}}}]}'
point='{"type":"point","intensity":100}' sun='{"type":"directional","intensity":3.14159265}'
echo "${floor/LIGHT/$point}" >point.gltf
echo "${floor/LIGHT/$sun}" >sun.gltf
radiance() { awk -F, 'NR > 1 { sum += $9 * $8; area += $8 } END { print sum / area }' "$1.csv"; }
check "a point of 100 candela" solved point point.gltf --element .0001
check "... gives E = I / d^2" near "$(radiance point)" 15.9155 .003
check "a sun of pi lux, between patches" eval 'solved sun sun.gltf --element .0001 --patch .001 && near "$(radiance sun)" .5 1e-3'
check "... is replaced by --sun" eval 'solved sun sun.gltf --element .0001 --sun 90,0,4,4,4 && near "$(radiance sun)" 2 1e-4 && grep -qx "radiosity: --sun replaces the model.s own suns" sun.err'
check "transfer" prints '; lamps 1 sun 1$' "$radiosity" transfer sun.gltf -o sun.prt --rays 32 --element .0005 --bands 2

# export --atlas writes the same model with its picture: its elements have the same positions, in any order, and the
# same light
perl -e 'print "P6 8 8 255\n", map { chr(40 + 25 * ($_ % 8)) . chr(200) . chr(20 * ($_ >> 3)) } 0 .. 63' >tiles.ppm
printf 'newmtl floor\nKd .8 .8 1\nmap_Kd tiles.ppm\nnewmtl lamp\nKe 3 2 1\n' >room.mtl
printf 'mtllib room.mtl\nv -2 0 2\nv 2 0 2\nv 2 0 -2\nv -2 0 -2\nv -1 2 1\nv -1 2 -1\nv 1 2 -1\nv 1 2 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl floor\nf 1/1 2/2 3/3 4/4\nusemtl lamp\nf 5 6 7 8\n' >room.obj
alike() {
    awk -F, 'FNR > 1 { place = ""; for (k = 2; k <= 8; ++k) place = place sprintf(" %.2f", $k + .00123) }
        FNR > 1 && NR == FNR { for (k = 9; k <= 11; ++k) light[place, k] = $k; ++n; next }
        FNR > 1 { --n; for (k = 9; k <= 11; ++k) { if (!((place, k) in light)) ++missing
            a += light[place, k] * $8; b += $k * $8; d += sqrt(($k - light[place, k]) ^ 2) * $8 } }
        END { print "    light", b / a - 1, "elements", d / a; exit !(FNR > 20 && !n && !missing && (b / a - 1) ^ 2 < .005 ^ 2 && d / a < .03) }' "$1" "$2"
}
check "a floor with a picture" solved room room.obj --element .1 --rays 64
check "... and its lightmaps" eval '"$radiosity" export room.rad --atlas pictured >/dev/null && test -s pictured/reflectance-0.png && solved pictured pictured/model.gltf --element .1 --rays 64'
check "... are the same light" alike room.csv pictured.csv
finish
