// The radiosity system B = rho (D + F B), for many right-hand sides at once, and its light on the elements.
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
};

// Takes the memory, all zero; false when the arena is full.
bool makeSystem(System &system, Arena &arena, const FormFactors &factors, int patches, int unknowns);

// Solves; returns the number of sweeps, `most` where that was not enough.
int solve(System &system, Workers &workers, float residual, int most);

// One bounce more: from radiosities B of `columns` columns, F B.
void gather(const FormFactors &factors, int patches, int columns, const float *radiosity, float *gathered,
            Workers &workers);

// Spreads values of patches ([patches][stride], one column) over the elements of all charts: bilinear between
// the patches' middles, straight on outside of them. Added to `plane`.
void addToElements(const Model &model, const float *values, int stride, float *plane);

// Repeats the borders in the rings.
void fillRings(const Model &model, float *plane);

// Gives hidden elements the mean of their neighbours, and fills the rings.
void closeGaps(const Model &model, float *plane);

// The mean of a plane over the places of a patch that can be seen; 0 where none can.
float meanOfPatch(const Model &model, int patch, const float *plane);

} // namespace odraz
