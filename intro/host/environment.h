// Errors whose cause may be a variable of the environment. Only on Linux.
#pragma once

namespace odraz {

// `texts` is a list, as in library.h: WHAT is missing, a FAULT, the names of variables, an empty text, what
// TO DO. Returns "WHAT: NAME is VALUE FAULT" for the first of these variables that is set, else "WHAT: TO
// DO". `only`: null, or what was found instead. The line is valid until the next call.
const char *causeOf(const char *texts, const char *only);

// Variables that lower OpenGL's version: all, and those that concern EGL.
#define ODRAZ_LOWERS_GL "\0: unset it\0LIBGL_ALWAYS_INDIRECT" ODRAZ_LOWERS_MESA
#define ODRAZ_LOWERS_EGL "\0: unset it" ODRAZ_LOWERS_MESA
#define ODRAZ_LOWERS_MESA "\0MESA_GL_VERSION_OVERRIDE\0MESA_GLSL_VERSION_OVERRIDE\0\0"

} // namespace odraz
