// What a maker edits by hand, table by table, with steps that can be undone; and the sources that it is
// written to. It joins the tables of the object that was loaded with those of the files.
#pragma once

#include "maker/live_tables.h"
#include "maker/source/edits.h"
#include "maker/symbols.h"

#include <memory>
#include <string>
#include <vector>

namespace odraz {

class HandEdits {
public:
    // `show`: the folder of the film's content; empty: no table can be edited.
    explicit HandEdits(std::string show = "") : folder(std::move(show)) {}

    // The tables of a film that was loaded. What is not saved yet stays; if its file was changed meanwhile,
    // as one step for each table, unless that very table was.
    void find(const std::vector<Table> &tables, const std::vector<Symbol> &symbols);

    // What the table with these keys holds: as edited, else as it was built.
    std::vector<maker::KeyNumbers> keys(const Table &table) const;
    bool edited(const Table &table) const; // it holds something else than what was built
    // Why a table cannot be edited, as a line; empty: it can.
    std::string whyNot(const Table &table) const;
    // As the source will have it, if it has such a table.
    maker::KeyNumbers rounded(const Table &table, maker::KeyNumbers key) const;

    // One step. False if the table cannot be edited.
    bool change(const Table &table, std::vector<maker::KeyNumbers> keys);
    bool undo() { return edits && edits->undo(); }
    bool redo() { return edits && edits->redo(); }
    // Writes all that was edited. Returns a line that says what was not written, and why; or nothing. `news`
    // says which files were written.
    std::string save(std::string &news);
    int unsaved() const { return edits ? edits->edited() : 0; } // tables

private:
    int sourceOf(const Table &table) const;

    std::string folder, problem;
    std::unique_ptr<maker::Edits> edits;
    struct Join {
        const void *keys;
        int source; // the index of edits' table; -1: there is none in the files
    };
    std::vector<Join> joins;
};

} // namespace odraz
