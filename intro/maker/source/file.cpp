#include "maker/source/file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <unistd.h>

namespace odraz::maker {

namespace {

bool readAll(std::FILE *from, std::string &text) {
    char some[4096];
    text.clear();
    while (size_t n = std::fread(some, 1, sizeof some, from)) text.append(some, n);
    return !std::ferror(from);
}
bool readFile(const std::string &path, std::string &text) {
    std::FILE *file = std::fopen(path.c_str(), "rb");
    if (!file) return false;
    bool whole = readAll(file, text);
    int wrong = errno;
    std::fclose(file);
    errno = wrong;
    return whole;
}

// Writes beside the file, and renames. False, and errno tells why.
bool writeFile(const std::string &path, const std::string &text) {
    std::string beside = path + ".XXXXXX";
    int to = mkstemp(beside.data());
    if (to < 0) return false;
    std::error_code ignored;
    std::filesystem::permissions(beside, std::filesystem::status(path, ignored).permissions(), ignored);
    std::FILE *file = fdopen(to, "wb");
    bool whole = std::fwrite(text.data(), 1, text.size(), file) == text.size();
    whole &= std::fclose(file) == 0;
    if (whole && std::rename(beside.c_str(), path.c_str()) == 0) return true;
    int wrong = errno;
    std::remove(beside.c_str());
    errno = wrong;
    return false;
}

// 'it''s' as a shell reads it.
std::string quoted(const std::string &word) {
    std::string text = "'";
    for (char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
    return text + "'";
}

} // namespace

SourceFile::SourceFile(std::string path) : where(std::move(path)) {
    if (!readFile(where, what))
        throw std::runtime_error("cannot read " + where + ": " + std::strerror(errno));
}

bool SourceFile::changedMeanwhile() const {
    std::string now;
    return !readFile(where, now) || now != what;
}

std::string SourceFile::write(const std::string &text) {
    if (changedMeanwhile()) return where + " was changed meanwhile and is not what is shown: nothing was written to it";
    std::string laidOut = formatted(text, what, where);
    if (!writeFile(where, laidOut)) return "cannot write " + where + ": " + std::strerror(errno);
    what = laidOut;
    return "";
}

std::string formatted(const std::string &text, const std::string &before, const std::string &path) {
    if (text == before) return text;
    // The lines that differ
    size_t shorter = std::min(text.size(), before.size()), same = 0, tail = 0;
    while (same < shorter && text[same] == before[same]) ++same;
    while (tail < shorter - same && text[text.size() - 1 - tail] == before[before.size() - 1 - tail]) ++tail;
    auto lineOf = [&](size_t at) { return 1 + std::count(text.begin(), text.begin() + (long)at, '\n'); };
    std::string lines = std::to_string(lineOf(same)) + ":" + std::to_string(lineOf(text.size() - tail));

    char copy[] = "/tmp/odraz-source-XXXXXX";
    int to = mkstemp(copy);
    if (to < 0) return text;
    std::string laidOut;
    bool written = ::write(to, text.data(), text.size()) == (ssize_t)text.size();
    close(to);
    std::string command = "clang-format --style=file --assume-filename=" + quoted(path) +
                          " --lines=" + lines + " <" + copy + " 2>/dev/null";
    std::FILE *from = written ? popen(command.c_str(), "r") : nullptr;
    bool whole = from && readAll(from, laidOut);
    whole &= from && pclose(from) == 0;
    std::remove(copy);
    return whole && !laidOut.empty() ? laidOut : text;
}

} // namespace odraz::maker
