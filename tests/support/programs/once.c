// With twice.c, a program of two files, with unnamed constants, and two names for one function.
#include <stdio.h>
int twice(int);
int again(int) __attribute__((alias("once")));
int once(int i) { return i * 3 + 1 MORE; }
int main(int words, char **word) { return printf("%d of %s\n", twice(once(words)) + again(2), word[0]) < 0; }
