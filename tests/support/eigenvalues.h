// Eigenvalues in double precision, by Eigen: a reference for the engine's own decompositions.
#pragma once

// The squared distance of rows from the best affine subspace of this number of dimensions: the sum of the
// remaining eigenvalues of the Gram matrix of columns, or of rows if there are fewer.
double besideBestSubspace(const float *values, int rows, int columns, int dimensions);
