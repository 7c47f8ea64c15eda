# Packed programs under the distribution's kernel, in a machine of qemu with 5-level paging.
. "$(dirname "$0")/../common.sh"
skip_unless gcc qemu-system-x86_64 busybox apt-get dpkg
pack=$BUILD/pack
cd "$WORK" || exit 1
kernel=$(apt-cache depends linux-image-cloud-amd64 2>/dev/null | sed -n 's/.*Depends: //p' | head -n 1)
apt-get download "$kernel" >/dev/null 2>&1 && dpkg -x linux-image*.deb kernel || { echo "SKIPPED: cannot download a kernel"; exit 77; }

cat >c.c <<'END_OF_C'
#include <stdio.h>
#include <stdlib.h>
static __thread int local = 40;
static char zeros[100000];
int main(int count, char **words) {
    char *block = malloc(1 << 20);
    for (int i = 0; i < 1 << 20; ++i) block[i] = 1;
    printf("%s %d %d\n", words[count - 1], local += count, zeros[99999]);
    return 5;
}
END_OF_C
mkdir -p root/{bin,proc,lib64,lib/x86_64-linux-gnu}
cp /bin/busybox root/bin/
cp -L /lib64/ld-linux-x86-64.so.2 root/lib64/
cp -L /lib/x86_64-linux-gnu/{libc.so.6,libdl.so.2} root/lib/x86_64-linux-gnu/
packs() { # packs OPTION...: links a program with these options, and packs it for the machine
    gcc -O1 -s c.c "$@" -o program && "$pack" program -o "root/bin/packed$1" --loader --fast >/dev/null
}
for options in "" -no-pie -static -static-pie; do check "packs a program linked by gcc $options" packs $options; done
bash "$SOURCE/packer/example/build.sh" "$pack" . >/dev/null && cp hello root/bin/hello
cat >root/init <<'END_OF_INIT'
#!/bin/busybox sh
/bin/busybox mount -t proc proc /proc
echo "kernel $(/bin/busybox uname -r), $(/bin/busybox grep -o -m 1 la57 /proc/cpuinfo)"
for program in /bin/packed*; do $program a word; echo "$program: status $?"; done
/bin/hello
echo "/bin/hello: status $?"
/bin/busybox poweroff -f
END_OF_INIT
chmod +x root/init
(cd root && find . | busybox cpio -o -H newc) 2>/dev/null | gzip -1 >initrd
# The emulated processor needs about a minute
timeout $((PATIENCE * 2)) qemu-system-x86_64 -M q35 -cpu max,la57=on -m 512 -nographic -no-reboot -kernel kernel/boot/vmlinuz-* -initrd initrd \
    -append "console=ttyS0 quiet panic=-1" 2>&1 </dev/null | tr -d '\r' >log
check "the kernel has 5-level paging" grep -q '^.*kernel .*, la57$' log
sed -n 's/.*kernel /kernel /p' log
check "all four packed programs run" test "$(grep -c '^/bin/packed.*: status 5$' log)" = 4 -a "$(grep -c '^word 43 0$' log)" = 4
check "so does a program made for packing" grep -q '^/bin/hello: status 7$' log
finish
