// What every command of solving does at a terminal.
#pragma once

#include <csignal>
#include <string>
#include <vector>

namespace odraz::radiosity {

// From now on the first of these signals sets `stop` to 1; a second one ends the program.
void stopAt(int &stop, const std::vector<int> &signals);

// Prints notes on stderr, a line each.
void printNotes(const std::vector<std::string> &notes);

} // namespace odraz::radiosity
