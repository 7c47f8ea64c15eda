// The radiosity system B = rho (D + F B), for many right-hand sides at once.
//
// D is direct light and F B the light that comes by reflection, both as irradiance / pi. Solved by
// Gauss-Seidel: one sweep after the other over all patches, every new value used at once, until what a sweep
// changes is less than the residual asked, as a share of what the sources put in. Right-hand sides do not
// touch each other, so the result does not depend on how they are shared out to threads.
#pragma once

#include "radiosity/direct.h"
#include "radiosity/form_factor.h"

namespace odraz {

// The unknowns of a patch: red, green and blue of each basis, in blocks of kSolveBlock, those missing zero.
inline constexpr int kSolveBlock = 16;

struct System {
    const FormFactors *factors;
    int patches, columns; // columns: a multiple of kSolveBlock
    float *reflectance;   // [patches][columns]
    float *direct;        // [patches][columns], D
    float *radiosity;     // [patches][columns], B: reflected light, as radiance
    float *gathered;      // [patches][columns], F B, once gathered; solve() keeps each block's values in it,
                          // close together
};

// Takes the memory, all zero; false when the arena is full.
bool makeSystem(System &system, Arena &arena, const FormFactors &factors, int patches, int unknowns);

// Solves; returns the number of sweeps, `most` where that was not enough. `told` hears what residual each of
// the first right-hand sides' sweeps left.
int solve(System &system, Workers &workers, float residual, int most, const Progress &told = {});

// One bounce, of as many as are wanted, in place of solve().
void bounce(System &system, Workers &workers);

// From radiosities B of `columns` columns, F B.
void gather(const FormFactors &factors, int patches, int columns, const float *radiosity, float *gathered,
            Workers &workers);
inline void gather(System &s, Workers &workers) {
    gather(*s.factors, s.patches, s.columns, s.radiosity, s.gathered, workers);
}

// Gives patches whose rows are not known the mean of those around them on their charts; `values` as for
// gather(), of `count` patches from `first` on, whole charts.
void fillPatches(const Model &model, const FormFactors &factors, int columns, float *values, int first,
                 int count);

} // namespace odraz
