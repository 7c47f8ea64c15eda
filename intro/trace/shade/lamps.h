// Lamps in mirrors and through glass: balls that shine, as large as a sample at least.
//
// The picture of a lamp in a ball is smaller than samples are apart, and many times white: met by one sample
// here and by none there, it blinks. So secondary rays do not meet lamps but pass them: a lamp is seen as far
// as its picture, widened by what a sample covers, reaches, and paler in proportion.
#pragma once

#include "trace/shade/run.h"

namespace odraz {

// Adds the lamps before what all rays of a stream have met. (Their bodies add nothing, see contribute.cpp.)
void addLamps(const Context &c, const RayStream &in);

} // namespace odraz
