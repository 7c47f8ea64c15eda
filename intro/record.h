// What odraz-debug --shown does: the film as odraz plays it, and a list of what was shown.
#pragma once

#include "options.h"

namespace odraz {

// Plays the film in a window with the player of odraz, from options.from to options.to, and writes a CSV
// ("at,time,kind,level,width,height", as tools/measure/seen/shown.h reads it) to a path or "-". What was made
// but not shown when the viewer left is not in it. Returns an exit status; what is wrong is reported in one
// line.
int recordShown(const Options &options, const char *to);

} // namespace odraz
