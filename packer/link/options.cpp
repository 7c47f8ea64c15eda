#include "packer/link/options.h"

#include "packer/link/objects.h"

#include <algorithm>
#include <filesystem>

namespace pack::linking {

namespace {

constexpr int kMostFiles = 1000; // of words

const Words kTwoWords = {"-l", "-L", "-u",
                         "-Xlinker"}; // compiler options with a value that may be the next word

bool isAmong(const std::string &word, const Words &words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}
bool beginsWithOneOf(const std::string &word, const Words &beginnings) {
    return std::any_of(beginnings.begin(), beginnings.end(),
                       [&](const std::string &b) { return word.rfind(b, 0) == 0; });
}

// Refuses compiler options that packing cannot go with.
void refuseForeign(const std::string &word) {
    if (isAmong(word, {"-static-pie", "-pie", "-shared", "-r", "-c", "-nostdlib", "-nostartfiles"}))
        throw common::Refused(word + " is not for pack-link, which chooses how to link: see --way in "
                                     "pack-link --help");
    if (isAmong(word, {"-rdynamic", "-Wl,-E", "-Wl,--export-dynamic"}))
        throw common::Refused(word + ": nothing can import from what pack-link makes: link such a program "
                                     "with cc, and pack that");
    if (beginsWithOneOf(word, {"-fsanitize"}))
        throw common::Refused("a program with " + word + " cannot be packed: link it without");
}

// Options that are usual with cc -o and change nothing here.
bool isIgnored(const std::string &word) {
    return isAmong(word, {"-s", "-no-pie", "-pipe"}) ||
           (beginsWithOneOf(word, {"-W", "-std=", "-I", "-D", "-U"}) && word.size() > 2 &&
            !beginsWithOneOf(word, {"-Wl,"}));
}

bool isForCompiler(const std::string &word) {
    return beginsWithOneOf(word, {"-l", "-L", "-Wl,", "-u", "-f", "-m", "-O", "-B", "-g"}) ||
           isAmong(word, {"-Xlinker", "-pthread", "-static-libgcc", "-static-libstdc++"});
}

void checkFile(const std::string &path) {
    switch (kindOf(path)) {
    case FileKind::kMissing:
        if (std::filesystem::is_directory(path)) throw common::Refused(path + " is a folder");
        throw common::Refused("there is no file " + path);
    case FileKind::kProgram:
        throw common::Refused(path + " is a program: give the object files that it was linked from");
    case FileKind::kOther:
        throw common::Refused(path +
                              " is no object file: compile it first (cc -Os -c; more in pack-link --help)");
    case FileKind::kThinArchive:
        throw common::Refused(path + " is a thin archive: make it with ar rcs, without T");
    default:;
    }
}

} // namespace

Words wordsOf(const std::string &text) {
    Words words;
    char quote = 0;
    bool inside = false; // of a word
    for (size_t i = 0; i < text.size(); ++i) {
        char c = text[i];
        if (!quote && std::isspace((unsigned char)c)) {
            inside = false;
            continue;
        }
        if (!inside) words.emplace_back();
        inside = true;
        if (c == quote)
            quote = 0;
        else if (!quote && (c == '"' || c == '\''))
            quote = c;
        else
            words.back() += c == '\\' && i + 1 < text.size() ? text[++i] : c;
    }
    return words;
}

DividedWords divide(const Words &given) {
    DividedWords words;
    Words all(given.rbegin(), given.rend()); // the next one last
    int files = 0;
    auto next = [&] {
        std::string word = all.back();
        all.pop_back();
        return word;
    };
    while (!all.empty()) {
        std::string word = next();
        if (word[0] == '@' && std::filesystem::is_regular_file(word.substr(1))) {
            need(++files <= kMostFiles, word + " reads itself again and again");
            Words more = wordsOf(common::readWhole(word.substr(1)));
            all.insert(all.end(), more.rbegin(), more.rend());
            continue;
        }
        // All of pack-link's own options but two have a value, which may be the next word
        bool flag = word == "--help" || word == "-v";
        bool own = flag || word == "-o" || word.rfind("--", 0) == 0;
        bool two = own ? !flag && word.find('=') == word.npos : isAmong(word, kTwoWords);
        Words &to = own ? words.own : words.compiler;
        to.push_back(word);
        if (two && !all.empty()) to.push_back(next());
    }
    return words;
}

LinkOptions parseLinkOptions(common::CommandLine &line, const Words &compiler) {
    LinkOptions o;
    o.packing.out = "a.out";
    o.packing.budget = kNoBudget;
    line.about("Links objects of C or C++ (.o, .a) in the ways that are possible, packs each, and keeps the\n"
               "smallest. Use it in place of cc -o:\n"
               "  pack-link main.o -lSDL2 -lGL -o intro");
    line.option("-o", "OUT", o.packing.out, "the packed program");
    line.option(
        "--way", "dynamic|imports|static",
        [&](const std::string &way) {
            if (!isAmong(way, {"dynamic", "imports", "static"}))
                throw common::Refused("--way is dynamic, imports or static, not '" + way + "'");
            o.way = way;
        },
        "link in this way alone. dynamic: as cc does, without what a packed program does not need; imports: "
        "made for the packer: it opens its libraries itself; static: libraries become part of it "
        "(-static)");
    line.option("--cc", "COMPILER", o.compiler, "link with this one; c++ for C++ and for -flto, else cc");
    line.option("--keep", "FOLDER", o.keep,
                "keep the program as linked, the linker's map and the generated source there");
    line.flag("-v", o.verbose, "print the commands");
    line.group("How to pack the program that is kept");
    addOptions(line, o.packing);
    line.notes(
        "Options for the compiler: -l, -L, -Wl,..., -u, -f..., -m..., -O..., -pthread, -static-libgcc;\n"
        "-W..., -std=, -I, -D, -s and -no-pie change nothing. @FILE stands for the words in FILE.\n"
        "Compile small: -Os -fno-plt -ffunction-sections; C++ with -fno-exceptions -fno-rtti, too.");
    line.parse();
    checkOptions(line, o.packing);
    bool files = false;
    for (size_t i = 0; i < compiler.size(); ++i) {
        const std::string &word = compiler[i];
        refuseForeign(word);
        if (word == "-static")
            o.way = "static";
        else if (isIgnored(word))
            continue;
        else if (isForCompiler(word)) {
            o.inputs.push_back(word);
            if (isAmong(word, kTwoWords)) {
                if (++i == compiler.size()) line.refuse(word + " needs a value");
                o.inputs.push_back(compiler[i]);
            }
        } else if (word.empty() || word[0] == '-')
            line.refuse("cannot use '" + word + "'");
        else {
            checkFile(word);
            o.inputs.push_back(word);
            files = true;
        }
    }
    for (const std::string &input : o.inputs) {
        std::error_code ignored;
        if (std::filesystem::equivalent(input, o.packing.out, ignored))
            throw common::Refused(input + " would be written over: give another name with -o");
    }
    if (!files) line.refuse("it takes object files to link");
    return o;
}

} // namespace pack::linking
