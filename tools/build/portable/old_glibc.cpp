// Linked to a program so that it runs with any glibc since 2.31 (Debian 11, Ubuntu 22.04). A program linked
// with a newer glibc would otherwise require the newest version of each function, which older systems lack.
//
// ld --wrap (portable.cmake) redirects all calls of the functions below to __wrap_NAME. These call the oldest
// version, which every glibc has, or do the work themselves.
#include <cstddef>
#include <cstdint>
#include <link.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

// OLD(RESULT, NAME, (PARAMETERS), (ARGUMENTS)): forwards NAME to its oldest version.
#define OLD(result, name, parameters, arguments)                                                             \
    extern "C" result old_##name parameters;                                                                 \
    __asm__(".symver old_" #name ", " #name "@GLIBC_2.2.5");                                                 \
    extern "C" result __wrap_##name parameters { return old_##name arguments; }

OLD(double, hypot, (double x, double y), (x, y))
OLD(void *, dlopen, (const char *name, int mode), (name, mode))
OLD(void *, dlsym, (void *library, const char *name), (library, name))
OLD(int, pthread_create, (pthread_t * id, const pthread_attr_t *how, void *(*run)(void *), void *with),
    (id, how, run, with))
OLD(int, pthread_detach, (pthread_t id), (id))
OLD(int, pthread_join, (pthread_t id, void **result), (id, result))
OLD(int, pthread_once, (pthread_once_t * once, void (*run)()), (once, run))
OLD(int, pthread_key_create, (pthread_key_t * key, void (*end)(void *)), (key, end))
OLD(int, __pthread_key_create, (pthread_key_t * key, void (*end)(void *)), (key, end))
OLD(int, pthread_key_delete, (pthread_key_t key), (key))
OLD(int, pthread_rwlock_rdlock, (pthread_rwlock_t * lock), (lock))
OLD(int, pthread_rwlock_wrlock, (pthread_rwlock_t * lock), (lock))
OLD(int, pthread_rwlock_unlock, (pthread_rwlock_t * lock), (lock))
OLD(void *, pthread_getspecific, (pthread_key_t key), (key))
OLD(int, pthread_setspecific, (pthread_key_t key, const void *value), (key, value))

// Before 2.33 these were inline functions, which called the functions below.
extern "C" {
int __xstat(int version, const char *path, struct stat *to);
int __lxstat(int version, const char *path, struct stat *to);
int __fxstat(int version, int file, struct stat *to);
}
constexpr int kStatVersion = 1; // x86-64's struct stat
extern "C" int __wrap_stat(const char *path, struct stat *to) { return __xstat(kStatVersion, path, to); }
extern "C" int __wrap_lstat(const char *path, struct stat *to) { return __lxstat(kStatVersion, path, to); }
extern "C" int __wrap_fstat(int file, struct stat *to) { return __fxstat(kStatVersion, file, to); }
extern "C" int __wrap_fstat64(int file, struct stat *to) { return __fxstat(kStatVersion, file, to); }

// Since 2.32 this variable is 1 while there is only one thread, so that locks can be skipped. If it stays
// 0, none is skipped, which is always safe.
extern "C" {
char __wrap___libc_single_threaded = 0;
}

// Before 2.36 there was no arc4random.
extern "C" uint32_t __wrap_arc4random() {
    uint32_t random = 0;
    if (getentropy(&random, sizeof random)) _exit(127);
    return random;
}

// Before 2.35 there was no _dl_find_object, by which libgcc finds the unwind table of the object that
// contains `pc`.
namespace {
struct Search {
    uintptr_t pc;
    void *table;
};
int findTable(dl_phdr_info *object, size_t, void *context) {
    Search &s = *(Search *)context;
    bool here = false;
    void *table = nullptr;
    for (int i = 0; i < object->dlpi_phnum; ++i) {
        const ElfW(Phdr) &part = object->dlpi_phdr[i];
        uintptr_t begin = object->dlpi_addr + part.p_vaddr;
        if (part.p_type == PT_LOAD && s.pc >= begin && s.pc < begin + part.p_memsz) here = true;
        if (part.p_type == PT_GNU_EH_FRAME) table = (void *)begin;
    }
    if (here) s.table = table;
    return here;
}
} // namespace
// libgcc reads only the table from `to`.
extern "C" int __wrap__dl_find_object(void *pc, dl_find_object *to) {
    Search s = {(uintptr_t)pc, nullptr};
    dl_iterate_phdr(findTable, &s);
    to->dlfo_eh_frame = s.table;
    return s.table ? 0 : -1;
}

// Since 2.34 __libc_start_main calls the program's constructors itself. Before, it called a function that
// crt1.o passed.
extern "C" {
using Entry = void (*)(int, char **, char **);
extern Entry __preinit_array_start[], __preinit_array_end[], __init_array_start[], __init_array_end[];
void _init();
int old_start(int (*run)(int, char **, char **), int argc, char **argv, void (*begin)(int, char **, char **),
              void (*end)(), void (*endLibraries)(), void *stackEnd);
__asm__(".symver old_start, __libc_start_main@GLIBC_2.2.5");

static void construct(int argc, char **argv, char **environment) {
    for (Entry *f = __preinit_array_start; f != __preinit_array_end; ++f) (*f)(argc, argv, environment);
    _init();
    for (Entry *f = __init_array_start; f != __init_array_end; ++f) (*f)(argc, argv, environment);
}

int __wrap___libc_start_main(int (*run)(int, char **, char **), int argc, char **argv,
                             void (*)(int, char **, char **), void (*end)(), void (*endLibraries)(),
                             void *stackEnd) {
    return old_start(run, argc, argv, construct, end, endLibraries, stackEnd);
}
}
