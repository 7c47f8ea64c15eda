// Ctrl-C, notes and progress for all commands that solve a model.
#pragma once

#include <csignal>
#include <string>
#include <vector>

namespace odraz::radiosity {

// Returns a flag that the first of these signals sets to 1. A second one ends the program.
const int *stopAt(const std::vector<int> &signals);

// Prints notes on stderr, one line each.
void printNotes(const std::vector<std::string> &notes);

// Progress on stderr: a bar on a terminal, otherwise lines of text, if `lines` asks for them.
class ProgressBar {
public:
    explicit ProgressBar(bool lines);
    ~ProgressBar() { clear(); }
    // Shows a step, the share of it that is done (0 .. 1), the residual unless it is below 0, and the time
    // left once it can be estimated. `step` must stay in memory. Steps may alternate. Lines
    // are printed when a step begins and ends. Between these, the next line follows after one second, or
    // after a twentieth of the time so far, if that is longer.
    void show(const char *step, float done, float residual);
    void clear();

private:
    bool terminal, lines;
    const char *step = nullptr;
    double start, began = 0, lineTime = 0; // times: of the start, of the step's start, of its last line
    float first = 0;                       // share of the step that was done when it began
    bool ended = false;
};

} // namespace odraz::radiosity
