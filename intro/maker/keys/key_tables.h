// The tables of all files of keys, as they are edited: step by step, until they are saved to the files.
#pragma once

#include "maker/keys/key_file.h"

#include <set>

namespace odraz::maker {

struct EditedTable {
    std::string file;     // "scenes/hall.keys", below the show's folder
    KeyFile::Table saved; // as the file has it
    std::vector<KeyNumbers> keys;
    bool conflict = false; // the file was changed by somebody else since the table was edited
    bool edited() const { return keys != saved.keys; }
};

class KeyTables {
public:
    // `folder`: of the show; files are named from it on.
    explicit KeyTables(std::string folder = "") : folder(std::move(folder)) {}

    // Reads the files, for the first time or again. A table that is edited stays as it is; if the file has
    // other keys for it than before, it cannot be saved. Of every other table what the file has is in force,
    // and steps that led to something else are forgotten. A file that cannot be read leaves its tables as
    // they are.
    void read(const std::set<std::string> &files, const Events &events);
    const std::vector<EditedTable> &tables() const { return all; }
    // The index of a table; -1 if there is none.
    int find(const std::string &file, const std::string &name) const;
    std::string problems() const; // which files cannot be read, and why, as a line; empty: none

    // One step. Keys are put in ascending order of rows and rounded as the table does. There must be some.
    void change(int table, std::vector<KeyNumbers> keys);
    bool undo(); // false: there is nothing to undo
    bool redo();
    int edited() const; // tables that are not as the files have them

    // Writes what was edited. Returns an empty string, or what was not written, and why, as a line.
    // `files`: those that were written. Steps can be undone after it as before, and saved again.
    std::string save(std::set<std::string> &files);

private:
    struct Step {
        int table;
        std::vector<KeyNumbers> before, after;
    };
    struct File {
        std::string text; // as it was read
        Events events;
        std::string problem;
    };
    void saveFile(const std::string &name);
    void forget(int table);

    std::string folder;
    std::map<std::string, File> files;
    std::vector<EditedTable> all;
    std::vector<Step> steps;
    size_t done = 0; // steps that are not undone
};

} // namespace odraz::maker
