// The functions of OpenGL 3.3 that we use, as a table; the host fills it. Windows need only blits.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

namespace odraz {

// clang-format off
#define ODRAZ_GL(F) \
    F(glGetError) F(glClearColor) F(glClear) F(glGenTextures) F(glBindTexture) F(glTexImage2D) \
    F(glTexSubImage2D) F(glTexParameteri) F(glGenFramebuffers) F(glBindFramebuffer) \
    F(glFramebufferTexture2D) F(glCheckFramebufferStatus) F(glBlitFramebuffer) F(glReadPixels)
// clang-format on

struct Gl {
#define ODRAZ_GL_MEMBER(name) decltype(&::name) name;
    ODRAZ_GL(ODRAZ_GL_MEMBER)
#undef ODRAZ_GL_MEMBER
};

} // namespace odraz
