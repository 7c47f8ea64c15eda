#include "tools/radiosity/view/picture.h"

#include "base/maths.h"
#include "tools/radiosity/read/upright.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <stdexcept>

namespace odraz::radiosity {

namespace {

enum { kSurface, kOutline, kEdge }; // values of `lines` in the shader
enum { kPoints, kLight, kTriangles, kOutlines, kEdges };
constexpr size_t kMostSamples = 16 << 20; // samples of a picture, 20 bytes each

bool hasClipControl(const ViewGl &gl) {
    GLint count = 0;
    gl.glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (int i = 0; i < count; ++i)
        if (!std::strcmp((const char *)gl.glGetStringi(GL_EXTENSIONS, (GLuint)i), "GL_ARB_clip_control"))
            return gl.glClipControl;
    return false;
}

template <class T> GLsizeiptr bytesOf(const std::vector<T> &list) {
    return (GLsizeiptr)(list.size() * sizeof(T));
}

} // namespace

GLuint ViewPicture::program(const char *vertex, const char *fragment, bool reversed) {
    GLuint made = gl.glCreateProgram();
    for (int i = 0; i < 2; ++i) {
        GLuint shader = gl.glCreateShader(i ? GL_FRAGMENT_SHADER : GL_VERTEX_SHADER);
        const char *sources[2] = {reversed ? "#version 330 core\n#define Z\n" : "#version 330 core\n",
                                  i ? fragment : vertex};
        gl.glShaderSource(shader, 2, sources, nullptr);
        gl.glCompileShader(shader);
        gl.glAttachShader(made, shader);
        gl.glDeleteShader(shader); // it is freed with the program
    }
    gl.glLinkProgram(made);
    GLint linked = 0;
    gl.glGetProgramiv(made, GL_LINK_STATUS, &linked);
    if (!linked)
        throw std::runtime_error("this OpenGL cannot compile the shaders: update Mesa or the driver");
    return made;
}

ViewPicture::ViewPicture(const ViewGl &gl) : gl(gl), reversed(hasClipControl(gl)) {
    sceneProgram = program(kSceneVertex, kSceneFragment, reversed);
    meanProgram = program(kShowVertex, kMeanFragment, false);
    showProgram = program(kShowVertex, kShowFragment, false);
    gl.glGenVertexArrays(3, arrays);
    gl.glGenBuffers(5, buffers);
    if (reversed) gl.glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl.glDepthFunc(reversed ? GL_GREATER : GL_LESS);
    gl.glPixelStorei(GL_PACK_ALIGNMENT, 1);
}

void ViewPicture::attribute(GLuint location, int count, GLenum type, size_t stride, size_t offset) const {
    if (type == GL_UNSIGNED_INT)
        gl.glVertexAttribIPointer(location, count, type, (GLsizei)stride, (void *)offset);
    else
        gl.glVertexAttribPointer(location, count, type, GL_TRUE, (GLsizei)stride, (void *)offset);
    gl.glEnableVertexAttribArray(location);
}

void ViewPicture::load(std::shared_ptr<const ViewMesh> to) {
    mesh = std::move(to);
    outlined = false;
    for (int lines : {kSurface, kOutline, kEdge}) {
        gl.glBindVertexArray(arrays[lines]);
        gl.glBindBuffer(GL_ARRAY_BUFFER, buffers[lines == kEdge ? kEdges : kPoints]);
        const auto &points = lines == kEdge ? mesh->edges : mesh->points;
        if (lines != kOutline)
            gl.glBufferData(GL_ARRAY_BUFFER, bytesOf(points), points.data(), GL_STATIC_DRAW);
        attribute(0, 3, GL_FLOAT, sizeof(ViewPoint), offsetof(ViewPoint, p));
        attribute(1, 4, GL_SHORT, sizeof(ViewPoint), offsetof(ViewPoint, n));
        attribute(2, 1, GL_UNSIGNED_INT, sizeof(ViewPoint), offsetof(ViewPoint, patch));
        if (lines == kEdge) continue;
        gl.glBindBuffer(GL_ARRAY_BUFFER, buffers[kLight]);
        attribute(3, 3, GL_FLOAT, sizeof(Rgb), 0);
        gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[lines == kOutline ? kOutlines : kTriangles]);
        if (lines == kSurface)
            gl.glBufferData(GL_ELEMENT_ARRAY_BUFFER, bytesOf(mesh->triangles), mesh->triangles.data(),
                            GL_STATIC_DRAW);
    }
}

void ViewPicture::relight(const std::vector<Rgb> &light) {
    gl.glBindBuffer(GL_ARRAY_BUFFER, buffers[kLight]);
    gl.glBufferData(GL_ARRAY_BUFFER, bytesOf(light), light.data(), GL_DYNAMIC_DRAW);
}

void ViewPicture::resize(Target &t, int width, int height, GLint colours, bool depth) {
    if (t.width == width && t.height == height) {
        gl.glBindFramebuffer(GL_FRAMEBUFFER, t.framebuffer);
        return;
    }
    if (t.framebuffer) gl.glDeleteFramebuffers(1, &t.framebuffer), gl.glDeleteTextures(1, &t.colour);
    if (t.depth) gl.glDeleteRenderbuffers(1, &t.depth);
    t = {0, 0, 0, width, height};
    gl.glGenFramebuffers(1, &t.framebuffer);
    gl.glBindFramebuffer(GL_FRAMEBUFFER, t.framebuffer);
    gl.glGenTextures(1, &t.colour);
    gl.glBindTexture(GL_TEXTURE_2D, t.colour);
    gl.glTexImage2D(GL_TEXTURE_2D, 0, colours, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, t.colour, 0);
    if (depth) {
        gl.glGenRenderbuffers(1, &t.depth);
        gl.glBindRenderbuffer(GL_RENDERBUFFER, t.depth);
        gl.glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, width, height);
        gl.glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, t.depth);
    }
    if (gl.glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error("OpenGL has no room for pictures of this size: try a smaller --size");
}

