// The words of a command line, and what every tool does with what goes wrong: one line on stderr that begins
// with the program's name. Exit status 2: it was used wrongly; 1: it failed.
#pragma once

#include <stdexcept>
#include <string>

namespace odraz {

// What users gave is wrong: words, or files that are not what they should be.
struct Refused : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Taken one after the other. Everything that asks for a value throws Refused where there is none, or none
// that suits.
class Arguments {
public:
    Arguments(int count, char **words, const std::string &hint) : count(count), words(words), hint(hint) {}

    const char *next() { return at < count ? words[at++] : nullptr; } // null: there are no more
    // The value of an option, which is the next word.
    std::string value(const std::string &option);
    double number(const std::string &option, double least, double most);
    int whole(const std::string &option, int least, int most);
    // Whether it is the first of two words.
    bool choice(const std::string &option, const std::string &first, const std::string &second);

    // For a word that means nothing here.
    [[noreturn]] void refuse(const std::string &word) const;

private:
    int count, at = 1;
    char **words;
    std::string hint; // where to look what there is
};

// Runs a program of that name: prints its usage when --help is among the words, else calls the body and tells
// what that throws. Returns the exit status.
int runProgram(const char *name, const char *usage, int argc, char **argv, int (*body)(Arguments &));

} // namespace odraz
