// How far something is: a bar on the terminal that grows, or lines where stderr is a file, if they are
// wanted.
#pragma once

namespace odraz {

class Bar {
public:
    explicit Bar(bool lines);
    ~Bar() { clear(); }
    // Which step (a name that stays where it is), how much of it is done, 0 .. 1; the residual where it is
    // not below 0. Both tell how long the step still takes, once that can be known; a step may go on where it
    // was left for another. Lines come when a step
    // begins and ends, and in between every second, later every twentieth of the time that has passed.
    void show(const char *step, float done, float residual);
    void clear();

private:
    bool terminal, lines;
    const char *step = nullptr;
    double start, began = 0, told = 0; // seconds: of all, of the step, of its last line
    float first = 0;                   // how much of the step was done when it began
    bool ended = false;
};

} // namespace odraz
