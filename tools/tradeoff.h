// The sweeps of `tradeoff`: what is paid, and what is had for it.
#pragma once

#include <string>

struct Sweep {
    bool quick = false;
    std::string csv, plot; // files to write; empty for none
};

// `model`: a file of contexts to start from, those that ship; empty for ordinary ones. Returns the exit
// status, having said on stderr what went wrong.
int tradeoffPack(const Sweep &sweep, const std::string &film, const std::string &model);
