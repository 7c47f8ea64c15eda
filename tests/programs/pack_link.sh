# pack-link with programs of many kinds: they must behave as when cc links them.
# With "all" as the second argument one has all of glibc in it.
. "$(dirname "$0")/common.sh"
skip_unless gcc
needs_built pack-link
link=$BUILD/pack-link
cd "$WORK" || exit 1

# A model that packs in a third of the time; few=() leaves the choice to pack-link
"$BUILD/pack" "$(type -P true)" -o true.packed --fast --save-model few.model >/dev/null
sed -i 's/^slots .*/slots 14/' few.model
few=(--model few.model)

did() { # did COMMAND...: what it prints, on each output, and its exit status
    timeout "$PATIENCE" "$@" >did.out 2>did.err
    echo "status $?" >>did.err
    cat did.out did.err
} 2>/dev/null # where the shell reports signals
# takes WAY WORD...: pack-link links them to packed/run, in that way, and prints nothing on stderr
takes() {
    local way=$1
    shift
    mkdir -p packed
    "$link" "$@" "${few[@]}" -o packed/run >printed.txt 2>err && [ ! -s err ] && grep -q "^$way .*<- taken" printed.txt && return 0
    cat printed.txt err >&2
    return 1
}
# same COMPILER WORD...: packed/run does what the program does that COMPILER links of the words
same() {
    local compiler=$1
    shift
    mkdir -p plain
    $compiler "$@" -o plain/run || return 1
    (cd plain && did ./run a 'b c') >wanted
    (cd packed && did ./run a 'b c') >got
    cmp wanted got && [ "$(wc -l <got)" -gt 1 ]
}
# ways WORD...: the program is the same by each way that is possible
ways() {
    local way
    for way in dynamic imports; do takes $way --way $way "$@" && same "gcc -no-pie" "$@" || return 1; done
}

# All that start-up code handles: arguments, environment, constructors in their order, atexit and destructors in
# theirs, data of libc, return from main() with text still in stdout's buffer, pointers to library functions
cat >c.c <<'END'
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
static int made;
static const int some[2] __attribute__((section("parts"), used)) = {20, 3}; // which others may add to
extern const int __start_parts[], __stop_parts[];
void absent(void) __attribute__((weak)); // which no object has
static void *(*const allocate)(size_t) = malloc;
__attribute__((constructor(201))) static void second(void) { made = made * 10 + 2; }
__attribute__((constructor(101))) static void first(int count, char **words, char **environment) {
    made = made * 10 + 1;
    fprintf(stderr, "first: %d %s %d\n", count, words[1], environment[0] != 0);
}
__attribute__((constructor)) static void third(void) { made = made * 10 + 3; }
__attribute__((destructor(101))) static void last(void) { puts("last"); }
__attribute__((destructor(201))) static void beforeLast(void) { puts("before last"); }
static void leaves(void) { puts("leaves"); }
static int compare(const void *a, const void *b) { return *(const int *)a - *(const int *)b; }
int main(int count, char **words, char **environment) {
    int numbers[] = {3, 1, 2}, handlers = atexit(leaves);
    qsort(numbers, 3, sizeof numbers[0], compare);
    char *text = allocate(100);
    strcpy(text, words[count - 1]);
    if (absent) absent();
    errno = 0;
    int wrong = close(-1);
    printf("%d %d%d%d %s %s %d %d %d %s %d\n", made, numbers[0], numbers[1], numbers[2], text, getenv("SAID"), wrong, errno == EBADF,
           handlers, strerror(EBADF), environment[0] != 0);
    fprintf(stderr, "to stderr: %d\n", __start_parts[0] + __stop_parts[-1]);
    fputs("left in the buffer", stdout);
    return 7;
}
END
export SAID=words
for options in "-O2 -fno-pic -fcf-protection=none" "-O0 -g -fPIC" "-Os -fno-plt -ffunction-sections"; do
    gcc $options -c c.c -o c.o
    check "C with $options: by dynamic and by imports" ways c.o
