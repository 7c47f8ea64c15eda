// What a maker has changed in the show's tables, step by step, until it is saved to the source.
//
// The tables are those of all files of the show. Their keys as built come from the program that was built of
// them; here they are only numbers. Nothing is written before save().
#pragma once

#include "maker/source/file.h"
#include "maker/source/tables.h"

#include <string>
#include <vector>

namespace odraz::maker {

struct EditedTable {
    std::string file;              // "scenes/day.cpp", below the show's folder
    SourceTable source;            // as the file has it
    std::vector<KeyNumbers> built; // its keys in the program; none: not known, so it cannot be edited
    std::vector<KeyNumbers> keys;  // as edited
    bool edited() const { return keys != built; }
};

class Edits {
public:
    // Reads all .cpp files below the folder. Throws std::runtime_error.
    explicit Edits(std::string folder);

    const std::vector<EditedTable> &tables() const { return all; }
    // The index of a table; -1 if there is none.
    int find(const std::string &file, const std::string &name) const;
    // Tells what keys the program has, once it is loaded. Not as many as the source has: it cannot be edited.
    void setBuilt(int table, const std::vector<KeyNumbers> &keys);

    // One step. Keys are put in ascending order of rows and rounded as the table does. False if the table
    // cannot be edited, or would be empty.
    bool change(int table, std::vector<KeyNumbers> keys);
    bool undo(); // false: there is nothing to undo
    bool redo();
    int edited() const;            // tables that are not as they were built
    bool changedMeanwhile() const; // somebody else wrote one of the files

    // Writes what was edited to the files. Returns an empty string, or a line that says what was not written;
    // what was written is then no longer edited: it is what the source says. Steps can be undone after it as
    // before, and saved again.
    std::string save();

private:
    struct Step {
        int table;
        std::vector<KeyNumbers> before, after;
    };
    std::string folder;
    std::vector<SourceFile> files;
    std::vector<EditedTable> all;
    std::vector<Step> steps;
    size_t done = 0; // steps that are not undone
};

} // namespace odraz::maker
