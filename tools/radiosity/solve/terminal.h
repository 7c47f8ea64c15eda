// Ctrl-C, notes and progress, for all commands that solve.
#pragma once

#include <csignal>
#include <string>
#include <vector>

namespace odraz::radiosity {

// Makes the first of these signals set `stop` to 1; a second one ends the program.
void stopAt(int &stop, const std::vector<int> &signals);

// Prints notes on stderr, a line each.
void printNotes(const std::vector<std::string> &notes);

// Progress on stderr: a bar on a terminal; otherwise, with `lines`, lines of text.
class ProgressBar {
public:
    explicit ProgressBar(bool lines);
    ~ProgressBar() { clear(); }
    // Shows a step (a name that stays in memory), the share of it that is done, 0 .. 1, and the residual
    // unless it is below 0; also the time left, once it can be estimated. A step may continue after another
    // one. Lines are printed when a step begins and ends, and in between at first every second, later
    // whenever a twentieth of the time so far has passed.
    void show(const char *step, float done, float residual);
    void clear();

private:
    bool terminal, lines;
    const char *step = nullptr;
    double start, began = 0, lineTime = 0; // times: of the start of all, of the step, and of its last line
    float first = 0;                       // the share of the step that was done when it began
    bool ended = false;
};

} // namespace odraz::radiosity
