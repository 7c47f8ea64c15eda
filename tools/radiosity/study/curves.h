// Convergence of solutions between patches: by gathering, by Gauss-Seidel, by shooting.
#pragma once

#include "tools/radiosity/patches/shooting.h"
#include "tools/radiosity/study/study.h"

namespace odraz::radiosity {

// One step: a pass over all patches, or several shots.
struct Step {
    int number;     // passes or hemicubes so far
    double seconds; // of the processor, since the start
    double error;   // rms difference from the converged light as a share of that, percent
    double added;   // share of the converged light that this step added, percent
};

struct Curve {
    std::string name;
    std::vector<Step> steps;
};

// The system of a solution by patches, and its converged light.
class Converging {
public:
    // `solved`: by hemicubes that see the lamps, with rows.
    Converging(Study &study, Solved &solved);

    // Passes that use the light of the pass before (Jacobi), or new light at once (Gauss-Seidel).
    Curve passes(bool atOnce);
    // Shots by the form factors of the rows.
    Curve shootingRows();
    // Shots by hemicubes, without rows, as `solve --shots` does: lamps first. Single patches shoot twice as
    // often as there are patches; there is a block for each eight of them, which shoots four times.
    Curve shooting(int px, bool blocks);
    // Whether no light is reflected.
    bool dark() const { return !(power > 0); }

private:
    Study &study;
    const PatchSystem &patches;
    const Model &model;
    double rowSeconds;
    std::vector<Rgb> converged;
    double all = 0, power = 0;
    // Calls `shots`, which shoots and returns the number of shots, until it returns 0, until less than the
    // share `least` is unshot, or until the light has converged. `seconds`: the time before the first shot.
    // Records a step after `first` shots, and whenever their number has grown by a quarter.
    void shoot(Curve &curve, Shooting &shooting, double seconds, int first, double least,
               const std::function<int()> &shots) const;
    Step stepOf(int number, double seconds, const std::function<Rgb(int)> &radiosity, double &before) const;
};

} // namespace odraz::radiosity
