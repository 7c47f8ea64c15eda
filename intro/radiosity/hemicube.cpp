#include "radiosity/hemicube.h"

#include "base/maths.h"
#include "base/random.h"
#include "radiosity/clip.h"

namespace odraz {

namespace {

constexpr int kVertices = 1 << 15; // the most in a draw call

// Depth is proportional to 1/w, which is linear on a face. A fragment computes it from the plane of its facet
// at the exact centre of its pixel. GPUs round vertices, to 1/256 of a pixel, and interpolate between the
// rounded ones: a wall that is seen at a grazing angle would then appear in front of a nearer one.
struct Vertex {
    FaceCorner corner; // its x and y are in the atlas
    // The rest is the same for all vertices of a facet on a face, except for `least`
    float first;        // first patch + 1; -1: a back
    float least;        // depth of the triangle's farthest corner; no fragment is deeper
    Vec3 plane;         // its dot product with (x, y, half) is the depth. x and y are pixels from the origin
    float half;         // half a face's side, in pixels
    float x, y;         // origin of the face in the atlas, in pixels: where the corner's x and y are 0
    float across, down; // patches
};
static_assert(sizeof(Vertex) == 64, "the shaders read four vectors of four floats");

constexpr char kVertexShader[] = "layout(location=0)in mat4 v;"
                                 "out vec2 s;flat out mat3x4 f;"
                                 "void main(){gl_Position=v[0];s=v[1].xy;f=mat3x4(v[1],v[2],v[3]);}";
constexpr char kFragmentShader[] =
    "in vec2 s;flat in mat3x4 f;out int o;"
    "void main(){gl_FragDepth=max(f[0].w,dot(f[1].xyz,vec3(gl_FragCoord.xy-f[2].xy,f[1].w)));"
    "vec2 a=clamp(floor(s),vec2(0),f[2].zw-1);o=int(f[0].z+a.y*f[2].z+a.x);}";

struct VertexWriter {
    Hemicubes &h;
    float pixelX, pixelY; // a pixel, in clip units
    int vertices;

    void flush() {
        const Gl &gl = *h.gl;
        gl.glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)vertices * (GLsizeiptr)sizeof(Vertex), h.vertices,
                        GL_STREAM_DRAW);
        gl.glDrawArrays(GL_TRIANGLES, 0, vertices);
        vertices = 0;
    }
};

// Lays out a facet on a face, cut at the borders that it crosses. `vertex` has what its vertices share.
// `near` is the w at which depth is 1.
void layOut(VertexWriter &out, const FaceCorner *corners, uint32_t crossed, bool top, float near,
            Vertex vertex) {
    FaceCorner buffers[2][8];
    int count = 4;
    const FaceCorner *polygon = clipToFace(corners, count, top, crossed, buffers);
    // Write a fan of triangles
    if (out.vertices + 3 * (count - 2) > kVertices) out.flush();
    for (int i = 2; i < count; ++i) {
        vertex.least = near / max(polygon[0].w, max(polygon[i - 1].w, polygon[i].w));
        for (int k = 0; k < 3; ++k) {
            FaceCorner &c = vertex.corner = polygon[k ? i - 2 + k : 0];
            // Clamp rounding errors to the picture: beyond it OpenGL would clip, which is slow
            auto inAtlas = [&](float x, float centre, float pixel) {
                return clamp(fmadd(x, vertex.half * pixel, fmadd(centre, pixel, -1) * c.w), -c.w, c.w);
            };
            c.x = inAtlas(c.x, vertex.x, out.pixelX);
            c.y = inAtlas(c.y, vertex.y, out.pixelY);
            ((Vertex *)out.h.vertices)[out.vertices++] = vertex;
        }
    }
}

