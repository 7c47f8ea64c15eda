# Fuzzes a reader of files, with real files as seeds.
#   fuzz.sh BUILD READER replay PROGRAMS   damages the seeds, in the same way in every run; for tests under sanitizers.
#                                          PROGRAMS: a build whose programs make the seeds
#   fuzz.sh BUILD READER SECONDS           runs libFuzzer for SECONDS. Its findings differ from run to run, so each is
#                                          printed: make a test from it
# READER: pack, rad, obj, gltf, hdr, prt or picture
[ ! -w /dev/shm ] || export TMPDIR=/dev/shm # it writes thousands of files
. "$(dirname "$0")/common.sh"
target=${2:-pack} seconds=${3:-30} programs=${4:-$BUILD}
case $seconds in replay) needs_built "tests/replay_$target" ;; *) needs_built "tests/fuzz_$target" ;; esac # clang builds it
[ -x "$programs/pack" ] || { echo "SKIPPED: $programs has no pack: its programs make the seeds"; exit 77; }
mkdir -p "$WORK/seeds"
cd "$WORK" || exit 1

seeds_for_pack() {
    seed() { { printf "\\x0$1"; cat "$2"; } >"seeds/$3"; } # seed READER FILE NAME
    bash "$SOURCE/packer/example/build.sh" "$programs/pack" . >/dev/null || return
    seed 0 hello.elf elf
    seed 1 hello packed
    tail -c +$((528 + $(stat -c %s "$BUILD/generated/stub.bin") + 1)) hello >parameters
    seed 2 parameters parameters
    { printf '\xfa'; cat parameters; } >seeds/decoded # 250: reader 2, and decode
    bash "$SOURCE/packer/example/build.sh" "$programs/pack" . --pe >/dev/null || return
    seed 5 hello_windows.elf windows
    seed 4 hello.exe packed_windows
    tail -c +$((512 + 264 + $(stat -c %s "$BUILD/generated/stub_windows.bin") + 1)) hello.exe >parameters
    { printf '\xfc'; cat parameters; } >seeds/parameters_windows # 252: reader 4, given parts
    "$programs/pack" hello.elf -o again --save-model model >/dev/null || return
    seed 3 model model
    seed 6 hello.elf any
    "$programs/pack" hello.elf -o any --loader >/dev/null || return
    seed 7 any packed_any
    options=(-max_len=8192)
}

seeds_for_obj() {
    local kind
    for kind in cube columns corner; do
        "$programs/radiosity" generate $kind -o $kind.obj >/dev/null || return
        { head -c 6000 $kind.obj | sed 's/^mtllib .*/mtllib m.mtl/'; printf '\xff'; cat $kind.mtl; } >seeds/$kind
    done
    printf 'mtllib m.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0 1 1 1\nv -1 -1 .5e0\nf 1 2/1 3/2/3 -1//4\ng a\ns 1\nf -4 -3 -2\nl 1 2\np 1\xffnewmtl m\nKd .5 1 0\nKe 1 2 3\nd .5\nmap_Kd -o 1 -s 2 2 2 -bm 1 a.png\nillum 2\n' >seeds/all
    printf 'v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r' >seeds/cr
    printf 'v 0 0 0\nv 9 0 0\nv 9 9 0\nv 5 1 0\nv 0 9 0\nv 1 1 0\nv 7 1 0\nf 1// 2/ 3//0 4/1/ 5\nf 6 7 4 3\nF 1 3 2 5\nvt 0 1\n' >seeds/shapes
    printf '\377\376v\0 \0' >seeds/utf16
    # The fuzzer's dictionary: words of OBJ and MTL
    printf '"%s"\n' 'v ' 'f ' 'vn ' 'vt ' 'vp ' 'l ' 'p ' 'g ' 'o ' 's ' 's off' 'usemtl m' 'usemtl l' 'mtllib m.mtl' \
        'mtllib m.obj' 'mtllib ' 'newmtl m' 'newmtl ' 'Kd ' 'Ke ' 'Ka ' 'Ks ' 'Ns ' 'Ni ' 'Tf ' 'Tr ' 'd ' 'illum ' 'map_Kd ' 'map_Ke ' \
        'map_Bump ' 'bump ' 'refl ' '-bm ' '-blendu on' '-boost ' '-clamp on' '-imfchan r' '-mm ' '-o ' '-s ' '-t ' '-texres ' \
        '-type sphere' '-type cube_top' '-colorspace ' 'norm ' 'disp ' 'Pr ' 'Pm ' 'aniso ' // 1// /0 1/1/1 -1 -2 99999999 2147483648 \
        -2147483648 1e18 1e-30 1e38 nan inf '\x0d' '\x0d\x0a' '\x0a' '\x00' '\xff' '\\\x0a' '#' >words
    options=(-max_len=8192 -dict=words)
}

