#include "tools/common/command_line.h"

#include "tools/common/text.h"
#include "tools/common/whole_file.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace common {

namespace {

constexpr size_t kNames = 26,
                 kWidth = 100; // characters: width of the column of names in --help, and of a line

// Formats --help: a column of names, and a column of wrapped descriptions.
class HelpFormatter : public CLI::Formatter {
    std::string make_option(const CLI::Option *option, bool positional) const override {
        std::string name = "  " + option->get_name(positional, false);
        if (!option->get_type_name().empty()) name += " " + option->get_type_name();
        std::string description = option->get_description();
        if (!option->get_default_str().empty()) description += " (default " + option->get_default_str() + ")";
        std::string text = name;
        if (name.size() < kNames)
            text.resize(kNames, ' ');
        else
            text += "\n" + std::string(kNames, ' ');
        size_t column = kNames;
        for (const std::string &word : CLI::detail::split(description, ' ')) {
            if (column > kNames && column + 1 + word.size() > kWidth) {
                text += "\n" + std::string(kNames, ' ');
                column = kNames;
            }
            text += (column > kNames ? " " : "") + word;
            column += word.size() + (column > kNames);
        }
        return text + "\n";
    }
    std::string make_description(const CLI::App *app) const override {
        return app->get_description().empty() ? "" : app->get_description() + "\n\n";
    }
};

} // namespace

struct CommandLine::Parser {
    std::string name, group = "Options";
    std::vector<std::string> words, given,
        values; // given: names of the options; values: one for each of them
    CLI::App app;
    struct KnownOption {
        CLI::Option *option;
        Read read;
    };
    std::vector<KnownOption> known;

    CLI::Option *add(const std::string &option, const std::string &value, const Read &read,
                     const std::string &what, const std::string &fallback = "") {
        CLI::Option *o =
            app.add_option(option, CLI::callback_t([](const CLI::results_t &) { return true; }), what);
        o->type_name(value)->group(group)->take_all()->expected(1)->allow_extra_args(false);
        o->default_str(fallback);
        known.push_back({o, read});
        return o;
    }
};

CommandLine::CommandLine(std::string name, std::vector<std::string> arguments)
    : parser(std::make_unique<Parser>()) {
    parser->name = std::move(name);
    parser->words = std::move(arguments);
    parser->app.name(parser->name);
    auto formatter = std::make_shared<HelpFormatter>();
    formatter->label("Positionals", "Arguments");
    parser->app.formatter(formatter);
    parser->app.set_help_flag("-h,--help", "print this help and exit");
}
CommandLine::~CommandLine() = default;

void CommandLine::about(const std::string &text) { parser->app.description(text); }
void CommandLine::notes(const std::string &text) { parser->app.footer(text); }
void CommandLine::group(const std::string &title) { parser->group = title; }

void CommandLine::argument(const std::string &name, std::string &to, const std::string &what, bool required) {
    parser
        ->add(
            name, "", [&to](const std::string &text) { to = text; }, what)
        ->required(required);
}

void CommandLine::flag(const std::string &name, bool &to, const std::string &what) {
    CLI::Option *o = parser->app.add_flag(name, what)->group(parser->group)->disable_flag_override();
    parser->known.push_back({o, [&to](const std::string &) { to = true; }});
}

void CommandLine::option(const std::string &name, const std::string &value, std::string &to,
                         const std::string &what) {
    parser->add(
        name, value, [&to](const std::string &text) { to = text; }, what, to);
}

void CommandLine::option(const std::string &name, const std::string &value, std::vector<std::string> &to,
                         const std::string &what) {
    parser->add(
        name, value, [&to](const std::string &text) { to.push_back(text); }, what + "; repeatable");
}

void CommandLine::option(const std::string &name, const std::string &value, Read read,
                         const std::string &what) {
    parser->add(name, value, read, what);
}

void CommandLine::number(const std::string &name, const std::string &value, Range range, bool whole,
                         std::function<void(double)> to, const std::string &fallback,
                         const std::string &what) {
    auto read = [=](const std::string &text) {
        double x = numberOf(name, text, range);
        if (whole && x != std::floor(x)) throw Refused(name + " needs a whole number, not '" + text + "'");
        to(x);
    };
    parser->add(name, value, read, what, fallback);
}

void CommandLine::choice(const std::string &name, const std::vector<std::string> &names,
                         std::function<void(size_t)> to, size_t fallback, const std::string &what) {
    auto join = [&](const char *between) { return CLI::detail::join(names, between); };
    auto read = [=, or_ = join(" or ")](const std::string &text) {
        auto found = std::find(names.begin(), names.end(), text);
        if (found == names.end()) throw Refused(name + " needs " + or_ + ", not '" + text + "'");
        to((size_t)(found - names.begin()));
    };
    parser->add(name, join("|"), read, what, fallback < names.size() ? names[fallback] : "");
}

