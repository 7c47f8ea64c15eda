// Models of many small polygons, with curved walls, many small objects, and objects that touch.
#pragma once

#include "tools/radiosity/generate/obj_writer.h"

namespace odraz::radiosity {

// A nave under a barrel vault with two rows of columns, arched windows to the sky, cloths, and vases, balls
// and rings on the floor: 30,000 triangles, or the number that follows from ObjWriter::area. It has no lamp.
void makeVault(ObjWriter &w);

// A closed room with a lamp. Its floor is hilly, with boulders.
void makeTerrain(ObjWriter &w);

} // namespace odraz::radiosity