done
few=()
check "C with the contexts that pack-link chooses: imports are smaller" eval 'takes imports c.o && same "gcc -no-pie" c.o'
check "... and all ways are printed" prints '^dynamic .* hash table of sysv$' cat printed.txt
check "... static, too, which is too large" prints '^static .* far too large$' cat printed.txt
check "... and what each object costs" prints '^c.o +[0-9]+ +[0-9]+$' cat printed.txt
few=(--model few.model)

# Libraries: maths, threads, one's own
cat >libraries.c <<'END'
#include <dlfcn.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
extern int numbers[3]; // of the archive
int added(int);
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static double sum;
static void *work(void *n) {
    pthread_mutex_lock(&lock);
    sum += sin((double)(long)n) + pow(2, (double)(long)n);
    pthread_mutex_unlock(&lock);
    return n;
}
static void *late(void *n) {
    (void)n;
    printf("%.6f %d %d\n", sum, added(4), numbers[2]);
    exit(9);
}
int main(void) {
    pthread_t threads[4], other;
    for (long i = 0; i < 4; ++i) pthread_create(&threads[i], 0, work, (void *)i);
    for (int i = 0; i < 4; ++i) pthread_join(threads[i], 0);
    void *maths = dlopen("libm.so.6", RTLD_NOW);
    double (*cosine)(double) = (double (*)(double))dlsym(maths, "cos");
    printf("%.6f %d\n", cosine(1), dlsym(maths, "nothing") == 0);
    pthread_create(&other, 0, late, 0);
    pthread_exit(0);
}
END
cat >added.c <<'END'
#include <stdio.h>
int added(int n) { return fprintf(stdout, "added\n") + n; }
END
cat >unused.c <<'END'
__thread int local;
int *unused(void) { return &local; }
END
echo 'int numbers[3] = {1, 2, 30};' >numbers.c
gcc -Os -c libraries.c && gcc -Os -fPIC -c added.c && gcc -Os -c numbers.c unused.c
ar rcs libmine.a added.o numbers.o unused.o
check "threads, maths, dlsym, and of an archive what is needed" ways libraries.o -L. -lmine -lm -pthread
check "... by imports" takes imports libraries.o libmine.a -lm
check "... which exports nothing but what it opens libraries with" eval '! grep -qa pthread_create packed/run'
echo 'int puts(const char *); __attribute__((destructor)) static void own(void) { puts("gone"); }' >own.c
gcc -shared -fPIC added.c numbers.c own.c -Wl,-soname,libown.so.1 -o libown.so.1 && ln -sf libown.so.1 libown.so
gcc -Os -fPIC -c libraries.c
export LD_LIBRARY_PATH=$WORK
check "... of a library of one's own, with its data" ways libraries.o -L. -lown -lm
echo 'int added(int); int main(void) { return added(1); }' >own.c && gcc -Os -c own.c
check "... and its destructors" eval 'ways own.o -L. -lown && grep -q gone got'
rm libown.so.1
check "a library that is missing is named when the program starts" refuses 127 libown.so.1 packed/run
unset LD_LIBRARY_PATH

# -flto: imports are known only when all is compiled
gcc -Os -flto -c libraries.c added.c numbers.c
gcc-ar rcs libmine.a added.o numbers.o
check "-flto" ways libraries.o added.o numbers.o -lm
check "... with costs by file" prints '^libraries.o +[0-9]' "$link" libraries.o added.o numbers.o -lm -o packed/run --way imports "${few[@]}"
check "... in an archive" ways libraries.o libmine.a -lm

if command -v g++ >/dev/null; then
    cat >cpp.cpp <<'END'
