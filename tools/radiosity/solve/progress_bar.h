// Progress: a bar on a terminal or, if asked for, lines if stderr is a file.
#pragma once

namespace odraz::radiosity {

class ProgressBar {
public:
    explicit ProgressBar(bool lines);
    ~ProgressBar() { clear(); }
    // Shows a step (a name that stays in memory), its share done, 0 .. 1, and the residual unless it is below
    // 0. Both kinds show the time left once it can be estimated. A step may continue after another one. Lines
    // are printed when a step begins and ends, and in between at first every second, later whenever a
    // twentieth of the time so far has passed.
    void show(const char *step, float done, float residual);
    void clear();

private:
    bool terminal, lines;
    const char *step = nullptr;
    double start, began = 0, lineTime = 0; // when all, the step and its last line began
    float first = 0;                       // how much of the step was done when it began
    bool ended = false;
};

} // namespace odraz::radiosity
