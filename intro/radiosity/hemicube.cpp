#include "radiosity/hemicube.h"

#include "base/maths.h"
#include "base/random.h"
#include "radiosity/clip.h"

namespace odraz {

namespace {

constexpr int kVertices = 1 << 16; // the most in a draw call
// A vertex: x, y, w in the atlas; position on the chart, in patches; first patch + 1; patches across and down
constexpr int kFloats = 7;

// Backs are drawn slightly deeper than they are, so that a front with the same edge wins along a silhouette
constexpr char kVertexShader[] = "layout(location=0)in vec3 p;"
                                 "layout(location=1)in vec2 q;"
                                 "layout(location=2)in uvec2 c;"
                                 "out vec2 s;flat out uvec2 f;flat out float d;"
                                 "uniform float n;"
                                 "void main(){d=c.x==~0u?n*.99:n;gl_Position=vec4(p.xy,0.,p.z);s=q;f=c;}";
// Depth is 1/w: OpenGL's own is too coarse far away
constexpr char kFragmentShader[] =
    "in vec2 s;flat in uvec2 f;flat in float d;out uint o;"
    "void main(){gl_FragDepth=d*gl_FragCoord.w;uint a=f.y&65535u;"
    "o=f.x==~0u?f.x:f.x+min(uint(max(s.y,0.)),(f.y>>16)-1u)*a+min(uint(max(s.x,0.)),a-1u);}";

struct VertexWriter {
    Hemicubes &h;
    float scaleX, scaleY; // half a face in the atlas, in clip units
    int vertices;

    void flush() {
        const Gl &gl = *h.gl;
        gl.glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)vertices * kFloats * 4, h.vertices, GL_STREAM_DRAW);
        gl.glDrawArrays(GL_TRIANGLES, 0, vertices);
        vertices = 0;
    }
};

// A face in the atlas: (x, y) is its centre (top face), or the centre of its horizon (other faces).
struct AtlasFace {
    bool top;
    float x, y;
};

// Lays out a facet on a face, cut at the borders that it crosses. `grid`: a vertex's last two numbers.
void layOut(VertexWriter &out, const FaceCorner (&corners)[4], uint32_t crossed, const AtlasFace &face,
            const uint32_t (&grid)[2]) {
    FaceCorner buffers[2][8];
    int count = 4;
    const FaceCorner *polygon = clipToFace(corners, count, face.top, crossed, buffers);
    // Write a fan of triangles
    if (out.vertices + 3 * (count - 2) > kVertices) out.flush();
    for (int i = 2; i < count; ++i)
        for (int k = 0; k < 3; ++k) {
            const FaceCorner &c = polygon[k ? i - 2 + k : 0];
            float *v = out.h.vertices + (size_t)out.vertices++ * kFloats;
            // Clamp rounding errors to the picture: beyond it OpenGL would clip, which is slow
            v[0] = clamp(fmadd(c.x, out.scaleX, face.x * c.w), -c.w, c.w);
            v[1] = clamp(fmadd(c.y, out.scaleY, face.y * c.w), -c.w, c.w);
            v[2] = c.w;
            v[3] = c.s;
            v[4] = c.t;
            v[5] = fromBits((int32_t)grid[0]);
            v[6] = fromBits((int32_t)grid[1]);
        }
}

