// `radiosity view` in a build without GLFW.
#include "tools/common/command_line.h"

namespace odraz::radiosity {

int runView(common::CommandLine &) {
    throw std::runtime_error("view was left out of this build: install GLFW (libglfw3-dev) and build again");
}

} // namespace odraz::radiosity
