// A source file that is edited by hand and by a program: changed only as long as it is what was read.
#pragma once

#include <string>

namespace odraz::maker {

class SourceFile {
public:
    // Reads it. Throws std::runtime_error with a line that names the file and the reason.
    explicit SourceFile(std::string path);

    const std::string &path() const { return where; }
    const std::string &text() const { return what; }
    bool changedMeanwhile() const; // somebody else wrote it, or it is gone

    // Writes the text, whole or not at all, laid out by clang-format where that is installed: only the lines
    // that differ. Then it is what was read. Returns a line that says why not: changed meanwhile, disk full.
    std::string write(const std::string &text);

private:
    std::string where, what;
};

// The text with its lines that differ from those of `before` as clang-format would have them, by the style of
// the folder that `path` lies in. The text itself if there is no clang-format.
std::string formatted(const std::string &text, const std::string &before, const std::string &path);

} // namespace odraz::maker