void ViewPicture::clear(float number) const {
    const GLfloat nothing[4] = {0, 0, 0, number}, far = reversed ? 0.f : 1.f;
    gl.glClearBufferfv(GL_COLOR, 0, nothing);
    gl.glClearBufferfv(GL_DEPTH, 0, &far);
}

void ViewPicture::drawMesh(const Vec3 &eye, const Vec3 &right, const Vec3 &up, const Vec3 &ahead, int lines,
                           bool backs) const {
    auto at = [&](const char *name) { return gl.glGetUniformLocation(sceneProgram, name); };
    gl.glUseProgram(sceneProgram);
    gl.glUniform3f(at("eye"), eye.x, eye.y, eye.z);
    gl.glUniform3f(at("right"), right.x, right.y, right.z);
    gl.glUniform3f(at("up"), up.x, up.y, up.z);
    gl.glUniform3f(at("ahead"), ahead.x, ahead.y, ahead.z);
    gl.glUniform1f(at("near"), mesh->size * (reversed ? 1e-6f : 1e-3f));
    gl.glUniform1i(at("lines"), lines);
    gl.glUniform1i(at("backs"), backs);
    gl.glEnable(GL_DEPTH_TEST);
    // Draw surfaces a little deeper, most of all steep ones, so that outlines stay in front
    gl.glEnable(GL_POLYGON_OFFSET_FILL);
    gl.glPolygonOffset(reversed ? -1.f : 1.f, 0);
    gl.glBindVertexArray(arrays[lines]);
    if (lines == kEdge)
        gl.glDrawArrays(GL_LINES, 0, (GLsizei)mesh->edges.size());
    else {
        const auto &order = lines == kOutline ? mesh->outlines : mesh->triangles;
        gl.glDrawElements(lines == kOutline ? GL_LINES : GL_TRIANGLES, (GLsizei)order.size(), GL_UNSIGNED_INT,
                          nullptr);
    }
    gl.glDisable(GL_POLYGON_OFFSET_FILL);
    gl.glDisable(GL_DEPTH_TEST);
}

void ViewPicture::draw(const RenderSettings &c, const ViewLayers &layers, int wanted) {
    for (samples = wanted; samples > 1; --samples)
        if ((size_t)(c.width * c.height) * (size_t)(samples * samples) <= kMostSamples) break;
    resize(scene, c.width * samples, c.height * samples, GL_RGBA32F, true);
    gl.glViewport(0, 0, scene.width, scene.height);
    clear(kViewNothing);
    if (!mesh) return;
    View v = lookAt(upright(c.eye, c.upIsZ), upright(c.target, c.upIsZ), 0, c.lens, c.width, c.height);
    auto axis = [&](const Vec3 &a, float scale) { return asInModel(a, c.upIsZ) * scale; };
    Vec3 right = axis(v.right, 2 / dot(v.right, v.right)), up = axis(v.down, -2 / dot(v.down, v.down)),
         ahead = axis(v.forward, 1);
    auto drawLayer = [&](int lines) { drawMesh(c.eye, right, up, ahead, lines, layers.backs); };
    if (!layers.wireframe || layers.patches) drawLayer(kSurface);
    if (layers.elements) {
        if (!outlined) {
            gl.glBindVertexArray(arrays[kOutline]);
            gl.glBufferData(GL_ELEMENT_ARRAY_BUFFER, bytesOf(mesh->outlines), mesh->outlines.data(),
                            GL_STATIC_DRAW);
            outlined = true;
        }
        drawLayer(kOutline);
    }
    if (layers.wireframe) drawLayer(kEdge);
}

void ViewPicture::drawHemicube(int patch, bool upIsZ) {
    int half = std::max(std::min(scene.width, scene.height) / samples / 8, 8), px = 2 * half;
    resize(hemicube, 2 * px, 2 * px, GL_RGBA32F, true);
    clear(kViewFrame);
    const ViewPatch &at = mesh->patches[(size_t)patch - 1];
    // Take the model's up, or -z on floors and ceilings
    Vec3 up = asInModel({0, 1, 0}, upIsZ), n = at.n;
    if (std::fabs(dot(up, n)) > 0.99f) up = asInModel({0, 0, -1}, upIsZ);
    Vec3 right = normalize(cross(n, up));
    up = cross(right, n);
    const Vec3 none = {}, faces[5][3] = {{n, right, up}, // each face's direction, right and up; the top first
                                         {right, none - n, up},
                                         {none - right, n, up},
                                         {up, right, none - n},
                                         {none - up, right, n}};
    const int corner[5][2] = {
        {half, half}, {half + px, half}, {half - px, half}, {half, half + px}, {half, half - px}};
    gl.glEnable(GL_SCISSOR_TEST);
    for (int i = 0; i < 5; ++i) {
        int x = std::max(corner[i][0], 0), y = std::max(corner[i][1], 0);
        gl.glScissor(x, y, std::min(corner[i][0] + px, 2 * px) - x, std::min(corner[i][1] + px, 2 * px) - y);
        gl.glViewport(corner[i][0], corner[i][1], px, px);
        clear(kViewNothing);
        drawMesh(at.p, faces[i][1], faces[i][2], faces[i][0], kSurface, true);
    }
    gl.glDisable(GL_SCISSOR_TEST);
}

} // namespace odraz::radiosity
