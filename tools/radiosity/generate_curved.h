// Models of many small planes, for what boxes do not show: curved walls, clutter, things that touch.
#pragma once

#include "tools/radiosity/obj_writer.h"

namespace odraz {

// A nave under a barrel vault with two rows of columns, arched windows to the sky, cloths, and vases, balls
// and rings that lie about: 30,000 triangles, or as many as the area of the smaller ones asks for. Nothing
// shines in it.
void makeVault(ObjWriter &w);

// A closed room with a floor of hills and boulders on it, and a lamp: likewise.
void makeTerrain(ObjWriter &w);

} // namespace odraz