#include <cstdio>
#include <cstdlib>
struct Shape {
    virtual ~Shape() { std::puts("gone"); }
    virtual int sides() const = 0;
};
struct Square : Shape {
    int sides() const override { return 4; }
};
struct Other : Shape {
    int sides() const override { return std::atoi("5"); }
};
static Shape *shapes[] = {new Square, new Other};
struct Last {
    ~Last() { std::puts("last"); }
} last;
int main(int count, char **words) {
    for (Shape *shape : shapes) {
        std::printf("%d %s %d\n", shape->sides(), words[count - 1], dynamic_cast<Square *>(shape) != nullptr);
        delete shape;
    }
    return 3;
}
END
    g++ -Os -fno-exceptions -c cpp.cpp && g++ -Os -pthread -c "$SOURCE/tests/programs/pack/thrown.cpp"
    check "C++ with constructors, destructors and types" eval 'takes imports cpp.o && same g++ cpp.o'
    check "... compiled with -fPIC" eval 'g++ -Os -fPIC -fno-exceptions -c cpp.cpp && takes imports cpp.o && same g++ cpp.o'
    check "C++ with exceptions, threads and streams: dynamic" eval 'takes dynamic thrown.o && same g++ thrown.o'
    check "... and why not by imports" prints '^imports .*thrown.o has tables of exceptions: compile with -fno-exceptions$' cat printed.txt
fi
if command -v clang >/dev/null && clang -Os -c c.c -o clang.o; then
    check "of clang" ways clang.o
    clang -Os -fPIC -c c.c -o clang.o
    check "... with -fPIC" ways clang.o
fi
if [ -e /usr/include/SDL2/SDL.h ] && [ -e /usr/include/GL/gl.h ]; then
    cat >sdl.c <<'END'
#include <SDL2/SDL.h>
#include <GL/gl.h>
int main(int count, char **words) {
    SDL_Window *window;
    (void)words;
    if (SDL_Init(SDL_INIT_VIDEO | SDL_INIT_TIMER)) return 1;
    window = SDL_CreateWindow("intro", 0, 0, 320, 180, count > 9 ? SDL_WINDOW_OPENGL : 0);
    if (count > 9) {
        SDL_GL_CreateContext(window);
        for (int i = 0; i < 100; ++i) {
            glClear(GL_COLOR_BUFFER_BIT);
            glRects(-1, -1, 1, 1);
            SDL_GL_SwapWindow(window);
        }
    }
    SDL_Surface *surface = SDL_GetWindowSurface(window);
    SDL_FillRect(surface, 0, SDL_MapRGB(surface->format, 10, 20, 30));
    SDL_Log("%s %d %d %d", SDL_GetCurrentVideoDriver(), surface->w, surface->h, ((unsigned char *)surface->pixels)[0]);
    SDL_Quit();
    return 5;
}
END
    gcc -Os -c sdl.c
    export SDL_VIDEODRIVER=dummy
    check "SDL2 and OpenGL" eval 'takes imports sdl.o -lSDL2 -lGL && same gcc sdl.o -lSDL2 -lGL'
else
    echo "not checked: SDL2 and OpenGL, whose headers are not installed"
fi

# All of libc in the program
cat >small.c <<'END'
#include <stdio.h>
int main(int count, char **words) { return printf("%d %s\n", count, words[1]); }
END
for static in musl-gcc ${2:+gcc}; do # that of gcc is a hundred times as large
    command -v $static >/dev/null || { echo "not checked: $static"; continue; }
    $static -Os -c small.c
    check "static by $static, where it is asked for" takes static small.o --way static --cc $static
    check "... the same" same "$static -static" small.o
done

