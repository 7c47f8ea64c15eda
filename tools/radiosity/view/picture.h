// Draws a solved model with OpenGL: the scene (linear light, patch numbers), then the tone-mapped picture.
#pragma once

#include "tools/picture/picture.h"
#include "tools/radiosity/export/render.h"
#include "tools/radiosity/view/gl.h"
#include "tools/radiosity/view/help.h"
#include "tools/radiosity/view/mesh.h"
#include "trace/rays/view.h"

namespace odraz::radiosity {

struct ViewLayers {
    bool patches = false, elements = false, wireframe = false, hemicube = false, backs = false;
};

// The layers in the order of their keys. `name` is the value of --layer.
struct ViewLayer {
    const char *name;
    bool ViewLayers::*shown;
};
inline constexpr ViewLayer kViewLayers[] = {{"patches", &ViewLayers::patches},
                                            {"elements", &ViewLayers::elements},
                                            {"wireframe", &ViewLayers::wireframe},
                                            {"hemicube", &ViewLayers::hemicube},
                                            {"backs", &ViewLayers::backs}};

// The tone mapping of `render`, adapted to the picture.
struct ViewTone {
    bool logarithmic = false;
    float exposure = 1, low = 0, high = 1; // low and high are logarithms
};

class ViewPicture {
public:
    explicit ViewPicture(const ViewGl &gl); // `gl`: current context. Throws std::runtime_error
    void load(std::shared_ptr<const ViewMesh> mesh);
    void relight(const std::vector<Rgb> &light);

    // Draws the scene with `samples` along a pixel's side, or fewer if the picture would be too large.
    void draw(const RenderSettings &camera, const ViewLayers &layers, int samples);
    // Finds the tone, without stops, from at most `most` x `most` pixels. Returns false if there is no light.
    bool measure(int most, ViewTone &tone);
    // The number of the patch at a pixel, from 1 on; 0: none.
    int patchAt(int x, int y) const;
    // Draws the unfolded view from the patch's hemicube.
    void drawHemicube(int patch, bool upIsZ);
    // Combines the scene and the hemicube into the picture, and shows it in the upper left corner of the
    // window. Draws help over it if there are any `keys`.
    void show(const ViewTone &tone, const ViewLayers &layers, int patch, int windowHeight,
              std::span<const ViewKey> keys);
    pictures::Image read() const;

private:
    struct Target { // a framebuffer with a texture, and perhaps depth
        GLuint framebuffer = 0, colour = 0, depth = 0;
        int width = 0, height = 0;
    };
    void resize(Target &target, int width, int height, GLint colours, bool depth);
    void drawMesh(const Vec3 &eye, const Vec3 &right, const Vec3 &up, const Vec3 &ahead, int lines,
                  bool backs) const;
    void clear(float number) const;
    void drawHelp(std::span<const ViewKey> keys, int width, int height);
    GLuint program(const char *vertex, const char *fragment, bool reversed);
    void attribute(GLuint location, int count, GLenum type, size_t stride, size_t offset) const;

    ViewGl gl;
    bool reversed;
    GLuint sceneProgram, meanProgram, showProgram, arrays[3], buffers[5];
    std::shared_ptr<const ViewMesh> mesh;
    bool outlined = false; // the buffer of outlines is filled
    Target scene, hemicube, small, final, help;
    int helpSize[2] = {}; // the picture's size when `help` was drawn
    int samples = 1;
};

} // namespace odraz::radiosity
