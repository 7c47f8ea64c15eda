#include "tools/common/arguments.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace common {

std::string Arguments::value(const std::string &option) {
    if (const char *word = next()) return word;
    throw Refused(option + " needs a value; " + hint);
}

double Arguments::number(const std::string &option, double least, double most) {
    std::string text = value(option);
    char *end;
    double x = std::strtod(text.c_str(), &end);
    if (end != text.c_str() && !*end && x >= least && x <= most) return x;
    char range[100];
    std::snprintf(range, sizeof range, " takes a number from %g to %g, not ", least, most);
    throw Refused(option + range + text);
}

int Arguments::whole(const std::string &option, int least, int most) {
    double x = number(option, least, most);
    if (x != std::floor(x)) throw Refused(option + " takes a whole number");
    return (int)x;
}

bool Arguments::choice(const std::string &option, const std::string &first, const std::string &second) {
    std::string word = value(option);
    if (word != first && word != second)
        throw Refused(option + " is " + first + " or " + second + ", not " + word);
    return word == first;
}

bool Arguments::onlyQuick() {
    bool quick = false;
    while (const char *word = next()) {
        if (std::strcmp(word, "--quick")) refuse(word);
        quick = true;
    }
    return quick;
}

void Arguments::refuse(const std::string &word) const { throw Refused("cannot use '" + word + "'; " + hint); }

// Prints one line, even if the message repeats words of the user that have line breaks.
static int complain(const char *name, const std::exception &e, int status) {
    std::string line = e.what();
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return c < ' '; }, '?');
    std::fprintf(stderr, "%s: %s\n", name, line.c_str());
    return status;
}

int runProgram(const char *name, const char *usage, int argc, char **argv, int (*body)(Arguments &)) {
    for (int i = 1; i < argc; ++i)
        if (!std::strcmp(argv[i], "--help")) {
            std::fputs(usage, stdout);
            return std::fflush(stdout) ? 1 : 0;
        }
    // An error prints a usage of one line instead of pointing to --help
    std::string all = usage, hint = "see " + std::string(name) + " --help";
    if (all.find('\n') == all.size() - 1) hint = all.substr(0, all.size() - 1);
    Arguments arguments(argc, argv, hint);
    try {
        int status = body(arguments);
        if (std::fflush(stdout) || std::ferror(stdout))
            throw std::runtime_error(std::string("cannot write what it tells: ") + std::strerror(errno));
        return status;
    } catch (const Refused &e) {
        return complain(name, e, 2);
    } catch (const std::exception &e) {
        return complain(name, e, 1);
    }
}

} // namespace common