# What goes wrong
fresh() { rm -f made && "$@" && [ ! -e made ] && [ -z "$(ls -d made.* 2>/dev/null)" ]; }
cat >missing.c <<'END'
void SDL_Quit(void);
double floor(double);
int main(int n, char **w) { SDL_Quit(); return (int)floor(n) + (w == 0); }
END
cat >errno.c <<'END'
extern char **environ;
int main(void) { return environ == 0; }
END
echo '#include <stdlib.h>
void *malloc(size_t n) { static char heap[9]; return n < 9 ? heap : 0; } int main(void) { return malloc(1) == calloc(1, 1); }' >malloc.c
gcc -Os -fno-builtin -c missing.c malloc.c && gcc -Os -fPIE -c errno.c && gcc -c numbers.c
check "a missing library is named" fresh refuses 2 "has 'SDL_Quit'" "$link" missing.o -lm -o made
check "... with the word to add" fresh refuses 2 "add -lSDL2" "$link" missing.o -lm -o made
check "... there is none of that name" fresh refuses 2 "no library for -lnothing" "$link" c.o -lnothing -o made
check "no main()" fresh refuses 2 "has main()" "$link" numbers.o -o made
check "no objects" fresh refuses 2 "object files" "$link" -lm -o made
check "a file that is not there" fresh refuses 2 "no file absent.o" "$link" absent.o -o made
check "a source" fresh refuses 2 "c.c is no object file: compile it" "$link" c.c -o made
check "a program" fresh refuses 2 "is a program" "$link" "$(type -P true)" -o made
check "an unknown option" fresh refuses 2 "cannot use '--nope'" "$link" --nope c.o -o made
check "an unknown way" fresh refuses 2 "--way is" "$link" c.o --way there -o made
check "what it decides itself" fresh refuses 2 "-shared is not for pack-link" "$link" c.o -shared -o made
check "its own objects stay" refuses 2 "c.o would be written over" "$link" c.o -o ./c.o
printf '%s\n' '-lm "c.o"' "--way 'imports'" >words
check "words from a file" eval 'takes imports @words && same "gcc -no-pie" c.o -lm'
echo '@around -lm' >around
check "... that names itself" fresh refuses 2 "@around reads itself again and again" "$link" @around c.o -o made
check "... that is not there" fresh refuses 2 "no file @absent" "$link" @absent -o made
check "no such compiler" fresh refuses 2 "cannot run nocc" "$link" c.o --cc nocc -o made
check "data of libc that changes, named directly" fresh refuses 2 "errno.o reads 'environ' of libc.so.6 directly: compile it with -fPIC" "$link" errno.o --way imports -o made
check "a function that libc looks for in the program" fresh refuses 2 "looks for 'malloc' in the program" "$link" malloc.o --way imports -o made
check "libraries in folders of its own" fresh refuses 2 "(-rpath)" "$link" c.o -Wl,-rpath,/tmp --way imports -o made
check "over a budget" fresh eval '"$link" c.o -o made "${few[@]}" --budget 100 >printed.txt 2>err; [ $? = 1 ] && grep -q "over budget" err'
check "nowhere to write" refuses 2 "cannot write" bash -c "'$link' c.o -o /nowhere/out 2>&1 >/dev/null | tail -n 1 >&2; exit \${PIPESTATUS[0]}"
cp c.o cut.o && truncate -s 900 cut.o
check "an object that is cut short" fresh refuses 2 "cut.o" "$link" cut.o -o made

check "a search, a report, and what it linked" eval '"$link" c.o -o made "${few[@]}" --effort 1 --report report.json --html report.html --text report.md --name mine --keep kept -v >printed.txt 2>err'
check "... are there" eval '[ -s report.json ] && [ -s report.html ] && [ -s report.md ] && grep -q mine: made && [ -s kept/program.elf ] && [ -s kept/program.map ] && [ -s kept/start.s ]'
check "... by another way, too" eval '"$link" c.o -o made "${few[@]}" --way dynamic --keep kept >printed.txt && grep -q libc_start_main kept/start.s'
check "... with the commands" grep -q '^cc .*--gc-sections' err
ended_early() { # by a signal, while it searches: nothing stays
    rm -f err
    "$link" c.o -o made --way imports "${few[@]}" --effort 100 -v >printed.txt 2>err &
    PIDS+=($!)
    await eval "grep -qs '^searching' err || gone $!" && kill "$1" $! && ended $!
    [ $? = 1 ] && ! ls -d "$(grep -m 1 -oE '/tmp/odraz-[A-Za-z0-9]{6}/' err)" 2>/dev/null
}
always_early() { for _ in {1..10}; do ended_early "$1" || return; done; } # now just before the search, now in it
check "ended by a signal it leaves nothing" fresh always_early -TERM
check "--help" prints '^Usage: pack-link' "$link" --help
finish
