#include "base/for_tools.h"

namespace odraz {

extern const bool kForTools [[gnu::weak]]; // main.cpp has another
const bool kForTools = true;

} // namespace odraz
