// radiosity export: a solution as a file or a folder for other programs.
#pragma once

#include "tools/common/command_line.h"

namespace odraz::radiosity {

int runExport(common::CommandLine &line);

} // namespace odraz::radiosity
