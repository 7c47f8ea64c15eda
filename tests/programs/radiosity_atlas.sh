# radiosity export --atlas: what lies in the folder, glTF's numbers, and what cannot be written. (atlas_test compares the
# pages with the solution.)
. "$(dirname "$0")/radiosity_program.sh"

"$radiosity" generate columns -o m.obj >/dev/null
check "a model" solved m m.obj --element 4 --rays 16
check "its lightmaps" prints '^114 polygons in 1 page, .* 1 stands for ' "$radiosity" export m.rad --atlas light
check "... with their size printed" grep -qE '^light-0: [0-9]+ x [0-9]+ texels$' printed
check "... with all that belongs to them" test "$(cd light && echo *)" = "light-0.hdr light-0.png model.bin model.gltf model.mtl model.obj"
check "radiosity" prints '^radiosity-0: ' "$radiosity" export m.rad --atlas shown --map radiosity
check "several pages" prints 'polygons in [2-9] pages' "$radiosity" export m.rad --atlas pages/ --texels 30 --page 1024 --padding 4
check "... as many as it prints" test -s pages/light-1.hdr
check "polygons larger than a page are reported" prints 'polygons have fewer texels than asked for' "$radiosity" export m.rad --atlas small --texels 30 --page 256

# Every file that glTF names is there, and every number is within its bounds
cat >gltf.py <<'END'
import json, os, struct, sys
folder, textures, extension = sys.argv[1], int(sys.argv[2]), sys.argv[3]
g = json.load(open(folder + "/model.gltf"))
data = open(folder + "/model.bin", "rb").read()
assert g["asset"]["version"] == "2.0" and len(data) == g["buffers"][0]["byteLength"] and g["buffers"][0]["uri"] == "model.bin"
assert len(g["textures"]) == len(g["images"]) == textures and all(os.path.getsize(folder + "/" + i["uri"]) for i in g["images"])
def values(number):
    a = g["accessors"][number]
    view, wide = g["bufferViews"][a["bufferView"]], {"SCALAR": 1, "VEC2": 2, "VEC3": 3}[a["type"]]
    kind = {5126: "f", 5125: "I"}[a["componentType"]]
    assert view["byteOffset"] % 4 == 0 and view["byteLength"] == a["count"] * wide * 4
    flat = struct.unpack_from("<%d%s" % (a["count"] * wide, kind), data, view["byteOffset"])
    return [flat[i:i + wide] for i in range(0, len(flat), wide)], a
area = 0
for p in g["meshes"][0]["primitives"]:
    (places, a), (normals, _), (at, _) = (values(p["attributes"][k]) for k in ("POSITION", "NORMAL", "TEXCOORD_1"))
    corners = values(p["indices"])[0]
    assert len(places) == len(normals) == len(at) and all(0 <= c[0] < len(places) for c in corners) and len(corners) % 3 == 0
    for pick, bound in (min, a["min"]), (max, a["max"]):
        assert all(abs(pick(x) - y) < 1e-5 for x, y in zip(zip(*places), bound))
    assert all(0 < x < 1 for c in at for x in c)
    for i in range(0, len(corners), 3):
        b, c, d = (places[corners[i + k][0]] for k in range(3))
        u, v = [c[k] - b[k] for k in range(3)], [d[k] - b[k] for k in range(3)]
        n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        size = sum(x * x for x in n) ** .5
        assert sum(x * y for x, y in zip(n, normals[corners[i][0]])) > .999 * size
        area += size / 2
    m = g["materials"][p["material"]]
    assert extension in m["extensions"] and extension in g["extensionsUsed"]
assert 4745.5 < area < 4745.7, area
END
if command -v python3 >/dev/null; then
    check "glTF holds the model, with a lightmap" python3 gltf.py light 1 MOZ_lightmap
    check "... or as it is seen" python3 gltf.py shown 1 KHR_materials_unlit
else
    echo "not checked: python3 is not installed"
fi
check "the lamps shine on in its materials" grep -q '^Ke 20 18 15' light/model.mtl
check "... and in glTF" grep -q '"KHR_materials_emissive_strength":{"emissiveStrength":20[.}]' light/model.gltf
check "... but not twice where the pages have them" lacks '^Ke [^0]' shown/model.mtl
check "a folder that holds something" refuses 2 "light: exists already: name a folder that is new or empty" "$radiosity" export m.rad --atlas light
# A limit on the size of files that every page exceeds
check "what cannot be written" refuses 1 "cannot write" bash -c "trap '' XFSZ; ulimit -f 4; '$radiosity' export m.rad --atlas x"
check "... leaves nothing" test -z "$(find . -maxdepth 1 -name 'x*')"
finish