// (x, y) is the middle of the hemicube's lower edge in the atlas, in pixels.
void layOutHemicube(VertexWriter &out, const Model &model, const Eye &eye, float x, float y, float scale) {
    for (int i = 0; i < model.facetCount; ++i) {
        const Facet &f = model.facets[i];
        const Chart &c = model.charts[f.chart];
        float height = dot(eye.p - c.corner, c.n);
        // Skip facets in the patch's plane. Walls next to the patch are visible, however near they are
        if (abs(height) <= scale && abs(dot(c.n, eye.frame.w)) > 0.9999f) continue;
        bool back = height < -scale;
        if (back && !model.open) continue;
        float perU = (float)c.patchesAcross / c.width, perV = (float)c.patchesDown / c.height;
        // Transform to the hemicube's frame. A facet that is outside one border of a face is not on the face
        FaceCorner local[5]; // the corners; the last one's x, y and w are the plane of depths
        uint32_t all = ~0u, some = 0;
        for (int k = 0; k < 4; ++k) {
            Vec3 p = eye.frame * (f.corner(c, k) - eye.p);
            local[k] = {p.x, p.y, 0, p.z, f.u[k] * perU, f.v[k] * perV};
            uint32_t code = outsideFaces(p);
            all &= code, some |= code;
        }
        Vertex vertex;
        vertex.x = x, vertex.y = y, vertex.half = (float)out.h.px * 0.5f;
        vertex.first = (float)(c.firstPatch + 1);
        vertex.across = c.patchesAcross, vertex.down = c.patchesDown;
        float near = scale;
        // Draw backs slightly deeper than they are, so that a front with the same edge wins along a
        // silhouette
        if (back) vertex.first = -1, vertex.across = vertex.down = 1, near *= 0.99f;
        Vec3 plane = eye.frame * c.n * (near / (-vertex.half * height));
        local[4] = {plane.x, plane.y, 0, plane.z, 0, 0};
        for (int side = -1; side < 4; ++side, all >>= 4, some >>= 4) {
            vertex.y += vertex.half;
            vertex.plane = {local[4].x, local[4].y, local[4].w};
            if (!(all & 15)) layOut(out, local, some, side == -1, near, vertex);
            for (FaceCorner &p : local) { // to the next face's frame
                float x = p.x;
                p.x = side == -1 ? p.y : -p.w;
                if (side == -1) p.y = p.w;
                p.w = x;
            }
        }
    }
}

} // namespace

Eye hemicubeEye(const Vec3 &p, const Vec3 &n, uint32_t number) {
    float angle = unitFloat(pcg(number)) * (2 * kPi), c = cos(angle), s = sin(angle);
    Vec3 a = normalize(cross(abs(n.y) < 0.9f ? Vec3{0, 1, 0} : Vec3{1, 0, 0}, n)), b = cross(n, a);
    return {p, {a * c + b * s, b * c - a * s, n}};
}

void shapeAtlas(Hemicubes &h, int px) {
    h.px = px;
    h.columns = clamp(1024 / px, 1, kHemicubeBatch / 4);
    h.lines = clamp(256 / px, 1, 4);
    if (px < 64 && px >= 32) h.lines = kHemicubeBatch / h.columns;
    h.batch = h.columns * h.lines;
}

size_t hemicubeBytes(int px) {
    Hemicubes h;
    shapeAtlas(h, px);
    return (size_t)h.batch * (size_t)(3 * px * px) * 4 + kVertices * sizeof(Vertex) + 128;
}

