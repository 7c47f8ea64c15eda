// Functions that the compiler calls, because this target has no library.
#include <stddef.h>
#include <stdint.h>

extern "C" {

// Each of these is a single instruction of WebAssembly
void *memcpy(void *__restrict to, const void *__restrict from, size_t n) {
    return __builtin_memcpy(to, from, n);
}
void *memmove(void *to, const void *from, size_t n) { return __builtin_memmove(to, from, n); }
void *memset(void *to, int value, size_t n) { return __builtin_memset(to, value, n); }

// 128-bit shifts, which are used for sets of lights
__int128 __ashlti3(__int128 x, int by) {
    uint64_t low = (uint64_t)x, high = (uint64_t)((unsigned __int128)x >> 64);
    if (by >= 64)
        high = low << (by - 64), low = 0;
    else if (by)
        high = high << by | low >> (64 - by), low <<= by;
    return (__int128)((unsigned __int128)high << 64 | low);
}
__int128 __lshrti3(__int128 x, int by) {
    uint64_t low = (uint64_t)x, high = (uint64_t)((unsigned __int128)x >> 64);
    if (by >= 64)
        low = high >> (by - 64), high = 0;
    else if (by)
        low = low >> by | high << (64 - by), high >>= by;
    return (__int128)((unsigned __int128)high << 64 | low);
}
}
