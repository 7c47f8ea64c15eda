// The radiosity system B = rho (D + F B), for many right-hand sides at once.
//
// D is direct light and F B the reflected light that arrives, both as irradiance / pi. The method is
// Gauss-Seidel: sweeps over all patches use each new value immediately. They end when a sweep changes less
// than `residual`, as a share of the sources' light. Right-hand sides are independent, so the result does not
// depend on the distribution over threads.
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
    float *indirect;      // [patches][columns], F B, from findIndirect(); solve() uses it as scratch memory
};

// Allocates the arrays, all zero. Returns false if the arena is full.
bool makeSystem(System &system, Arena &arena, const FormFactors &factors, int patches, int unknowns);

// Solves in at most `most` sweeps.
void solve(System &system, Workers &workers, float residual, int most);

// Computes the indirect light F B from radiosities B of `columns` columns.
void findIndirect(const FormFactors &factors, int patches, int columns, const float *radiosity,
                  float *indirect, Workers &workers);
inline void findIndirect(System &s, Workers &workers) {
    findIndirect(*s.factors, s.patches, s.columns, s.radiosity, s.indirect, workers);
}

// Gives patches without a known row the mean of their neighbours on the same chart, and a row of one of them.
// `values`: [count][columns], for `count` patches from `first` on, which must be whole charts.
void fillPatches(const Model &model, const FormFactors &factors, int columns, float *values, int first,
                 int count);

} // namespace odraz
