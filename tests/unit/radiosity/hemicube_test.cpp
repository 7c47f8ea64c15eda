// Tests hemicubes: visibility, sums and energy in closed rooms, and freeing all objects.
#include "tests/support/hemicube_bench.h"
#include "tests/support/room.h"

#include <dlfcn.h>
#include <optional>

using namespace odraz;

// While it exists, hemicubes draw with vertices that are rounded to multiples of `unit` pixels, as GPUs do:
// to 1/256 of a pixel, software WebGL to 1/16. Software OpenGL rounds nothing. A vertex begins with x, y, z
// and w.
struct RoundedVertices {
    RoundedVertices(Hemicubes &h, double unit) : hemicubes(h), real(h.gl), table(*h.gl), pixels(unit) {
        current = this;
        table.glBufferData = [](GLenum, GLsizeiptr size, const void *from, GLenum) {
            current->bytes = size, current->vertices = (float *)from;
        };
        table.glDrawArrays = [](GLenum mode, GLint first, GLsizei count) {
            current->draw(mode, first, count);
        };
        h.gl = &table;
    }
    RoundedVertices(const RoundedVertices &) = delete;
    ~RoundedVertices() { hemicubes.gl = real; }

private:
    static inline RoundedVertices *current;
    Hemicubes &hemicubes;
    const Gl *real;
    Gl table;
    double pixels;
    GLsizeiptr bytes = 0;
    float *vertices = nullptr;

    void draw(GLenum mode, GLint first, GLsizei count) {
        const double half[] = {hemicubes.columns * hemicubes.px / 2.,
                               hemicubes.lines * 3 * hemicubes.px / 2.};
        for (int i = 0; i < count; ++i) {
            float *v = vertices + bytes / 4 / count * i, w = v[3];
            for (int k = 0; k < 2 && w > 0; ++k)
                v[k] =
                    (float)(std::round((double)(v[k] / w) * half[k] / pixels) * pixels / half[k] * (double)w);
        }
        real->glBufferData(GL_ARRAY_BUFFER, bytes, vertices, GL_STREAM_DRAW);
        real->glDrawArrays(mode, first, count);
    }
};

TEST(ClosedRoom, RowsSumToOne) {
    HemicubeBench b;
    addRoom(*b.model, {-2, -1.5f, -3}, {2, 1.5f, 3}, 0.5f);
    b.model->addBox({-0.5f, -1.5f, -0.5f}, {0.5f, 0.25f, 0.5f}, 0, 0.5f, Model::kUpright | Model::kTop);
    b.open(64, 1);
    for (int i = 0; i < b.model->patchCount; ++i) {
        const Patch &p = b.model->patches[i];
        if (p.share == 0) continue;
        double dark;
        auto row = b.row(hemicubeEye(p.p, b.model->charts[p.chart].n, (uint32_t)i), &dark);
        EXPECT_EQ(dark, 0) << i;
        EXPECT_NEAR(std::accumulate(row.begin(), row.end(), 0.), 1, 1e-6) << i;
    }
}

// A hemicube sees only the room, however near to the walls it is: no near plane clips it, and it sees nothing
// in its plane or behind the walls. GPUs round vertices, which must not change that.
TEST(ClosedRoom, NothingIsSeenFromOutsideAtAnyOffset) {
    const struct {
        double rounding;
        int leaks;
    } kCases[] = {{0, 0}, {1 / 256., 0}, {1 / 16., 2}};
    for (const auto &[rounding, most] : kCases)
        for (float scale : {1e-3f, 1.f, 1e3f}) {
            HemicubeBench b;
            Vec3 half = {1, 1, 1};
            addRoom(*b.model, -half * scale, half * scale, 0.5f * scale);
            // Add larger rooms around it, and squares below and next to the floor, some of them in its plane
            addRoom(*b.model, -half * (1.0001f * scale), half * (1.0001f * scale), 0.5f * scale);
            addRoom(*b.model, -half * (2 * scale), half * (2 * scale), 0.5f * scale);
            for (float x : {1.f, -3.f})
                b.model->addRect(Vec3{x, -1, -1} * scale, Vec3{0, 0, 2} * scale, Vec3{2, 0, 0} * scale, 0,
                                 0.5f * scale);
            b.open(32, 1);
            std::optional<RoundedVertices> rounded;
            if (rounding > 0) rounded.emplace(b.hemicubes(), rounding);
            const Chart &floor = b.model->charts[0], &outside = b.model->charts[6];
            int leaks = 0;
            for (float d = 1e-6f; d <= 1; d *= 1.7f)
                for (Vec3 p : {Vec3{-1 + d, -1, 0.3f}, Vec3{-1 + d, -1, 1 - d}, Vec3{0.2f, -1, -1 + d}}) {
                    bool leaking = false;
                    for (uint32_t id : b.visibleIds(hemicubeEye(p * scale, {0, 1, 0}, (uint32_t)bits(d)))) {
                        int patch = (int)id - 1;
                        // The patches of the floor, which are the first, are in the hemicube's plane
                        leaking |= id == kNothing || patch >= outside.firstPatch ||
                                   patch < floor.patchesAcross * floor.patchesDown;
                    }
                    leaks += leaking;
                }
            EXPECT_LE(leaks, most) << "rounded to " << rounding << ", scale " << scale;
        }
}

