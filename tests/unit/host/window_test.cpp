// Tests how pictures are shown in a window, with an OpenGL that only records blits.
#include "host/window.h"

// Defined here instead of by the system's window
namespace odraz {
struct WindowState {
    int shown;
};
void swapBuffers(FilmWindow &window) { ++window.state->shown; }
} // namespace odraz

using namespace odraz;

struct Blit {
    int x0, y0, x1, y1;
    GLenum filter;
    bool operator==(const Blit &) const = default;
};
static std::vector<Blit> blits;
static bool multisampled;
static GLenum error;

// Like the driver, refuses to scale into a multisampled window.
static void blit(GLint, GLint, GLint width, GLint height, GLint x0, GLint y0, GLint x1, GLint y1, GLbitfield,
                 GLenum filter) {
    bool scales = x1 - x0 != width || y0 - y1 != height;
    if (multisampled && scales)
        error = GL_INVALID_OPERATION;
    else
        blits.push_back({x0, y0, x1, y1, filter});
}

// Shows a picture of 64x36 in a window of this size, twice; returns what was drawn the second time.
static std::vector<Blit> shown(int width, int height) {
    WindowState state = {};
    FilmWindow window = {};
    window.state = &state;
    window.width = width, window.height = height;
    Gl &gl = window.gl;
    gl.glGenTextures = gl.glGenFramebuffers = [](GLsizei, GLuint *name) { *name = 1; };
    gl.glBindTexture = gl.glBindFramebuffer = [](GLenum, GLuint) {};
    gl.glTexImage2D = [](GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum, const void *) {};
    gl.glTexSubImage2D = [](GLenum, GLint, GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, const void *) {};
    gl.glTexParameteri = [](GLenum, GLenum, GLint) {};
    gl.glFramebufferTexture2D = [](GLenum, GLenum, GLenum, GLuint, GLint) {};
    gl.glClearColor = [](GLfloat, GLfloat, GLfloat, GLfloat) {};
    gl.glClear = [](GLbitfield) {};
    gl.glEnable = gl.glDisable = [](GLenum) {};
    gl.glScissor = [](GLint, GLint, GLsizei, GLsizei) {};
    gl.glBlitFramebuffer = blit;
    gl.glGetError = [] { return std::exchange(error, (GLenum)GL_NO_ERROR); };
    for (int i = 0; i < 2; ++i) {
        blits.clear();
        present(window, nullptr, 64, 36);
    }
    EXPECT_EQ(state.shown, 2);
    return blits;
}

TEST(Present, ScalesThePictureToTheWindow) {
    multisampled = false;
    EXPECT_EQ(shown(64, 36), (std::vector<Blit>{{0, 36, 64, 0, GL_NEAREST}}));
    EXPECT_EQ(shown(128, 90), (std::vector<Blit>{{0, 81, 128, 9, GL_LINEAR}}));
}

// A driver that is set to multisample all windows refuses to scale into them. The picture is then shown as
// large as it is, in the middle.
TEST(Present, ShowsThePictureUnscaledInAMultisampledWindow) {
    multisampled = true;
    EXPECT_EQ(shown(64, 36), (std::vector<Blit>{{0, 36, 64, 0, GL_NEAREST}}));
    EXPECT_EQ(shown(128, 90), (std::vector<Blit>{{32, 63, 96, 27, GL_NEAREST}}));
    EXPECT_EQ(shown(32, 20), (std::vector<Blit>{{-16, 28, 48, -8, GL_NEAREST}}));
}
