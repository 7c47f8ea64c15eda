// `radiosity view` where there was no GLFW to build it with.
#include "tools/radiosity/view_command.h"

namespace odraz {

int runView(Arguments &) {
    throw std::runtime_error("view was left out of this build: install GLFW (libglfw3-dev) and build again");
}

} // namespace odraz
