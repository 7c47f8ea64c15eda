// The film's scenes, as film.cpp lists them.
#pragma once

#include "show/show.h"

namespace odraz {

// Each has its own file.
void posePoint(const SceneInput &in, Scene &scene);
void poseTable(const SceneInput &in, Scene &scene);
void poseFlake(const SceneInput &in, Scene &scene);
void posePatches(const SceneInput &in, Scene &scene);
void letterPatches(const SceneInput &in, const View &view, Frame &frame);
void poseDay(const SceneInput &in, Scene &scene);
void poseOdraz(const SceneInput &in, Scene &scene);
void poseCredits(const SceneInput &in, Scene &scene);
void letterCredits(const SceneInput &in, const View &, Frame &frame);

} // namespace odraz
