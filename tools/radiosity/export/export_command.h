// radiosity export: a solution as a file or a folder for other programs.
#pragma once

#include "tools/common/arguments.h"

namespace odraz::radiosity {

int runExport(common::Arguments &words);

} // namespace odraz::radiosity
