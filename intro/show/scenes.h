// The functions of the film's scenes, which film.cpp lists.
#pragma once

#include "show/show.h"

namespace odraz {

// Adds the mirror ball that visits the hall, `rows` before it stops. It rolls in from outside.
void addGuest(Scene &scene, float rows);

// Each scene has its own file.
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
