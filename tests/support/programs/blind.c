// Reads memory that nobody wrote: valgrind must report it.
#include <stdlib.h>

int main(void) {
    int *p = malloc(4);
    return *p ? 0 : 1;
}