void CommandLine::parse() {
    CLI::App &app = parser->app;
    forgetFiles();
    try {
        app.parse(std::vector<std::string>(parser->words.rbegin(),
                                           parser->words.rend())); // CLI11 reads from the end
    } catch (const CLI::CallForHelp &) {
        std::fputs(app.help().c_str(), stdout);
        throw HelpPrinted();
    } catch (const CLI::ParseError &e) {
        if (const auto rest = app.remaining(); !rest.empty())
            refuse(rest[0][0] == '-' ? "unknown option '" + rest[0] + "'; if it is a file, write ./" + rest[0]
                                     : "unexpected argument '" + rest[0] + "'");
        const std::string &last = parser->words.back();
        const bool lacksValue =
            e.get_name() == "ArgumentMismatch" && last[0] == '-' && last.find('=') == last.npos;
        refuse(lacksValue ? last + " needs a value" : e.what());
    }
    std::vector<size_t> taken(parser->known.size()); // values taken so far, by option
    for (const CLI::Option *option : app.parse_order())
        for (size_t i = 0; i < taken.size(); ++i)
            if (parser->known[i].option == option) {
                const std::string &value = option->results()[taken[i]++];
                if (option->nonpositional()) {
                    parser->given.push_back(option->get_name());
                    parser->values.push_back(option->get_items_expected_max() > 0 ? value : "");
                }
                parser->known[i].read(value);
            }
}

bool CommandLine::has(const std::string &option) const {
    return std::find(parser->given.begin(), parser->given.end(), option) != parser->given.end();
}

const std::vector<std::string> &CommandLine::given() const { return parser->given; }

const std::vector<std::string> &CommandLine::words() const { return parser->words; }

std::vector<CommandLine::Given> CommandLine::givenOf(const std::vector<std::string> &groups) const {
    std::vector<Given> all;
    for (size_t i = 0; i < parser->given.size(); ++i) {
        const std::string &group = parser->app.get_option(parser->given[i])->get_group();
        if (std::find(groups.begin(), groups.end(), group) != groups.end())
            all.push_back({parser->given[i], parser->values[i]});
    }
    return all;
}

void CommandLine::refuse(const std::string &wrong) const {
    throw Refused(wrong + ": see " + parser->name + " --help");
}

int CommandLine::run(const std::vector<Command> &commands) {
    std::vector<std::string> &words = parser->words;
    std::string names;
    for (const Command &command : commands) {
        names += names.empty() ? "" : &command == &commands.back() ? " or " : ", ";
        names += command.name;
        if (words.empty() || words[0] != command.name) continue;
        CommandLine line(parser->name + " " + command.name, {words.begin() + 1, words.end()});
        return command.run(line);
    }
    auto isHelp = [](const std::string &word) { return word == "--help" || word == "-h"; };
    if (std::none_of(words.begin(), words.end(), isHelp))
        refuse((words.empty() ? "no command" : "unknown command '" + words[0] + "'") + ": use " + names);
    for (const Command &command : commands) parser->app.add_subcommand(command.name, command.what);
    std::printf("%s", parser->app.help().c_str());
    std::printf("%s COMMAND --help prints the options of a command.\n", parser->name.c_str());
    throw HelpPrinted();
}

double numberOf(const std::string &option, const std::string &text, Range range) {
    char *end;
    double x = std::strtod(text.c_str(), &end);
    if (end != text.c_str() && !*end && x >= range.least && x <= range.most) return x;
    throw Refused(option + " needs a number from " + format("%g to %g", range.least, range.most) + ", not '" +
                  text + "'");
}

Size sizeOf(const std::string &option, const std::string &text, Size most) {
    Size s;
    char extra;
    if (std::sscanf(text.c_str(), "%dx%d%c", &s.width, &s.height, &extra) == 2 && s.width > 0 &&
        s.height > 0 && s.width <= most.width && s.height <= most.height)
        return s;
    throw Refused(option +
                  format(" needs a size like 1280x720, up to %dx%d, not '", most.width, most.height) + text +
                  "'");
}

std::vector<double> numbersOf(const std::string &option, const std::string &text, size_t count) {
    std::vector<double> numbers;
    const char *p = text.c_str();
    for (size_t i = 0; i < count; ++i) {
        char *end;
        numbers.push_back(std::strtod(p, &end));
        if (end == p || !std::isfinite(numbers[i]) || *end != (i + 1 < count ? ',' : 0))
            throw Refused(option + " needs " + std::to_string(count) + " numbers separated by commas, not '" +
                          text + "'");
        p = end + 1;
    }
    return numbers;
}

// Prints the error as one line, even if the message repeats an argument that has line breaks.
static int printError(const char *name, const std::exception &e, int status) {
    std::string line = e.what();
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return c < ' '; }, '?');
    std::fprintf(stderr, "%s: %s\n", name, line.c_str());
    return status;
}

int runProgram(const char *name, int argc, char **argv, int (*body)(CommandLine &)) {
    std::signal(SIGXFSZ, SIG_IGN); // so that a write beyond the limit (ulimit -f) fails
    try {
        CommandLine line(name, {argv + std::min(argc, 1), argv + argc});
        int status = 0;
        try {
            status = body(line);
        } catch (CommandLine::HelpPrinted) {
        }
        if (std::fflush(stdout) || std::ferror(stdout))
            throw std::runtime_error(std::string("cannot write the output: ") + std::strerror(errno));
        return status;
    } catch (const std::exception &e) {
        const bool refused = dynamic_cast<const Refused *>(&e) || dynamic_cast<const WouldReplace *>(&e);
        return printError(name, e, refused ? 2 : 1);
    }
}

} // namespace common
