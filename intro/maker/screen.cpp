#include "maker/screen.h"

#include "film.h"
#include "host/process.h"

namespace odraz::maker {

const char *open(Screen &s, int width, int height) {
    Quiet libraries;
    const char *wrong = openGlfwWindow(s.window, width, height, FILM_NAME "-debug", s.gl);
    if (wrong) return wrong;
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    s.hidden = glfwCreateWindow(16, 16, "", nullptr, nullptr);
    if (!s.hidden) return "no second window on this display";
    s.width = width;
    s.height = height;
    // Make the texture and the framebuffer for show()
    s.gl.glBindFramebuffer(GL_FRAMEBUFFER, 0);
    s.gl.glGenTextures(1, &s.texture);
    s.gl.glBindTexture(GL_TEXTURE_2D, s.texture);
    s.gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, s.width, s.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    s.gl.glGenFramebuffers(1, &s.framebuffer);
    s.gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, s.framebuffer);
    s.gl.glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, s.texture, 0);
    return nullptr;
}

void show(Screen &s, const Picture &p) {
    int w, h;
    glfwGetFramebufferSize(s.window, &w, &h);
    s.gl.glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, s.width, s.height, GL_RGBA, GL_UNSIGNED_BYTE, p.rgba);
    s.gl.glBlitFramebuffer(0, 0, s.width, s.height, 0, h, w, 0, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glfwSwapBuffers(s.window);
}

} // namespace odraz::maker
