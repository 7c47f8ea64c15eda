// Folders that appear whole, and folders that go.
#pragma once

#include <string>

namespace common {

// A folder of files that appears whole: it is made beside its place and renamed at the end.
class NewFolder {
public:
    // Throws Refused if there is something at the path already, or it cannot be written. An empty folder is
    // replaced.
    explicit NewFolder(std::string path);
    NewFolder(const NewFolder &) = delete;
    ~NewFolder(); // removes it with its files, unless it is finished
    // Writes a file in it. Throws std::runtime_error.
    void write(const std::string &name, const std::string &text) const;
    // Where a file in it lies until it is finished.
    std::string operator/(const std::string &name) const { return part + "/" + name; }
    // Gives it its name. Throws std::runtime_error.
    void finish();

private:
    std::string path, part;
    [[noreturn]] void fail() const;
};

// A new folder in TMPDIR or /tmp. The destructor removes it with all its files.
class TemporaryFolder {
public:
    // Throws std::runtime_error if the folder cannot be made.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder &) = delete;
    std::string operator/(const std::string &name) const { return path + "/" + name; }

private:
    std::string path;
};

} // namespace common
