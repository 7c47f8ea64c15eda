// Eigenvalues in double precision, by Eigen: a reference for the engine's own decompositions.
#pragma once

#include <vector>

// The eigenvalues of a symmetric n x n matrix, ascending.
std::vector<double> eigenvalues(int n, const std::vector<double> &symmetric);
