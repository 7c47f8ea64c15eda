// OpenGL as the page provides it: the functions that hemicubes use, imported from gl.js.
#pragma once

#include "base/gl.h"

namespace odraz {

// clang-format off
#define ODRAZ_WEB_GL(F) \
    F(glGenFramebuffers) F(glBindFramebuffer) F(glCheckFramebufferStatus) F(glReadPixels) \
    F(glGenRenderbuffers) F(glBindRenderbuffer) F(glRenderbufferStorage) F(glFramebufferRenderbuffer) \
    F(glCreateProgram) F(glCreateShader) F(glShaderSource) F(glCompileShader) F(glAttachShader) F(glLinkProgram) \
    F(glGetProgramiv) F(glUseProgram) F(glGetUniformLocation) F(glUniform1fv) F(glGenVertexArrays) \
    F(glBindVertexArray) F(glGenBuffers) F(glBindBuffer) F(glBufferData) F(glVertexAttribPointer) \
    F(glVertexAttribIPointer) F(glEnableVertexAttribArray) F(glViewport) F(glEnable) F(glDisable) F(glDepthFunc) \
    F(glClearBufferuiv) F(glClearBufferfv) F(glDrawArrays)
// clang-format on

inline void fillGl(Gl &gl) {
    gl = {};
#define ODRAZ_WEB_ASSIGN(name) gl.name = ::name;
    ODRAZ_WEB_GL(ODRAZ_WEB_ASSIGN)
#undef ODRAZ_WEB_ASSIGN
    // Nothing need be deleted: the worker that solves is terminated afterwards
    gl.glDeleteFramebuffers = gl.glDeleteRenderbuffers = gl.glDeleteBuffers =
        gl.glDeleteVertexArrays = [](GLsizei, const GLuint *) {};
    gl.glDeleteShader = gl.glDeleteProgram = [](GLuint) {};
}

} // namespace odraz
