// The command line of a program. A program names its options once, with the variables that take their values;
// reading, checking, errors and --help follow from that.
//
// An error is one line on stderr, "PROGRAM: what is wrong: what to do". Exit status 2: the program was used
// wrongly; 1: it failed.
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

// An error of the user: wrong options, or files that cannot be used.
struct Refused : std::runtime_error {
    using std::runtime_error::runtime_error;
};
// Throws Refused unless the condition holds.
inline void need(bool condition, const std::string &otherwise) {
    if (!condition) throw Refused(otherwise);
}

// What a number may be, both ends included.
struct Range {
    double least, most;
};

class CommandLine {
public:
    // `name` begins every error. `arguments` begin behind the program's name.
    CommandLine(std::string name, std::vector<std::string> arguments);
    ~CommandLine();

    // What the program does, for --help: above the options, and below them.
    void about(const std::string &text);
    void notes(const std::string &text);
    // The title in --help of the options that follow.
    void group(const std::string &title);

    // An argument without a dash, in the order of these calls. `what` is its description, which may be empty.
    void argument(const std::string &name, std::string &to, const std::string &what, bool required = true);

    // An option without a value, and options with one, which `value` names in --help: "N", "FILE". If one
    // is given twice, the last counts. What `to` holds before is the default, which --help prints unless it
    // is empty or out of range.
    void flag(const std::string &name, bool &to, const std::string &what);
    void option(const std::string &name, const std::string &value, std::string &to, const std::string &what);
    // Every value of an option that may be given again and again.
    void option(const std::string &name, const std::string &value, std::vector<std::string> &to,
                const std::string &what);
    // The value is passed on, in the order of the command line, to a function that may throw Refused.
    using Take = std::function<void(const std::string &)>;
    void option(const std::string &name, const std::string &value, Take take, const std::string &what);
    // A number in a range. Integers must be whole.
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
    // One of several names. `to`, a bool, an integer or an enumeration, becomes its index.
    template <class Index>
    void option(const std::string &name, const std::vector<std::string> &names, Index &to,
                const std::string &what) {
        choice(
            name, names, [&to](size_t index) { to = (Index)index; }, (size_t)to, what);
    }

    // Reads the arguments. Throws Refused for the first that does not fit; with --help, prints that and
    // throws HelpPrinted.
    void parse();
    struct HelpPrinted {};

    // Whether an option was given. After parse().
    bool has(const std::string &option) const;
    // The options that were given, in order. After parse().
    const std::vector<std::string> &given() const;
    // Those of these groups, in order, with their values. After parse().
    struct Given {
        std::string option, value; // a flag has no value
    };
    std::vector<Given> givenOf(const std::vector<std::string> &groups) const;
    // The arguments as they were given.
    const std::vector<std::string> &words() const;
    // An error for what only the program can check, with a hint to --help.
    [[noreturn]] void refuse(const std::string &wrong) const;

    // In place of parse(), for a program of several commands: runs the one named by the first argument, with
    // the rest as its command line, and returns its status.
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
    // A number in as few digits as it needs
    template <class Number> static std::string textOf(Number x) {
        char text[64];
        return {text, std::to_chars(text, text + sizeof text, x).ptr};
    }
    struct Parser;
    std::unique_ptr<Parser> parser;
};

// Numbers separated by commas, for options of several values: "1,2.5,3". Throws Refused unless there are
// `count` finite ones.
std::vector<double> numbersOf(const std::string &option, const std::string &text, size_t count);

// A number; throws Refused unless all of the text is one in this range.
double numberOf(const std::string &option, const std::string &text, Range range);

// A size in pixels, such as 1280x720; throws Refused unless it has at least one and at most these.
struct Size {
    int width, height;
};
Size sizeOf(const std::string &option, const std::string &text, Size most);

// Runs the program called `name`; reports what the body throws. Returns the exit status.
int runProgram(const char *name, int argc, char **argv, int (*body)(CommandLine &));

} // namespace common
