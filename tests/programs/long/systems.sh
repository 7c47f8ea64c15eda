# The film on other systems, with their glibc and their Mesa: pictures, the hall's light and the music are equal to the
# bit. debootstrap installs each system, and chroot enters it, so this needs root and a Debian mirror.
# On 2026-11-25 all was equal with Debian 11 (glibc 2.31, Mesa 20.3) and sid (glibc 2.43, Mesa 26.2).
#   systems.sh BUILD [SYSTEM...]      SYSTEM: debian11, debian13 or sid (default: the oldest and the newest)
. "$(dirname "$0")/../common.sh"
shift
skip_unless debootstrap unshare
needs_built compare
[ "$(id -u)" = 0 ] || { echo "SKIPPED: it needs root"; exit 77; }
# Run in a new mount namespace, so that the mounts disappear with this process, however it ends
[ -n "${ODRAZ_OWN_MOUNTS-}" ] || ODRAZ_OWN_MOUNTS=1 exec unshare --mount --propagation private bash "$0" "$BUILD" "$@"
declare -A SUITES=([debian11]=bullseye [debian13]=trixie [sid]=sid)
[ $# -gt 0 ] || set -- debian11 sid
LEAST=45 # dB of PSNR that the hall must reach where Mesa differs
mirror=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' 'Origin: Debian' 'Label: Debian' 2>/dev/null | head -n 1)
[ -n "$mirror" ] || { echo "SKIPPED: apt lists no mirror of Debian"; exit 77; }

declare -A PARTS=(
    [frames]="--dump - --from 20 --to 60 --fps 1/4 --size 320x180"
    [hall]="--dump - --from 120 --to 120.04 --size 160x90"
    [music]="--wav -")
# draws TO PART COMMAND...: runs the film by the command, and writes that part to TO.PART
draws() {
    "${@:3}" ${PARTS[$2]} >"$WORK/$1.$2" </dev/null
}
same() { # same A B PART: succeeds if both drew the same, or almost the same hall
    cmp "$WORK/$1.$3" "$WORK/$2.$3" && return
    [ "$3" = hall ] && "$BUILD/compare" "$WORK/$1.$3" "$WORK/$2.$3" --psnr $LEAST
}
for part in "${!PARTS[@]}"; do check "here: $part" draws here "$part" env -u DISPLAY "$BUILD/odraz-safe"; done
for system; do
    root=$WORK/$system
    # (all packages are in main)
    debootstrap --variant=minbase --include=libegl1,libgl1-mesa-dri "${SUITES[$system]}" "$root" "$mirror" >"$WORK/log" 2>&1 ||
        { echo "not checked: $system: $(grep -E '^E: ' "$WORK/log" | tail -n 1)"; continue; }
    mount -t proc proc "$root/proc"
    echo "$system: glibc and Mesa $(chroot "$root" dpkg-query -W -f '${Version} ' libc6 libgl1-mesa-dri)"
    for program in odraz odraz-safe; do
        cp "$BUILD/$program" "$root/$program"
        for part in "${!PARTS[@]}"; do
            check "$system, $program: $part" \
                draws "$system" "$part" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin chroot "$root" "/$program"
            check "... is the same" same here "$system" "$part"
        done
    done
    umount -R "$root/proc"
    rm -rf --one-file-system "$root"
done
finish