// Two distant walls are very close to each other: the nearer one must win in every pixel.
TEST(Depth, SeparatesNearFromFarAtADistance) {
    HemicubeBench b;
    b.model->addRect({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0, 1);
    b.model->addRect({-1000, 99.99f, -1000}, {2000, 0, 0}, {0, 0, 2000}, 0, 500);
    b.model->addRect({-1000, 100, -1000}, {2000, 0, 0}, {0, 0, 2000}, 0, 500);
    b.open(64, 1);
    const Chart &far = b.model->charts[2];
    auto row = b.row(hemicubeEye({0.5f, 0, 0.5f}, {0, 1, 0}, 3));
    for (int i = 0; i < far.patchesAcross * far.patchesDown; ++i)
        EXPECT_EQ(row[(size_t)(far.firstPatch + i)], 0);
}

// Closing hemicubes frees everything that openHemicubes() made.
TEST(Hemicubes, FreeAllObjects) {
    void *egl = dlopen("libEGL.so.1", RTLD_LAZY);
    ASSERT_TRUE(egl);
    auto find = (void *(*)(const char *))dlsym(egl, "eglGetProcAddress");
    ASSERT_TRUE(find);
    auto is = [&](const char *what, GLuint name) {
        return ((GLboolean(*)(GLuint))find(what))(name) == GL_TRUE;
    };
    HemicubeBench b;
    addRoom(*b.model, {0, 0, 0}, {1, 1, 1}, 1);
    b.open(16, 1);
    Hemicubes h = b.hemicubes();
    Eye eye = hemicubeEye(b.model->patches[0].p, b.model->patches[0].n, 0);
    drawHemicubes(h, *b.model, &eye, 1);
    auto existing = [&] {
        return is("glIsProgram", h.program) + is("glIsVertexArray", h.vertexArray) +
               is("glIsBuffer", h.buffer) + is("glIsFramebuffer", h.framebuffer) +
               is("glIsRenderbuffer", h.images[0]) + is("glIsRenderbuffer", h.images[1]);
    };
    EXPECT_EQ(existing(), 6);
    b.hemicube.reset();
    EXPECT_EQ(existing(), 0);
    for (GLuint shader = 1; shader < 100; ++shader) EXPECT_FALSE(is("glIsShader", shader)) << shader;
}

// In a room where every surface emits 1 and reflects rho, every radiosity is 1 / (1 - rho), for many rho at
// once. Around the wider box, hidden patches of the floor have a margin of 0.1 that is visible, but no
// visible sample point.
TEST(Furnace, ComesOutEven) {
    constexpr int kReflectances = 20;
    auto reflectance = [](int k) { return 0.99f * (float)(k % kReflectances) / (kReflectances - 1); };
    for (float wide : {0.5f, 0.9f}) {
        HemicubeBench b;
        addRoom(*b.model, {-2, -1.5f, -3}, {2, 1.5f, 3}, 0.5f);
        b.model->addBox({-wide, -1.5f, -wide}, {wide, 0.25f, wide}, 0, 0.5f, Model::kUpright | Model::kTop);
        b.open(64, 1);
        const int count = b.model->patchCount;
        for (int i = 0; i < count; ++i) b.model->patches[i].reflects = {1, 1, 1};
        FormFactors f = {};
        f.capacity = 1 << 20;
        f.links = b.memory.arena.allocate<Link>(f.capacity);
        ASSERT_TRUE(
            findFormFactors(kDrawnHemicubes, b.hemicubes(), *b.model, b.workers, b.memory.arena, f, {}));
        System s;
        ASSERT_TRUE(makeSystem(s, b.memory.arena, f, count, kReflectances));
        for (int i = 0; i < count * s.columns; ++i) {
            const FormFactorRow &row = f.rows[i / s.columns];
            s.reflectance[i] = reflectance(i % s.columns);
            for (int k = 0; k < row.count; ++k) s.direct[i] += row.links[k].share; // a neighbour emits 1
        }
        fillPatches(*b.model, f, s.columns, s.direct, 0, count);
        solve(s, b.workers, 1e-6f, 5000);
        for (int i = 0; i < count * kReflectances; ++i) {
            int patch = i / kReflectances, column = i % kReflectances;
            if (b.model->patches[patch].share == 0) continue;
            double exact = 1 / (1 - (double)reflectance(column));
            ASSERT_NEAR(1 + (double)s.radiosity[patch * s.columns + column], exact, 0.001 * exact)
                << wide << ' ' << column << ' ' << patch;
        }
    }
}
