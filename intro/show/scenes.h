// The film's scenes, as film.cpp lists them.
#pragma once

#include "show/show.h"

namespace odraz {

// Each has its own file.
void posePoint(const Cue &cue, Scene &scene);
void poseTable(const Cue &cue, Scene &scene);
void poseFlake(const Cue &cue, Scene &scene);
void posePatches(const Cue &cue, Scene &scene);
void letterPatches(const Cue &cue, const View &view, Frame &frame);
void poseDay(const Cue &cue, Scene &scene);
void poseOdraz(const Cue &cue, Scene &scene);
void poseCredits(const Cue &cue, Scene &scene);
void letterCredits(const Cue &cue, const View &, Frame &frame);

} // namespace odraz
