// OpenGL that rounds vertices before it draws triangles, as GPUs do: to 1/256 of a pixel, software WebGL to
// 1/16. Software OpenGL rounds nothing.
#pragma once

#include "radiosity/hemicube.h"

#include <cmath>

namespace odraz {

// While it exists, hemicubes draw with vertices that are rounded to multiples of `unit` pixels. A vertex
// begins with x, y, z and w.
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

} // namespace odraz
