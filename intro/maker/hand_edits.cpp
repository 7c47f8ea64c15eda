#include "maker/hand_edits.h"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace odraz {

using maker::EditedTable, maker::KeyNumbers;

namespace {

std::vector<KeyNumbers> asBuilt(const Table &t) {
    std::vector<KeyNumbers> keys;
    for (int i = 0; i < t.count; ++i)
        keys.push_back(t.camera ? maker::numbersOf(((const CameraKey *)t.keys)[i])
                                : maker::numbersOf(((const Key *)t.keys)[i]));
    return keys;
}

// The table of the files that is this one: "scenes/day.cpp", "kExposure"; of an array of arrays "kGrow[1]".
// -1 if there is none, or more than one: two functions may name theirs alike.
int findSource(const maker::Edits &edits, const Table &t, const std::vector<Symbol> &symbols) {
    int element;
    const Symbol *s = symbolOf(symbols, t, element);
    if (!s) return -1;
    std::string name = element < 0 ? s->name : s->name + "[" + std::to_string(element) + "]";
    int found = -1, times = 0;
    for (size_t i = 0; i < edits.tables().size(); ++i) {
        const EditedTable &e = edits.tables()[i];
        std::string file = e.file.substr(e.file.rfind('/') + 1);
        if (e.source.name == name && (s->file.empty() || s->file == file) &&
            e.source.keys.size() == (size_t)t.count)
            found = (int)i, ++times;
    }
    return times == 1 ? found : -1;
}

// What is not saved yet, on top of what somebody else wrote meanwhile; null where they wrote the same table.
std::unique_ptr<maker::Edits> carriedOver(const maker::Edits &old, maker::Edits now,
                                          const std::vector<Table> &tables,
                                          const std::vector<Symbol> &symbols) {
    for (const Table &t : tables)
        if (int i = findSource(now, t, symbols); i >= 0) now.setBuilt(i, asBuilt(t));
    for (const EditedTable &e : old.tables()) {
        if (!e.edited()) continue;
        int i = now.find(e.file, e.source.name);
        if (i < 0 || now.tables()[(size_t)i].built != e.built || !now.change(i, e.keys)) return nullptr;
    }
    return std::make_unique<maker::Edits>(std::move(now));
}

} // namespace

void HandEdits::find(const std::vector<Table> &tables, const std::vector<Symbol> &symbols) {
    joins.clear();
    if (folder.empty()) return;
    bool fresh = false;
    try {
        maker::Edits now(folder);
        // Keep the steps as long as they lead to what was loaded, or are not saved
        bool same = edits && !edits->changedMeanwhile() && now.tables().size() == edits->tables().size();
        for (const Table &t : tables) {
            int i = same ? findSource(*edits, t, symbols) : -1;
            if (i >= 0) same = edits->tables()[(size_t)i].built == asBuilt(t);
        }
        if (edits && edits->edited() && edits->changedMeanwhile()) {
            if (auto carried = carriedOver(*edits, now, tables, symbols)) edits = std::move(carried);
        } else if (!edits || (!same && !edits->edited())) {
            edits = std::make_unique<maker::Edits>(std::move(now));
            fresh = true;
        }
        problem.clear();
    } catch (const std::runtime_error &e) {
        problem = e.what();
        return;
    }
    for (const Table &t : tables) {
        int i = findSource(*edits, t, symbols);
        if (i >= 0 && (fresh || !edits->tables()[(size_t)i].edited())) edits->setBuilt(i, asBuilt(t));
        joins.push_back({t.keys, i});
    }
}

int HandEdits::sourceOf(const Table &table) const {
    for (const Join &j : joins)
        if (j.keys == table.keys) return j.source;
    return -1;
}

std::vector<KeyNumbers> HandEdits::keys(const Table &table) const {
    int i = sourceOf(table);
    if (i < 0 || edits->tables()[(size_t)i].built.empty()) return asBuilt(table);
    return edits->tables()[(size_t)i].keys; // what was saved is not built yet
}

bool HandEdits::edited(const Table &table) const { return keys(table) != asBuilt(table); }

std::string HandEdits::whyNot(const Table &table) const {
    if (folder.empty()) return "the film's sources are not known";
    if (!problem.empty()) return problem;
    int i = sourceOf(table);
    if (i < 0)
        return "its numbers are computed, in a header, or their name stands twice: edit them in the source";
    return edits->tables()[(size_t)i].built.empty() ? "it is not what its source says: build it anew" : "";
}

KeyNumbers HandEdits::rounded(const Table &table, KeyNumbers key) const {
    int i = sourceOf(table);
    return i < 0 ? key : maker::rounded(edits->tables()[(size_t)i].source, std::move(key));
}

bool HandEdits::change(const Table &table, std::vector<KeyNumbers> keys) {
    int i = sourceOf(table);
    return i >= 0 && edits->change(i, std::move(keys));
}

std::string HandEdits::save(std::string &news) {
    if (!edits) return problem.empty() ? "the film's sources are not known" : problem;
    std::set<std::string> files;
    for (const EditedTable &t : edits->tables())
        if (t.edited()) files.insert(t.file);
    std::string wrong = edits->save();
    for (const EditedTable &t : edits->tables())
        if (t.edited()) files.erase(t.file);
    news = files.empty() ? "nothing to save" : "saved";
    for (const std::string &file : files) news += (file == *files.begin() ? " " : ", ") + file;
    return wrong;
}

} // namespace odraz
