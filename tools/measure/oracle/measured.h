// Generated models as meshes for measuring radiosity, and their references.
#pragma once

#include "tools/measure/oracle/reference.h"

namespace odraz {

// A model of generateObj(), written to a file and read back, as users do. Also knows "cave": a hollow of
// triangles, no two of them in one plane, some of which emit light. `area` applies to all kinds. Throws
// std::runtime_error.
radiosity::Mesh generatedMesh(const std::string &kind, double area);

// Probes with the light of a converged solution: many small patches, with form factors by rays.
std::vector<Probe> referenceOf(const radiosity::Mesh &mesh, const Gl &gl, Workers &workers, int probes,
                               bool quick);

} // namespace odraz
