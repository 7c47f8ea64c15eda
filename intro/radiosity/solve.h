// The radiosity system B = rho (D + F B), for many right-hand sides at once.
//
// D is direct light and F B the reflected light that arrives, both as irradiance / pi. The method is
// Gauss-Seidel: sweeps over all patches use every new value at once, until a sweep changes less than
// `residual`, as a share of the light of the sources. Right-hand sides are independent, so the result does
// not depend on how threads share them.
#pragma once

#include "radiosity/direct.h"
#include "radiosity/form_factor.h"

namespace odraz {

// The unknowns of a patch: red, green and blue of each basis, in blocks of kSolveBlock, padded with zeros.
inline constexpr int kSolveBlock = 16;

struct System {
    const FormFactors *factors;
    int patches, columns; // columns: a multiple of kSolveBlock
    float *reflectance;   // [patches][columns]
    float *direct;        // [patches][columns], D
    float *radiosity;     // [patches][columns], B: reflected light, as radiance
    float *indirect; // [patches][columns], F B, from findIndirect(); solve() keeps each block's values in it,
                     // close together
};

// Takes the memory, all zero; false when the arena is full.
bool makeSystem(System &system, Arena &arena, const FormFactors &factors, int patches, int unknowns);

// Solves, in at most this number of sweeps.
void solve(System &system, Workers &workers, float residual, int most);

// Indirect light F B, from radiosities B of `columns` columns.
void findIndirect(const FormFactors &factors, int patches, int columns, const float *radiosity,
                  float *indirect, Workers &workers);
inline void findIndirect(System &s, Workers &workers) {
    findIndirect(*s.factors, s.patches, s.columns, s.radiosity, s.indirect, workers);
}

// Gives patches without a known row the mean of their neighbours on the same chart. `values` is as for
// findIndirect(). The `count` patches from `first` on must make up whole charts.
void fillPatches(const Model &model, const FormFactors &factors, int columns, float *values, int first,
                 int count);

} // namespace odraz
