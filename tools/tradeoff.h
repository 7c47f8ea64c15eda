// The sweeps of `tradeoff`: what is paid, and what is had for it.
#pragma once

#include <string>

struct Sweep {
    bool quick = false;
    std::string csv, plot; // files to write; empty for none
};

// Each returns the exit status, having said on stderr what went wrong.
int tradeoffPack(const Sweep &sweep, const std::string &film);
