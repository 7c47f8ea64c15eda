// The command line of a program. A program declares each option once, with the variable for its value.
// Parsing, checks, errors and --help follow from that.
//
// An error is a line on stderr: "PROGRAM: what is wrong: what to do". Exit status 2: wrong use; 1: failure.
#pragma once

#include <charconv>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace common {

// A user's error: wrong options, or unusable files.
struct Refused : std::runtime_error {
    using std::runtime_error::runtime_error;
};
// Throws Refused unless the condition holds.
inline void need(bool condition, const std::string &otherwise) {
    if (!condition) throw Refused(otherwise);
}

// The range of a number, both ends included.
struct Range {
    double least, most;
};

class CommandLine {
public:
    // `name` begins every error. `arguments` are without the program's name.
    CommandLine(std::string name, std::vector<std::string> arguments);
    ~CommandLine();

    // Texts of --help, above and below the options.
    void about(const std::string &text);
    void notes(const std::string &text);
    // The title of the following options in --help.
    void group(const std::string &title);

    // Declares a positional argument. The order of these calls counts. `what` describes it and may be empty.
    void argument(const std::string &name, std::string &to, const std::string &what, bool required = true);

    // Declares an option without or with a value. --help calls the value `value`: "N", "FILE". If an option
    // is given twice, the last value counts. The initial value of `to` is the default; --help prints it
    // unless it is empty or out of range.
    void flag(const std::string &name, bool &to, const std::string &what);
    void option(const std::string &name, const std::string &value, std::string &to, const std::string &what);
    // Declares a repeatable option; `to` gets every value.
    void option(const std::string &name, const std::string &value, std::vector<std::string> &to,
                const std::string &what);
    // Declares an option whose values are passed to a function, in the order of the command line. The
    // function may throw Refused.
    using Read = std::function<void(const std::string &)>;
    void option(const std::string &name, const std::string &value, Read read, const std::string &what);
    // Declares an option whose value is a number in a range. Integers must be whole.
    template <class Number>
    requires std::is_arithmetic_v<Number>
    void option(const std::string &name, const std::string &value, Number &to, Range range,
                const std::string &what) {
        number(
            name, value, range, std::is_integral_v<Number>, [&to](double x) { to = (Number)x; },
            (double)to >= range.least && (double)to <= range.most ? textOf(to) : "", what);
    }
    template <class Number>
    void option(const std::string &name, const std::string &value, std::optional<Number> &to, Range range,
                const std::string &what) {
        number(
            name, value, range, std::is_integral_v<Number>, [&to](double x) { to = (Number)x; },
            to ? textOf(*to) : "", what);
    }
    // Declares an option whose value is one of several names. `to`, a bool, an integer or an enumeration,
    // gets the index of the name.
    template <class Index>
    void option(const std::string &name, const std::vector<std::string> &names, Index &to,
                const std::string &what) {
        choice(
            name, names, [&to](size_t index) { to = (Index)index; }, (size_t)to, what);
    }

    // Parses the arguments. Throws Refused for the first wrong one. For --help, prints the help and throws
    // HelpPrinted.
    void parse();
    struct HelpPrinted {};

    // Returns whether an option was given. Call it after parse().
    bool has(const std::string &option) const;
    // Returns the names of the given options, in order. Call it after parse().
    const std::vector<std::string> &given() const;
    // Returns the given options of some groups, in order, with their values. Call it after parse().
    struct Given {
        std::string option, value; // a flag has no value
    };
    std::vector<Given> givenOf(const std::vector<std::string> &groups) const;
    // Returns the arguments as they were given.
    const std::vector<std::string> &words() const;
    // Throws Refused with a hint to --help, for checks that only the program can make.
    [[noreturn]] void refuse(const std::string &wrong) const;

    // For a program with several commands, in place of parse(): runs the command named by the first argument,
    // with the other arguments as its command line, and returns its status.
    struct Command {
        const char *name, *what;
        int (*run)(CommandLine &line);
    };
    int run(const std::vector<Command> &commands);

private:
    void number(const std::string &name, const std::string &value, Range range, bool whole,
                std::function<void(double)> to, const std::string &fallback, const std::string &what);
    void choice(const std::string &name, const std::vector<std::string> &names,
                std::function<void(size_t)> to, size_t fallback, const std::string &what);
    // Prints a number in as few digits as possible
    template <class Number> static std::string textOf(Number x) {
        char text[64];
        return {text, std::to_chars(text, text + sizeof text, x).ptr};
    }
    struct Parser;
    std::unique_ptr<Parser> parser;
};

// Returns the item of a list with this name. Throws Refused, with all names, if there is none. `what`: what
// the list has; nameOf(item): an item's name.
template <class List, class NameOf>
const auto &named(const List &list, const std::string &name, const std::string &what, NameOf nameOf) {
    std::string known;
    for (const auto &item : list) {
        if (nameOf(item) == name) return item;
        known += std::string(" ") + nameOf(item);
    }
    throw Refused("unknown " + what + " '" + name + "': use one of" + known);
}

// Parses `count` finite numbers separated by commas, such as "1,2.5,3". Throws Refused for any other text.
std::vector<double> numbersOf(const std::string &option, const std::string &text, size_t count);

// Parses a number in the range. Throws Refused for any other text.
double numberOf(const std::string &option, const std::string &text, Range range);

// Parses a size in pixels, such as 1280x720. Throws Refused unless width and height are from 1 to those of
// `most`.
struct Size {
    int width, height;
};
Size sizeOf(const std::string &option, const std::string &text, Size most);

// Runs the body of the program called `name`, and prints the error that it throws. Returns the exit status.
int runProgram(const char *name, int argc, char **argv, int (*body)(CommandLine &));

} // namespace common
