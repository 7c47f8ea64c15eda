// Eigenvalues in double precision, by Eigen: what the engine's own decompositions are measured against.
#pragma once

#include <vector>

// Of the symmetric matrix n x n, ascending.
std::vector<double> eigenvalues(int n, const std::vector<double> &symmetric);