# One file by Blender, and one with everything that the reader supports: a strip, a fan, sparse and normalised
# numbers, a skin, transforms, lights, pictures
seeds_for_gltf() {
    cp "$SOURCE/tests/support/models/blender.glb" seeds || return
    local square material
    square=$(perl -e 'print pack("f12", 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0), pack("C12", 0, 1, 3, 2, 0, 0, 255, 0, 0, 255, 255, 255), pack("f16", 2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1), "P6 1 1 255 abc"' | base64 -w 0)
    material='{"asset":{"version":"2.0"},"extensionsUsed":["KHR_lights_punctual","a"],"scene":0,"scenes":[{"nodes":[0,1]},{}],"nodes":[{"mesh":0,"skin":0,"children":[2,3]},{"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,1,2,3,1]},{"rotation":[0,0,0.6,0.8],"scale":[1,-1,1],"translation":[1,1,1],"extensions":{"KHR_lights_punctual":{"light":0}}},{"extensions":{"KHR_lights_punctual":{"light":1}}}],"skins":[{"joints":[2],"inverseBindMatrices":3}],"extensions":{"KHR_lights_punctual":{"lights":[{"type":"spot","spot":{},"intensity":3,"color":[1,1,0]},{"type":"directional"}]}},"materials":[{"name":"m","doubleSided":true,"alphaMode":"MASK","pbrMetallicRoughness":{"baseColorFactor":[1,0.5,1,1],"baseColorTexture":{"index":0,"texCoord":1,"extensions":{"KHR_texture_transform":{"offset":[0,1],"rotation":1,"scale":[2,2],"texCoord":0}}}},"emissiveFactor":[1,1,1],"emissiveTexture":{"index":1},"extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":5}}},{"name":"m","extensions":{"KHR_materials_unlit":{},"KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[1,0,1,1],"diffuseTexture":{"index":0}}}}],"textures":[{"source":0,"sampler":0},{"source":1}],"samplers":[{"wrapS":33071,"wrapT":33648}],"images":[{"bufferView":4},{"uri":"data:image/png;base64,iVBORw0KGgo="}],'
    echo "$material"'"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":2,"COLOR_0":2},"indices":1,"mode":5,"material":0,"targets":[{}]},{"attributes":{"POSITION":4},"mode":6,"material":1},{"attributes":{"POSITION":0},"mode":1}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},{"bufferView":1,"componentType":5121,"count":4,"type":"SCALAR"},{"bufferView":2,"componentType":5121,"normalized":true,"count":4,"type":"VEC2"},{"bufferView":3,"componentType":5126,"count":1,"type":"MAT4"},{"componentType":5126,"count":5,"type":"VEC3","sparse":{"count":4,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":0}}}],"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":4},{"buffer":0,"byteOffset":52,"byteLength":8},{"buffer":0,"byteOffset":60,"byteLength":64},{"buffer":0,"byteOffset":124,"byteLength":14}],"buffers":[{"byteLength":138,"uri":"data:;base64,'"$square"'"}]}' >seeds/all
    echo '{"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5121,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":9}],"buffers":[{"byteLength":9,"uri":"data:;base64,AAAAAQAAAAEA"}]}' >seeds/small
    # The fuzzer's dictionary: words of glTF
    grep -ohE '"[A-Za-z_0-9]+"' seeds/all | sort -u | sed 's/"//g; s/.*/"\\"&\\""/' >words
    printf '"%s"\n' ':{' ':[' '},{' '5120' '5121' '5122' '5123' '5125' '5126' '4294967295' '18446744073709551615' '-1' 1e308 null true >>words
    options=(-max_len=20000 -dict=words)
}

small_model() { # a square, and a lamp above it
    printf 'newmtl m\nKd 0.5 0.5 0.5\nnewmtl l\nKe 5 5 5\n' >m.mtl
    printf 'mtllib m.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0 1 0\nv 1 1 0\nv 1 1 1\nf 1 4 3 2\nusemtl l\nf 5 6 7\n' >m.obj
}

# The smallest solutions, without their header of 18 bytes and their checksum of 8
seeds_for_rad() {
    local option
    small_model
    for option in "--patch 1 --element 1" "--patch 0.5 --element 0.2" "--patch 1 --element 0.01"; do
        "$programs/radiosity" solve m.obj -o m.rad $option >/dev/null || return
        tail -c +27 m.rad >"seeds/${option//[^0-9a-z]/}"
    done
    # An earlier finding: the floor's blue, the fourth number from the end, is negative
    perl -0777 -pe 'substr($_, -24, 12) = pack("f3", 1, 1, -5)' seeds/patch1element1 >seeds/negative
    options=(-max_len=16384)
}