void layOutHemicube(VertexWriter &out, const Model &model, const Eye &eye, float x0, float y0, float scale) {
    for (int i = 0; i < model.facetCount; ++i) {
        const Facet &f = model.facets[i];
        const Chart &c = model.charts[f.chart];
        float height = dot(eye.p - c.corner, c.n);
        // Skip facets in the patch's plane. Walls next to the patch are visible, however near they are
        if (abs(height) <= scale && abs(dot(c.n, eye.frame.w)) > 0.9999f) continue;
        bool back = height < -scale;
        if (back && !model.open) continue;
        // Transform to the hemicube's frame. A facet that is outside one border of a face is not on the face
        Vec3 local[4];
        uint32_t all = ~0u, some = 0;
        for (int k = 0; k < 4; ++k) {
            local[k] = eye.frame * (f.corner(c, k) - eye.p);
            uint32_t code = outsideFaces(local[k]);
            all &= code, some |= code;
        }
        uint32_t grid[2] = {back ? kBackSide : (uint32_t)c.firstPatch + 1,
                            (uint32_t)c.patchesAcross | (uint32_t)c.patchesDown << 16};
        float perU = (float)c.patchesAcross / c.width, perV = (float)c.patchesDown / c.height;
        for (int side = -1; side < 4; ++side, all >>= 4, some >>= 4) {
            FaceCorner corners[4];
            for (int k = 0; k < 4; ++k) {
                Vec3 &p = local[k];
                corners[k] = {p.x, p.y, p.z, f.u[k] * perU, f.v[k] * perV};
                p = side == -1 ? Vec3{p.y, p.z, p.x} : Vec3{-p.z, p.y, p.x}; // to the next face's frame
            }
            if (all & 15) continue;
            float y = side == -1 ? 1 : (float)(2 + side);
            layOut(out, corners, some, {side == -1, x0 + out.scaleX, fmadd(y, out.scaleY, y0)}, grid);
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
    return (size_t)h.batch * (size_t)(3 * px * px) * 4 + (size_t)kVertices * kFloats * 4 + 128;
}

bool openHemicubes(Hemicubes &h, const Gl &gl, Arena &arena, int px) {
    h = {};
    h.gl = &gl;
    h.method = &kDrawnHemicubes;
    shapeAtlas(h, px);
    h.vertices = arena.allocate<float>((size_t)kVertices * kFloats);
    h.ids = arena.allocate<uint32_t>((size_t)h.batch * (size_t)(3 * px * px));
    if (arena.full) return false;

    // Create an atlas of ids and depths
    int width = h.columns * px, height = h.lines * 3 * px;
    gl.glGenFramebuffers(1, &h.framebuffer);
    gl.glBindFramebuffer(GL_FRAMEBUFFER, h.framebuffer);
    gl.glGenRenderbuffers(2, h.images);
    for (int i = 0; i < 2; ++i) {
        gl.glBindRenderbuffer(GL_RENDERBUFFER, h.images[i]);
        gl.glRenderbufferStorage(GL_RENDERBUFFER, i ? GL_DEPTH_COMPONENT32F : GL_R32UI, width, height);
        gl.glFramebufferRenderbuffer(GL_FRAMEBUFFER, i ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0,
                                     GL_RENDERBUFFER, h.images[i]);
    }
    if (gl.glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return false;

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
    GLint linked = 0;
    gl.glGetProgramiv(h.program, GL_LINK_STATUS, &linked);

    gl.glGenVertexArrays(1, &h.vertexArray);
    gl.glBindVertexArray(h.vertexArray);
    gl.glGenBuffers(1, &h.buffer);
    gl.glBindBuffer(GL_ARRAY_BUFFER, h.buffer);
    gl.glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kFloats * 4, nullptr);
    gl.glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, kFloats * 4, (void *)12);
    gl.glVertexAttribIPointer(2, 2, GL_UNSIGNED_INT, kFloats * 4, (void *)20);
    for (GLuint i = 0; i < 3; ++i) gl.glEnableVertexAttribArray(i);
    return linked;
}

void drawHemicubes(Hemicubes &h, const Model &model, const Eye *eyes, int count) {
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
    static const GLuint kZero[4] = {};
    static const GLfloat kFarthest = 0;
    gl.glClearBufferuiv(GL_COLOR, 0, kZero);
    gl.glClearBufferfv(GL_DEPTH, 0, &kFarthest);
    gl.glUseProgram(h.program);
    float near = size * 1e-7f;
    gl.glUniform1fv(gl.glGetUniformLocation(h.program, "n"), 1, &near);
    gl.glBindVertexArray(h.vertexArray);
    gl.glBindBuffer(GL_ARRAY_BUFFER, h.buffer);
    VertexWriter out = {h, 1.f / (float)h.columns, 1.f / (float)(3 * h.lines), 0};
    for (int i = 0; i < count; ++i)
        layOutHemicube(out, model, eyes[i], -1 + 2 * out.scaleX * (float)(i % h.columns),
                       -1 + 6 * out.scaleY * (float)(i / h.columns), size * 4e-7f);
    out.flush();
    gl.glReadPixels(0, 0, width, (count + h.columns - 1) / h.columns * 3 * h.px, GL_RED_INTEGER,
                    GL_UNSIGNED_INT, h.ids);
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