bool openHemicubes(Hemicubes &h, const Gl &gl, Arena &arena, int px) {
    h = {};
    h.gl = &gl;
    shapeAtlas(h, px);
    h.vertices = arena.allocate<Vertex>(kVertices);
    h.ids = arena.allocate<uint32_t>((size_t)h.batch * (size_t)(3 * px * px));
    if (arena.full) return false;

    // Create an atlas of ids and depths
    int width = h.columns * px, height = h.lines * 3 * px;
    gl.glGenFramebuffers(1, &h.framebuffer);
    gl.glBindFramebuffer(GL_FRAMEBUFFER, h.framebuffer);
    gl.glGenRenderbuffers(2, h.images);
    for (int i = 0; i < 2; ++i) {
        gl.glBindRenderbuffer(GL_RENDERBUFFER, h.images[i]);
        gl.glRenderbufferStorage(GL_RENDERBUFFER, i ? GL_DEPTH_COMPONENT32F : GL_R32I, width, height);
        gl.glFramebufferRenderbuffer(GL_FRAMEBUFFER, i ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0,
                                     GL_RENDERBUFFER, h.images[i]);
    }

    h.program = gl.glCreateProgram();
    for (int i = 0; i < 2; ++i) {
        GLuint shader = gl.glCreateShader(i ? GL_FRAGMENT_SHADER : GL_VERTEX_SHADER);
        const char *sources[2] = {"#version 330\n", i ? kFragmentShader : kVertexShader};
        gl.glShaderSource(shader, 2, sources, nullptr);
        gl.glCompileShader(shader);
        gl.glAttachShader(h.program, shader);
        gl.glDeleteShader(shader); // with the program
    }
    gl.glLinkProgram(h.program);

    gl.glGenVertexArrays(1, &h.vertexArray);
    gl.glBindVertexArray(h.vertexArray);
    gl.glGenBuffers(1, &h.buffer);
    gl.glBindBuffer(GL_ARRAY_BUFFER, h.buffer);
    for (GLuint i = 0; i < 4; ++i) {
        gl.glVertexAttribPointer(i, 4, GL_FLOAT, GL_FALSE, sizeof(Vertex), (void *)(size_t)(16 * i));
        gl.glEnableVertexAttribArray(i);
    }
    return true;
}

bool drawHemicubes(Hemicubes &h, const Model &model, const Eye *eyes, int count) {
    // The scene's size sets the tolerance for facets in the patch's plane
    float size = 0;
    for (int i = 0; i < model.chartCount; ++i) {
        const Chart &c = model.charts[i];
        size = max(size, sumAbs(c.corner) + c.width + c.height);
    }
    const Gl &gl = *h.gl;
    int width = h.columns * h.px, height = h.lines * 3 * h.px;
    gl.glBindFramebuffer(GL_FRAMEBUFFER, h.framebuffer);
    gl.glViewport(0, 0, width, height);
    gl.glEnable(GL_DEPTH_TEST);
    gl.glDepthFunc(GL_GREATER);
    static const GLint kZero[4] = {};
    static const GLfloat kFarthest = 0;
    gl.glClearBufferiv(GL_COLOR, 0, kZero);
    gl.glClearBufferfv(GL_DEPTH, 0, &kFarthest);
    gl.glUseProgram(h.program);
    gl.glBindVertexArray(h.vertexArray);
    gl.glBindBuffer(GL_ARRAY_BUFFER, h.buffer);
    VertexWriter out = {h, 2.f / (float)width, 2.f / (float)height, 0};
    for (int i = 0; i < count; ++i)
        layOutHemicube(out, model, eyes[i], ((float)(i % h.columns) + 0.5f) * (float)h.px,
                       (float)(i / h.columns * 3 * h.px), size * 4e-7f);
    out.flush();
    h.ids[0] = kBackSide - 1; // no patch. It stays if nothing is read back
    // Read the rows of the atlas that are used
    int pixels = (count + h.columns - 1) / h.columns * 3 * h.px;
    gl.glReadPixels(0, 0, width, pixels, GL_RED_INTEGER, GL_INT, h.ids);
    pixels *= width;
    for (int i = 0; i < pixels; ++i)
        if (h.ids[i] + 1 > (uint32_t)model.patchCount + 1) return false; // kBackSide + 1 is 0
    return true;
}

void closeHemicubes(Hemicubes &h) {
    const Gl &gl = *h.gl;
    gl.glBindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.glDisable(GL_DEPTH_TEST);
    gl.glDeleteFramebuffers(1, &h.framebuffer);
    gl.glDeleteRenderbuffers(2, h.images);
    gl.glDeleteBuffers(1, &h.buffer);
    gl.glDeleteVertexArrays(1, &h.vertexArray);
    gl.glUseProgram(0);
    gl.glDeleteProgram(h.program);
}

const HemicubeMethod kDrawnHemicubes = {[](Hemicubes &h, const Gl *gl, const Scene &, Arena &arena, int px) {
                                            return openHemicubes(h, *gl, arena, px);
                                        },
                                        drawHemicubes, closeHemicubes};

} // namespace odraz
