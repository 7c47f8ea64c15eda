// Makes the picture from the drawn scene: measures its light, tone-maps it, and reads it back.
#include "tools/radiosity/view/picture.h"

#include "tools/common/statistics.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

bool ViewPicture::measure(int most, ViewTone &tone) {
    int across = scene.width / samples, down = scene.height / samples, width = std::min(across, most),
        height = std::min(down, most);
    resize(small, width, height, GL_RGBA32F, false);
    gl.glViewport(0, 0, width, height);
    gl.glUseProgram(meanProgram);
    gl.glUniform1i(gl.glGetUniformLocation(meanProgram, "samples"), samples);
    gl.glUniform2f(gl.glGetUniformLocation(meanProgram, "step"), (float)across / (float)width,
                   (float)down / (float)height);
    gl.glBindVertexArray(arrays[0]);
    gl.glBindTexture(GL_TEXTURE_2D, scene.colour);
    gl.glDrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<float> pixels((size_t)(width * height) * 4), all;
    gl.glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, pixels.data());
    for (size_t i = 0; i < pixels.size(); i += 4) {
        float light = std::max({pixels[i], pixels[i + 1], pixels[i + 2]});
        if (light > 0) all.push_back(light);
    }
    if (all.empty()) return false;
    auto part = [&](double share) { return std::max(common::quantile(all, share), 1e-30f); };
    tone.exposure = 0.5f / part(0.6);
    tone.low = std::log(part(0.01)), tone.high = std::log(part(0.998));
    return true;
}

int ViewPicture::patchAt(int x, int y) const {
    if (x < 0 || y < 0 || x * samples >= scene.width || y * samples >= scene.height) return 0;
    float pixel[4];
    gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, scene.framebuffer);
    gl.glReadPixels(x * samples + samples / 2, scene.height - 1 - y * samples - samples / 2, 1, 1, GL_RGBA,
                    GL_FLOAT, pixel);
    int patch = (int)std::fabs(pixel[3]);
    return mesh && patch <= (int)mesh->patches.size() ? patch : 0;
}

void ViewPicture::show(const ViewTone &tone, const ViewLayers &layers, int patch, int windowHeight,
                       std::span<const ViewKey> keys) {
    int width = scene.width / samples, height = scene.height / samples;
    resize(final, width, height, GL_RGBA8, false);
    auto at = [&](const char *name) { return gl.glGetUniformLocation(showProgram, name); };
    gl.glUseProgram(showProgram);
    gl.glBindVertexArray(arrays[0]);
    gl.glUniform1i(at("scene"), 0);
    gl.glUniform1i(at("logarithmic"), tone.logarithmic);
    gl.glUniform1i(at("patches"), layers.patches);
    gl.glUniform1f(at("exposure"), tone.exposure);
    gl.glUniform2f(at("range"), tone.low, tone.high);
    auto pass = [&](const Target &from, int x, int y, int each, int marked) {
        gl.glViewport(x, y, from.width / each, from.height / each);
        gl.glUniform1i(at("samples"), each);
        gl.glUniform1f(at("marked"), marked ? (float)marked : -1.f);
        gl.glUniform2f(at("corner"), (float)x, (float)y);
        gl.glBindTexture(GL_TEXTURE_2D, from.colour);
        gl.glDrawArrays(GL_TRIANGLES, 0, 3);
    };
    pass(scene, 0, 0, samples, layers.hemicube ? patch : 0);
    if (layers.hemicube && patch)
        pass(hemicube, width - hemicube.width - 8, std::min(8, height - hemicube.height), 1, 0);
    if (!keys.empty()) drawHelp(keys, width, height);
    gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, final.framebuffer);
    gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl.glBlitFramebuffer(0, 0, width, height, 0, windowHeight - height, width, windowHeight,
                         GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

// Copies the help to the upper left corner of the picture. Draws it only when the picture's size has changed.
void ViewPicture::drawHelp(std::span<const ViewKey> all, int width, int height) {
    static constexpr int kBorder = 8;
    if (width <= 2 * kBorder || height <= 2 * kBorder) return;
    if (helpSize[0] != width || helpSize[1] != height) {
        pictures::Image keys = viewHelp(all, width - 2 * kBorder, height - 2 * kBorder);
        resize(help, keys.width, keys.height, GL_RGBA8, false);
        gl.glBindTexture(GL_TEXTURE_2D, help.colour);
        gl.glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        gl.glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, keys.width, keys.height, GL_RGB, GL_UNSIGNED_BYTE,
                           keys.rgb.data());
        helpSize[0] = width, helpSize[1] = height;
    }
    gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, help.framebuffer);
    gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, final.framebuffer);
    int top = height - kBorder;
    gl.glBlitFramebuffer(0, help.height, help.width, 0, kBorder, top - help.height, kBorder + help.width, top,
                         GL_COLOR_BUFFER_BIT, GL_NEAREST); // the first row is the lowest in OpenGL
}

pictures::Image ViewPicture::read() const {
    pictures::Image p = {final.width, final.height, {}};
    size_t row = (size_t)p.width * 3;
    p.rgb.resize(row * (size_t)p.height);
    gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, final.framebuffer);
    gl.glReadPixels(0, 0, p.width, p.height, GL_RGB, GL_UNSIGNED_BYTE, p.rgb.data());
    for (size_t y = 0; y < (size_t)p.height / 2; ++y)
        std::swap_ranges(&p.rgb[y * row], &p.rgb[y * row] + row, &p.rgb[((size_t)p.height - 1 - y) * row]);
    return p;
}

} // namespace odraz::radiosity
