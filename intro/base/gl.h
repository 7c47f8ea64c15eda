// The functions of OpenGL 3.3 that we use, as a table. The host fills it.
//
// On Windows each entry is code that converts the calling convention and calls Windows's function. So no
// function here may have a float after an integer: the two conventions pass it in different registers.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

namespace odraz {

// clang-format off
#define ODRAZ_GL(F) \
    F(glClearColor) F(glClear) F(glGenTextures) F(glBindTexture) F(glTexImage2D) \
    F(glTexSubImage2D) F(glTexParameteri) F(glGenFramebuffers) F(glBindFramebuffer) \
    F(glFramebufferTexture2D) F(glBlitFramebuffer) F(glGetError) F(glReadPixels) \
    F(glGetString) F(glGenRenderbuffers) F(glBindRenderbuffer) F(glRenderbufferStorage) \
    F(glFramebufferRenderbuffer) F(glCreateProgram) F(glCreateShader) F(glShaderSource) F(glCompileShader) \
    F(glAttachShader) F(glLinkProgram) F(glUseProgram) \
    F(glGenVertexArrays) F(glBindVertexArray) F(glGenBuffers) F(glBindBuffer) \
    F(glBufferData) F(glVertexAttribPointer) F(glEnableVertexAttribArray) \
    F(glViewport) F(glEnable) F(glDisable) F(glDepthFunc) F(glClearBufferiv) \
    F(glClearBufferfv) F(glDrawArrays) F(glScissor) F(glDeleteFramebuffers) F(glDeleteRenderbuffers) \
    F(glDeleteBuffers) F(glDeleteShader) F(glDeleteProgram) F(glDeleteVertexArrays)
// clang-format on

struct Gl {
#define ODRAZ_GL_MEMBER(name) decltype(&::name) name;
    ODRAZ_GL(ODRAZ_GL_MEMBER)
#undef ODRAZ_GL_MEMBER
};

} // namespace odraz
