// The panel's actions and their keys. H shows this table.
#pragma once

#include "maker/panel/canvas.h"

namespace odraz::maker {

// clang-format off
enum class Action {
    Panel, Help, Heat, Costs, LoopShot,
    PictureBack, PictureOn, BarBack, BarOn, EventBack, EventOn,
    Count
};
// clang-format on

// A key: the code of its character in the American layout, as in GLFW, or a KeyName.
enum class KeyName { Tab = 1, PageUp, PageDown };
struct KeyRow {
    Action action; // Count: a key of the host, only listed here
    int key;       // a character or a KeyName; 0: none
    bool shift;
    const char *shown, *what; // as H lists them; empty `shown`: a headline; empty `what`: not listed
};

inline constexpr int code(KeyName name) { return (int)name; }
inline constexpr KeyRow kKeys[] = {
    {Action::Count, 0, false, "", "through the film"},
    {Action::Count, 0, false, "space", "pause, resume"},
    {Action::Count, 0, false, "left, right", "move by a beat, with shift by a bar"},
    {Action::PictureBack, ',', false, "comma, dot", "previous, next picture"},
    {Action::PictureOn, '.', false, "", ""},
    {Action::BarBack, code(KeyName::PageUp), false, "page up, down", "previous, next bar"},
    {Action::BarOn, code(KeyName::PageDown), false, "", ""},
    {Action::EventBack, 'B', false, "B, N", "previous, next event"},
    {Action::EventOn, 'N', false, "", ""},
    {Action::LoopShot, 'L', false, "L", "loop this shot, or end the loop"},
    {Action::Count, 0, false, "mouse", "on the time line: go there"},
    {Action::Count, 0, false, "right mouse", "on the time line: drag a loop"},
    {Action::Count, 0, false, "wheel", "zoom the time line"},
    {Action::Count, 0, false, "", "the camera"},
    {Action::Count, 0, false, "W A S D Q E", "fly, drag with the left button: look"},
    {Action::Count, 0, false, "R", "back to the scripted camera"},
    {Action::Count, 0, false, "K", "set a camera key, with shift: remove it"},
    {Action::Count, 0, false, "ctrl Z", "undo, with shift: redo"},
    {Action::Count, 0, false, "ctrl S", "save the keys to their files"},
    {Action::Count, 0, false, "C", "print the camera as a key"},
    {Action::Count, 0, false, "X", "write the tracks for gnu rocket"},
    {Action::Count, 0, false, "", "look closer"},
    {Action::Panel, code(KeyName::Tab), false, "tab", "show the panel"},
    {Action::Costs, 'T', false, "T", "costs of the picture: on, off"},
    {Action::Heat, 'P', false, "P", "map of its samples: on, off"},
    {Action::Count, 0, false, "1 2 3", "quality: draft, play, film"},
    {Action::Help, 'H', false, "H", "this help"},
    {Action::Count, 0, false, "esc", "quit"},
};

// Returns the action of a key, with or without shift; Count: none.
Action actionOf(int key, bool shift);

void drawHelp(Canvas &canvas);

} // namespace odraz::maker
