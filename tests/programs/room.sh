# Sourced by tests of rooms that are relit, after common.sh.

# like A B DB: succeeds if the PSNR of two pictures is above DB
like() { less "$3" "$("$BUILD/compare" "$1" "$2" | sed -E 's/psnr (inf|[0-9.]+).*/\1/; s/inf/999/')"; }

# open_room NAME: writes NAME.obj and NAME.mtl, a room without its front wall, with one lamp below its ceiling and
# another on its left wall
open_room() {
    cat >"$1.mtl" <<'END'
newmtl grey
Kd 0.7 0.7 0.7
newmtl red
Kd 0.8 0.2 0.1
newmtl lamp
Kd 0 0 0
Ke 9 8 6
newmtl spot
Kd 0 0 0
Ke 0 4 9
END
    echo "mtllib $1.mtl" >"$1.obj"
    cat >>"$1.obj" <<'END'
v -2 0 2
v 2 0 2
v 2 0 -2
v -2 0 -2
v -2 3 2
v 2 3 2
v 2 3 -2
v -2 3 -2
v -0.5 2.9 -0.5
v 0.5 2.9 -0.5
v 0.5 2.9 0.5
v -0.5 2.9 0.5
v -1.9 1 -0.3
v -1.9 1.5 -0.3
v -1.9 1.5 0.3
v -1.9 1 0.3
usemtl grey
f 1 2 3 4
f 5 8 7 6
f 4 3 7 8
usemtl red
f 1 4 8 5
usemtl grey
f 2 6 7 3
usemtl lamp
f 9 10 11 12
usemtl spot
f 13 14 15 16
END
}
