// Draws into the window by OpenGL, on any system.
#include "host/window.h"

#include "host/clock.h"
#include "host/process.h"

namespace odraz {

Viewport viewportOf(const FilmWindow &window, int width, int height) {
    int fullWidth = __atomic_load_n(&window.width, __ATOMIC_RELAXED),
        fullHeight = __atomic_load_n(&window.height, __ATOMIC_RELAXED);
    int64_t fitWidth = (int64_t)fullHeight * width / height, fitHeight = (int64_t)fullWidth * height / width;
    bool fits = fitWidth < fullWidth;
    int w = fits ? (int)fitWidth : fullWidth, h = fits ? fullHeight : (int)fitHeight;
    return {(fullWidth - w) / 2, (fullHeight - h) / 2, w, h};
}

int press(FilmWindow &window, const uint16_t keys[kActions], uint64_t key) {
    int action = 0;
    while (action < kActions && keys[action] != key) ++action;
    if (action <= kAhead) __atomic_add_fetch(&window.presses[action], 1, __ATOMIC_RELAXED);
    return action;
}

void leave(const FilmWindow &window, int *left) {
    if (window.stats && !window.picture) printError("no picture was shown: left while loading");
    __atomic_store_n(left, 1, __ATOMIC_RELAXED);
    // Let the film end by itself if it can, but do not wait long for a slow driver
    sleepFor(80000000);
    endProcess(0);
}

// Draws a bar in the film's orange, at a brightness from 0 (black) over 1 to 4 (white). (x, y) is its lower
// left corner.
static void drawBar(const Gl &gl, int x, int y, int width, int height, float bright) {
    gl.glEnable(GL_SCISSOR_TEST);
    gl.glScissor(x, y, width, height);
    gl.glClearColor(0.8f * bright, 0.42f * bright, 0.24f * bright, 1);
    gl.glClear(GL_COLOR_BUFFER_BIT);
    gl.glDisable(GL_SCISSOR_TEST);
}

void present(FilmWindow &window, const uint8_t *rgba, int width, int height) {
    const Gl &gl = window.gl;
    if (!window.picture) {
        // Make a texture for the picture, and a framebuffer to read it. An unsized format lets the driver
        // store the texture in the byte order of the window. A picture as large as the window is then
        // copied, not drawn: 1.2 ms of processor time instead of 9.2 with software OpenGL
        gl.glGenTextures(1, &window.picture);
        gl.glBindTexture(GL_TEXTURE_2D, window.picture);
        gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV,
                        nullptr);
        gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
        gl.glGenFramebuffers(1, &window.framebuffer);
        gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, window.framebuffer);
        gl.glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, window.picture,
                                  0);
        gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0); // solving the hall may have failed in another one
    }
    if (rgba) gl.glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba);

    // Clear the border, and flip the picture: its first row is the top, but OpenGL's is the bottom
    Viewport to = viewportOf(window, width, height);
    for (int i = 0; i < 2; ++i) {
        if (to.width < window.width || to.height < window.height)
            drawBar(gl, 0, 0, window.width, window.height, 0);
        gl.glBlitFramebuffer(0, 0, width, height, to.x, to.y + to.height, to.x + to.width, to.y,
                             GL_COLOR_BUFFER_BIT,
                             to.width == width && to.height == height ? GL_NEAREST : GL_LINEAR);
        if (!gl.glGetError()) break;
        // OpenGL cannot scale into a window that the driver multisamples: show the picture's own size
        to = {(window.width - width) / 2, (window.height - height) / 2, width, height};
    }
    if (isOn(window, kPause)) {
        int unit = (window.width < window.height ? window.width : window.height) / 100 + 1;
        drawBar(gl, 6 * unit, 3 * unit, 5 * unit, 5 * unit, 0);
        for (int x = 7; x <= 9; x += 2) drawBar(gl, x * unit, 4 * unit, unit, 3 * unit, 4);
    }
    swapBuffers(window);
}

void showLoading(float done, void *context) {
    FilmWindow &window = *(FilmWindow *)context;
    int64_t now = nanoseconds();
    if (done < 1 && now - window.loadingShown < 33000000) return;
    window.loadingShown = now;
    // Draw a bar in the middle, two fifths as wide as the window
    const Gl &gl = window.gl;
    int width = __atomic_load_n(&window.width, __ATOMIC_RELAXED),
        height = __atomic_load_n(&window.height, __ATOMIC_RELAXED);
    int full = width * 2 / 5, thick = height / 240 + 1;
    gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    int x = (width - full) / 2, y = (height - thick) / 2;
    drawBar(gl, 0, 0, width, height, 0);
    drawBar(gl, x, y, full, thick, 0.12f);
    drawBar(gl, x, y, (int)((float)full * done), thick, 1);
    swapBuffers(window);
}

} // namespace odraz