# The smallest rooms, without their header of 17 bytes and their checksum of 8
seeds_for_prt() {
    local option
    small_model
    for option in "--bands 1 --rank 1" "--bands 2 --rank 2 --clusters 2" "--bands 1 --rank 1 --glossy m" "--bands 2 --rank 1 --up z"; do
        "$programs/radiosity" transfer m.obj -o m.prt --rays 8 --element 1 $option >/dev/null 2>&1 || return
        tail -c +26 m.prt >"seeds/${option//[^0-9a-z]/}"
    done
    options=(-max_len=65536)
}

# Rows, plain and run-length coded; an even sky and one with a sun; almost valid files
seeds_for_hdr() {
    head() { printf "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y $2 +X $1\n"; }
    { head 4 2; printf '\200\200\200\201%.0s' $(seq 8); } >seeds/plain
    { head 4 2; printf '\200\200\200\201%.0s' $(seq 7); printf '\377\377\200\220'; } >seeds/sun
    { head 8 4; for _ in 1 2 3 4; do printf '\2\2\0\10\210\200\210\200\4\1\2\3\4\204\5\210\201'; done; } >seeds/runs
    { head 8 1; printf '\2\2\0\10\210\200\211\200'; } >seeds/long
    { head 300 1; printf '\200\200\200\201\1\1\1\53\1\1\1\1'; } >seeds/older
    { printf '#?RADIANCE\nEXPOSURE=2\nCOLORCORR=1 2 1\nFORMAT=32-bit_rle_xyze\n\n+X 2 +Y 1\n'; printf '\200\200\200\201%.0s' 1 2; } >seeds/xyz
    { head 1 1; printf '\377\377\377\377'; } >seeds/bright
    { head 1000000 100; printf '\2\1\1\1'; } >seeds/vast
    options=(-max_len=4096)
}

# OpenEXR by independent writers, PNM of all kinds, and the smallest files of the formats that stb reads
seeds_for_picture() {
    cp "$SOURCE"/tests/support/pictures/*.{exr,png,jpg} seeds || return
    printf 'P6\n# c\n2 2\n65535\n%.24dP5 2 1 15\n\1\2' 7 >seeds/raw
    printf 'P3 2 1 255 1 2 3 255 0 4\nP2#\n1 1 1 1 ' >seeds/text
    printf '#?RADIANCE\r\nEXPOSURE=0\r\nFORMAT=32-bit_rle_rgbe\r\n\r\n+X 2 +Y 1\r\n\200\200\200\201\1\1\1\1' >seeds/hdr
    printf '\0\0\2\0\0\0\0\0\0\0\0\0\2\0\1\0\40\40abcdABCD' >seeds/tga
    printf '\0\1\11\0\0\2\0\30\0\0\0\0\4\0\2\0\10\0abcdef\203\0\3\1\0\0\1' >seeds/tga_runs
    printf 'BM:\0\0\0\0\0\0\0\66\0\0\0\50\0\0\0\1\0\0\0\1\0\0\0\1\0\30\0%.24dabcd' 0 | tr 0 '\0' >seeds/bmp
    # Earlier findings: a JPEG after a byte of 255, a table of more than 256 codes, a BMP without width
    { printf '\377'; cat seeds/small.jpg; } >seeds/filled
    perl -0777 -pe 's/\xff\xc4...\K.{16}/"\xff" x 16/se' seeds/small.jpg >seeds/codes
    perl -0777 -pe 'substr($_, 18, 1) = "\0"' seeds/bmp >seeds/narrow
    options=(-max_len=16384)
}

check "seeds for each reader" "seeds_for_$target"
check "... are there" test "$(find seeds -type f -size +0 | wc -l)" -ge 3
replay() {
    "$BUILD/tests/replay_$target" seeds/* >log 2>&1 && grep 'inputs' log && return
    tail -n 40 log
    [ ! -e input ] || { echo "the input, by base64 -d:" && base64 -w 0 input && echo; }
    return 1
}
if [ "$seconds" = replay ]; then
    check "the reader survives the seeds, whole and damaged" replay
    finish
fi

fuzz() {
    # -timeout ends only inputs that hang: it is long enough for a busy machine
    if "$BUILD/tests/fuzz_$target" -max_total_time="$seconds" -timeout=200 -rss_limit_mb=3000 -verbosity=0 -print_final_stats=1 "${options[@]}" seeds >log 2>&1; then
        grep -E 'executed_units|new_units' log
    else
        tail -n 40 log
        for finding in crash-* timeout-* oom-* leak-*; do
            [ -e "$finding" ] && echo "$finding, by base64 -d:" && base64 -w 0 "$finding" && echo
        done
        return 1
    fi
}
check "the readers survive $seconds s of the fuzzer" fuzz
check "... which tried more than 100 inputs" test "$(sed -n 's/^stat::number_of_executed_units: //p' log)" -gt 100
finish
