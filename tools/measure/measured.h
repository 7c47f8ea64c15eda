// What radiosity is measured on: generated models as meshes, and their references.
#pragma once

#include "tools/measure/reference.h"

namespace odraz {

// A model of generateObj(), read back from a file: what is measured is what users read. Also "cave": a hollow
// of triangles of which no two lie in one plane, lit by some of them; `area` counts for all kinds. Throws
// std::runtime_error.
Mesh generatedMesh(const std::string &kind, double area);

// Probes and what a converged solution has there: form factors by rays, of many small patches.
std::vector<Probe> referenceOf(const Mesh &mesh, const Gl &gl, Workers &workers, int probes, bool quick);

} // namespace odraz
