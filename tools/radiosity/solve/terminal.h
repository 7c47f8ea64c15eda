// Ctrl-C and notes, for all commands that solve.
#pragma once

#include <csignal>
#include <string>
#include <vector>

namespace odraz::radiosity {

// Makes the first of these signals set `stop` to 1; a second one ends the program.
void stopAt(int &stop, const std::vector<int> &signals);

// Prints notes on stderr, a line each.
void printNotes(const std::vector<std::string> &notes);

} // namespace odraz::radiosity
