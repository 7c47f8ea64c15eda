# pack-link --way static: a program with all of libc in it. Apart from the other ways, because it takes as long as they do.
. "$(dirname "$0")/linking.sh"

cat >small.c <<'END'
#include <stdio.h>
int main(int count, char **words) { return printf("%d %s\n", count, words[1]); }
END
static=gcc
command -v musl-gcc >/dev/null && static=musl-gcc # a hundredth of the size
$static -Os -c small.c
check "static, where it is asked for" takes static small.o --way static --cc $static
check "... the same" same "$static -static" small.o
finish
