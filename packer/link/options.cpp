#include "packer/link/options.h"

#include "packer/link/objects.h"
#include "tools/common/arguments.h"

#include <filesystem>

namespace pack::linking {

const char kUsage[] =
    "usage: pack-link OBJECT... [-lLIBRARY...] [-o OUT] [OPTION...]\n"
    "       links objects of C or C++ (.o, .a) in the ways that are possible, packs each, and keeps the\n"
    "       smallest; say it instead of cc -o:\n"
    "       pack-link main.o -lSDL2 -lGL -o intro\n"
    "-o OUT                        the packed program; a.out\n"
    "-l, -L, -Wl,..., -u, -f..., -m..., -O..., -pthread, -static-libgcc\n"
    "                              as for the compiler; -W..., -std=, -I, -D, -s and -no-pie change nothing\n"
    "--way dynamic|imports|static  link in this way alone:\n"
    "                              dynamic: as cc does, without what a packed program does not need\n"
    "                              imports: made for the packer: it opens its libraries by itself\n"
    "                              static: libraries become a part of it (-static)\n"
    "--cc COMPILER                 link with this compiler; c++ for C++ and for -flto, else cc\n"
    "--effort fast|normal|best|SECONDS\n"
    "--model FILE, --save-model FILE, --budget BYTES, --name NAME, --safe-name NAME\n"
    "--report FILE, --html FILE, --text FILE, --than OLD.json\n"
    "                              as for pack, for the way that was taken\n"
    "--keep FOLDER                 keep the program as linked, the linker's map and the generated source\n"
    "                              there\n"
    "-v                            say the commands\n"
    "Compile small: -Os -fno-plt -ffunction-sections; C++ with -fno-exceptions -fno-rtti, too.\n";

namespace {

bool begins(const std::string &word, const char *with) { return word.rfind(with, 0) == 0; }

// Words of the compiler that would make something else of the program.
void refuseForeign(const std::string &word) {
    for (const char *other : {"-static-pie", "-pie", "-shared", "-r", "-c", "-nostdlib", "-nostartfiles"})
        if (word == other)
            throw common::Refused(word + " is not for pack-link, which chooses how to link; see --way in "
                                         "pack-link --help");
    for (const char *other : {"-rdynamic", "-Wl,-E", "-Wl,--export-dynamic"})
        if (word == other)
            throw common::Refused(word +
                                  ": nothing can import from what pack-link makes; link such a program with "
                                  "cc, and pack that");
}

// Words that stand in many a line with cc -o and change nothing here.
bool isIgnored(const std::string &word) {
    for (const char *with : {"-W", "-std=", "-I", "-D", "-U"})
        if (begins(word, with)) return word.size() > 2 && !begins(word, "-Wl,");
    return word == "-s" || word == "-no-pie" || word == "-pipe";
}

// Words for linking that the compiler is to have.
bool isForCompiler(const std::string &word) {
    if (begins(word, "-fsanitize")) throw common::Refused("a program with " + word + " cannot be packed");
    for (const char *with : {"-l", "-L", "-Wl,", "-u", "-f", "-m", "-O", "-B", "-g"})
        if (begins(word, with)) return true;
    return word == "-pthread" || word == "-static-libgcc" || word == "-static-libstdc++";
}

bool isForPacker(const std::string &word) {
    for (const char *option : {"--effort", "--model", "--save-model", "--budget", "--name", "--safe-name",
                               "--report", "--html", "--text", "--than"})
        if (word == option) return true;
    return false;
}

void takeFile(const std::string &word, Options &o) {
    switch (kindOf(word)) {
    case FileKind::kMissing:
        if (std::filesystem::is_directory(word)) throw common::Refused(word + " is a folder");
        throw common::Refused("there is no file " + word);
    case FileKind::kProgram:
        throw common::Refused(word + " is a program: give the object files that it was linked from");
    case FileKind::kOther:
        throw common::Refused(word +
                              " is no object file: compile it first (cc -Os -c; more in pack-link --help)");
    case FileKind::kThinArchive:
        throw common::Refused(word + " is a thin archive: make it with ar rcs, without T");
    default:
        o.inputs.push_back(word);
    }
}

std::string wayOf(const std::string &word) {
    if (word == "dynamic" || word == "imports" || word == "static") return word;
    throw common::Refused("--way is dynamic, imports or static, not '" + word + "'");
}

void takePacking(const std::string &word, common::Arguments &arguments, Options &o) {
    std::string value = arguments.value(word);
    Words &to = word == "--model" ? o.model : o.packing;
    to.insert(to.end(), {word, value});
    o.budget |= word == "--budget";
}

} // namespace

Options parseOptions(common::Arguments &arguments) {
    Options o;
    bool files = false;
    while (const char *next = arguments.next()) {
        std::string word = next;
        refuseForeign(word);
        if (word == "-o")
            o.out = arguments.value(word);
        else if (word == "-v")
            o.tell = true;
        else if (word == "--way")
            o.way = wayOf(arguments.value(word));
        else if (word == "--keep")
            o.keep = arguments.value(word);
        else if (word == "--cc")
            o.compiler = arguments.value(word);
        else if (isForPacker(word))
            takePacking(word, arguments, o);
        else if (word == "-l" || word == "-L" || word == "-u" || word == "-Xlinker")
            o.inputs.insert(o.inputs.end(), {word, arguments.value(word)});
        else if (word == "-static")
            o.way = "static";
        else if (isIgnored(word))
            continue;
        else if (isForCompiler(word))
            o.inputs.push_back(word);
        else if (word[0] == '-' || word.empty())
            arguments.refuse(word);
        else {
            takeFile(word, o);
            files = true;
        }
    }
    for (const std::string &input : o.inputs) {
        std::error_code ignored;
        if (std::filesystem::equivalent(input, o.out, ignored))
            throw common::Refused(input + " would be written over: give another name with -o");
    }
    if (!files) throw common::Refused("it takes object files to link; see pack-link --help");
    return o;
}

} // namespace pack::linking
