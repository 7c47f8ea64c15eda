// Tests the film where the light of the hall cannot be solved: scenes in the hall are black, and all others
// are as they should be.
#include "tests/support/loaded_film.h"
#include "tests/support/pictures.h"

using namespace odraz;

constexpr int kAcross = 96, kHigh = 54;
const IntroSettings kWithHall = {.width = kAcross, .height = kHigh, .pairs = true, .hall = true};
constexpr double kElsewhere = 50, kInHall[] = {70, 100, 130}; // the first one has letters

// The film with its hall, which is loaded with a table of OpenGL and in some bytes of memory.
struct DarkFilm {
    Threads threads{2};
    HeapArena memory;
    Intro *intro;

    DarkFilm(const char *complaint, const Gl &gl, size_t bytes) : memory(bytes) {
        const char *line = load(intro, kWithHall, memory.arena, threads.workers, kDrawnHemicubes, &gl);
        EXPECT_EQ(std::string(line ? line : "").find(complaint), 0u);
    }
};

static bool isBlack(const Picture &p) {
    for (int i = 0; i < kAcross * kHigh * 4; ++i)
        if (i % 4 < 3 && p.rgba[i] > 2) return false; // the film has grain
    return true;
}

static int calls; // how often pictures were read back

// Ways in which reading back goes wrong.
static void (*const kWrong[])(GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void *) = {
    [](GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void *) {}, // refused, or the context is lost
    [](GLint, GLint, GLsizei w, GLsizei h, GLenum, GLenum, void *to) { memset(to, 0, (size_t)(w * h) * 4); },
    [](GLint, GLint, GLsizei w, GLsizei h, GLenum, GLenum, void *to) {
        for (int i = 0; i < w * h; ++i) ((uint32_t *)to)[i] = (uint32_t)i * 2654435761u; // noise
    },
    [](GLint x, GLint y, GLsizei w, GLsizei h, GLenum format, GLenum type, void *to) {
        headlessGl().glReadPixels(x, y, w, h, format, type, to); // noise in one pixel of the third picture
        if (++calls == 3) ((uint32_t *)to)[w * h / 2] = 1 << 30;
    },
    [](GLint x, GLint y, GLsizei w, GLsizei h, GLenum format, GLenum type, void *to) {
        headlessGl().glReadPixels(x, y, w, h, format, type, to); // a context that is lost after two pictures
        if (++calls > 2) memset(to, 0, (size_t)(w * h) * 4);
    },
    [](GLint, GLint, GLsizei w, GLsizei h, GLenum, GLenum, void *to) {
        for (int i = 0; i < w * h; ++i) ((uint32_t *)to)[i] = 7; // the same patch everywhere
    },
};

TEST(DarkHall, CostsOnlyItsScenes) {
    const Quality &draft = named(QualityName::Draft);
    LoadedFilm without(2, kAcross, kHigh, true);
    std::vector<uint8_t> flake = bytesOf(picture(*without.intro, 0, kElsewhere, draft));
    for (auto &read : kWrong) {
        SCOPED_TRACE((int)(&read - kWrong));
        Gl gl = headlessGl();
        gl.glReadPixels = read;
        calls = 0;
        DarkFilm dark("cannot light the hall: OpenGL 3.3 cannot draw integers", gl,
                      memoryNeeded(kWithHall, 2));
        Intro &intro = *dark.intro;
        EXPECT_EQ(bytesOf(picture(intro, 0, kElsewhere, draft)), flake);
        for (double t : kInHall) {
            EXPECT_TRUE(isBlack(picture(intro, 0, t, draft))) << t;
            EXPECT_TRUE(isBlack(picture(intro, 1, t + 4 / 60., draft))) << t;
            EXPECT_TRUE(isBlack(between(intro, 0, 1))) << t;
        }
        // From a scene in the hall to the next one that is not
        picture(intro, 0, kElsewhere, draft);
        picture(intro, 1, kInHall[0], draft);
        EXPECT_TRUE(isBlack(between(intro, 0, 1, 0.99)));
    }
}

// An arena that fills at any stage of solving is reported as short of memory.
TEST(DarkHall, MayLackMemory) {
    size_t whole = memoryNeeded(kWithHall, 2), film = LoadedFilm(2, kAcross, kHigh, true).memory.arena.used;
    for (double share : {0.05, 0.3, 0.5, 0.6})
        DarkFilm("not enough memory", headlessGl(), film + (size_t)((double)(whole - film) * share));
}
