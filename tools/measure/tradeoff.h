// The sweeps of `tradeoff`: what is paid, and what is had for it.
#pragma once

#include <string>

struct Sweep {
    bool quick = false;
    std::string csv, plot; // files to write; empty for none
};

// Writes a text whole, or says why not; nothing where the path is empty.
bool saveText(const std::string &path, const std::string &text);

// `scene`: one of subjectNames(); empty for all.
int tradeoffTrace(const Sweep &sweep, const std::string &scene);

// Solutions of generated models and of the film's hall, against references by rays. Returns the exit status.
int tradeoffRadiosity(const Sweep &sweep);

// The hall's transfer compressed in several ways. Returns the exit status.
int tradeoffTransfer(const Sweep &sweep);

// `model`: a file of contexts to start from, those that ship; empty for ordinary ones. Returns the exit
// status, having said on stderr what went wrong.
int tradeoffPack(const Sweep &sweep, const std::string &film, const std::string &model);
