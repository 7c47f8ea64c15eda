// Output folders that appear complete, and temporary folders.
#pragma once

#include <string>

namespace common {

// A folder of files that appears complete: it has a temporary name in the same parent folder until finish()
// renames it.
class NewFolder {
public:
    // Throws Refused if the path cannot be written, or exists and is not an empty folder.
    explicit NewFolder(std::string path);
    NewFolder(const NewFolder &) = delete;
    ~NewFolder(); // removes an unfinished folder with its files
    // Writes a file in the folder. Throws std::runtime_error.
    void write(const std::string &name, const std::string &text) const;
    // The path of a file in the unfinished folder.
    std::string operator/(const std::string &name) const { return part + "/" + name; }
    // Renames the folder to its path. Throws std::runtime_error.
    void finish();

private:
    std::string path, part;
    [[noreturn]] void fail() const;
};

// A new folder in TMPDIR or /tmp. The destructor removes it with all its files.
class TemporaryFolder {
public:
    // Throws std::runtime_error if it cannot make the folder.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder &) = delete;
    std::string operator/(const std::string &name) const { return path + "/" + name; }

private:
    std::string path;
};

} // namespace common
