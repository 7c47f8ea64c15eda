# radiosity export --atlas: the files in the folder, the numbers in glTF, and errors. (atlas_test compares the pages
# with the solution.)
. "$(dirname "$0")/radiosity_program.sh"

"$radiosity" generate columns -o m.obj >/dev/null
check "a model" solved m m.obj --element 4 --rays 16
check "its lightmaps" prints '^114 polygons in 1 page, .* 1 stands for ' "$radiosity" export m.rad --atlas light
check "... with their size printed" grep -qE '^light-0: [0-9]+ x [0-9]+ texels$' printed
check "... with all their files" test "$(cd light && echo *)" = "light-0.hdr light-0.png model.bin model.gltf model.mtl model.obj"
check "radiosity" prints '^radiosity-0: ' "$radiosity" export m.rad --atlas shown --map radiosity
check "several pages" prints 'polygons in [2-9] pages' "$radiosity" export m.rad --atlas pages/ --texels 30 --page 1024 --padding 4
check "... the second is there" test -s pages/light-1.hdr
check "polygons larger than a page are reported" prints 'polygons have fewer texels than asked for' "$radiosity" export m.rad --atlas small --texels 30 --page 256

# (radiosity_gltf.sh reads such a model again, and compares its elements and their light)
cat >gltf.py <<'END'
import json, struct, sys
folder, extension = sys.argv[1:]
g = json.load(open(folder + "/model.gltf"))
data = open(folder + "/model.bin", "rb").read()
def values(number):
    a = g["accessors"][number]
    wide = {"VEC2": 2, "VEC3": 3}[a["type"]]
    flat = struct.unpack_from("<%df" % (a["count"] * wide), data, g["bufferViews"][a["bufferView"]]["byteOffset"])
    return a, [flat[i:i + wide] for i in range(0, len(flat), wide)]
for p in g["meshes"][0]["primitives"]:
    a, places = values(p["attributes"]["POSITION"])
    for pick, bound in (min, a["min"]), (max, a["max"]):
        assert all(abs(pick(x) - y) < 1e-5 for x, y in zip(zip(*places), bound))
    assert all(0 < x < 1 for c in values(p["attributes"]["TEXCOORD_1"])[1] for x in c)
    assert extension in g["materials"][p["material"]]["extensions"] and extension in g["extensionsUsed"]
END
if command -v python3 >/dev/null; then
    check "glTF holds the model, with a lightmap" python3 gltf.py light MOZ_lightmap
    check "... or with its radiosity, unlit" python3 gltf.py shown KHR_materials_unlit
else
    echo "not checked: python3 is not installed"
fi
check "the lamps also emit in its materials" grep -q '^Ke 20 18 15' light/model.mtl
check "... and in glTF" grep -q '"KHR_materials_emissive_strength":{"emissiveStrength":20[.}]' light/model.gltf
check "... but not where the pages already have their light" lacks '^Ke [^0]' shown/model.mtl
check "a folder that is not empty" refuses 2 "light: already exists: name a new or empty folder" "$radiosity" export m.rad --atlas light
# Every page exceeds this limit on the size of files
check "pages that cannot be written" refuses 1 "cannot write" bash -c "trap '' XFSZ; ulimit -f 4; '$radiosity' export m.rad --atlas x"
check "... leaves nothing" test -z "$(find . -maxdepth 1 -name 'x*')"
finish
