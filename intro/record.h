// odraz-debug --shown: plays the film as odraz does, and lists the pictures that were shown.
#pragma once

#include "options.h"

namespace odraz {

// Plays the film in a window with the player of odraz, from options.from to options.to, and writes a CSV
// ("at,time,kind,level,width,height,seconds", as tools/measure/play/shown.h reads it) to a path or "-".
// Pictures that were not shown yet when the viewer left are not in it. Returns an exit status; prints errors.
int recordShown(const Options &options, const char *to);

} // namespace odraz
