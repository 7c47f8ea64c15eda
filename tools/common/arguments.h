// The command line of programs that are not yet read by command_line.h, which replaces this.
#pragma once

#include "tools/common/command_line.h"

#include <string>

namespace common {

// Takes the words one after the other. A function that asks for a value throws Refused if there is none, or
// if it does not fit.
class Arguments {
public:
    Arguments(int count, char **words, const std::string &hint) : count(count), words(words), hint(hint) {}

    const char *next() { return at < count ? words[at++] : nullptr; } // null: there are no more
    const char *last() const { return words[at - 1]; }                // that was taken
    // The value of an option, which is the next word.
    std::string value(const std::string &option);
    double number(const std::string &option, double least, double most);
    int whole(const std::string &option, int least, int most);
    // Whether the option's value is the first of two words; it must be one of them.
    bool choice(const std::string &option, const std::string &first, const std::string &second);

    // Reads all words, of which only --quick is allowed; whether it was there.
    bool onlyQuick();

    // Throws Refused for a word that means nothing here.
    [[noreturn]] void refuse(const std::string &word) const;

private:
    int count, at = 1;
    char **words;
    std::string hint; // tells where the options are listed
};

// Runs the program called `name`: prints its usage if --help is among the words; else calls the body and
// reports what it throws. Returns the exit status.
int runProgram(const char *name, const char *usage, int argc, char **argv, int (*body)(Arguments &));

} // namespace common
