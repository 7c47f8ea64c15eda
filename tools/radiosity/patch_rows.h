// Rows of patches while a model is solved: found, kept now and then, and taken up again.
#pragma once

#include "tools/radiosity/bake.h"

namespace odraz {

// Fills b.radiosity.factors, from what was kept on (b.settings.resumed). b.whole tells whether it was not
// stopped before it had all, b.rows how many there are. Sets workers.abort, and back.
void findPatchRows(Bake &b, const Gl &gl, Workers &workers, const int *stop, const Told &told);

// Hands the rows that there are to who keeps them.
void keepPatchRows(const Bake &b);

} // namespace odraz
