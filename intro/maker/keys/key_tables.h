// The tables of all key files while they are edited, with undo, until they are saved.
#pragma once

#include "maker/keys/key_file.h"

#include <set>

namespace odraz::maker {

struct EditedTable {
    std::string file;     // "scenes/hall.keys", below the show's folder
    KeyFile::Table saved; // as in the file
    std::vector<KeyNumbers> keys;
    bool conflict = false; // edited here, and changed in the file since then
    bool edited() const { return keys != saved.keys; }
};

class KeyTables {
public:
    // `folder`: the show's; file names are relative to it.
    explicit KeyTables(std::string folder = "") : folder(std::move(folder)) {}

    // Reads the files, for the first time or again. An edited table stays as it is; if its keys in the file
    // have changed, it cannot be saved. Every other table takes the file's keys; if they differ, its undo
    // steps are dropped. A file that cannot be read leaves its tables as they are.
    void read(const std::set<std::string> &files, const Events &events);
    const std::vector<EditedTable> &tables() const { return all; }
    // The index of a table; -1 if there is none.
    int find(const std::string &file, const std::string &name) const;
    std::string problems() const; // one line: which files cannot be read, and why; empty: none

    // Replaces a table's keys by one or more, as one undo step. Sorts them by row, and rounds them.
    void change(int table, std::vector<KeyNumbers> keys);
    bool undo(); // false: there is nothing to undo
    bool redo();
    int edited() const; // the number of edited tables

    // Writes the edited tables. Returns an empty string, or one line: what was not written, and why. `files`:
    // the files written. Steps can still be undone afterwards, and saved again.
    std::string save(std::set<std::string> &files);

private:
    struct UndoStep {
        int table;
        std::vector<KeyNumbers> before, after;
    };
    struct File {
        std::string text; // when it was last read or written
        Events events;
        std::string problem;
    };
    void saveFile(const std::string &name);
    void forget(int table);

    std::string folder;
    std::map<std::string, File> files;
    std::vector<EditedTable> all;
    std::vector<UndoStep> steps;
    size_t done = 0; // the number of steps that are not undone
};

} // namespace odraz::maker
