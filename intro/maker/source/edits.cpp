#include "maker/source/edits.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace odraz::maker {

namespace fs = std::filesystem;

Edits::Edits(std::string path) : folder(std::move(path)) {
    std::vector<std::string> names;
    try {
        for (const fs::directory_entry &e : fs::recursive_directory_iterator(folder))
            if (e.path().extension() == ".cpp") names.push_back(e.path().lexically_relative(folder));
    } catch (const fs::filesystem_error &e) {
        throw std::runtime_error("cannot read " + folder + ": " + e.code().message());
    }
    std::sort(names.begin(), names.end());
    for (const std::string &name : names) {
        SourceFile file(folder + "/" + name);
        std::vector<SourceTable> found = findTables(file.text());
        if (found.empty()) continue;
        files.push_back(file);
        for (SourceTable &table : found) all.push_back({name, std::move(table), {}, {}});
    }
}

int Edits::find(const std::string &file, const std::string &name) const {
    for (size_t i = 0; i < all.size(); ++i)
        if (all[i].file == file && all[i].source.name == name) return (int)i;
    return -1;
}

void Edits::setBuilt(int table, const std::vector<KeyNumbers> &keys) {
    EditedTable &t = all[(size_t)table];
    if (keys.size() != t.source.keys.size()) return;
    t.built = t.keys = keys;
}

bool Edits::change(int table, std::vector<KeyNumbers> keys) {
    EditedTable &t = all[(size_t)table];
    if (t.built.empty() || keys.empty()) return false;
    for (KeyNumbers &key : keys) key = rounded(t.source, std::move(key));
    std::stable_sort(keys.begin(), keys.end(),
                     [](const KeyNumbers &a, const KeyNumbers &b) { return a[0] < b[0]; });
    if (keys == t.keys) return true;
    steps.resize(done);
    steps.push_back({table, t.keys, keys});
    ++done;
    t.keys = std::move(keys);
    return true;
}

bool Edits::undo() {
    if (!done) return false;
    const Step &step = steps[--done];
    all[(size_t)step.table].keys = step.before;
    return true;
}
bool Edits::redo() {
    if (done == steps.size()) return false;
    const Step &step = steps[done++];
    all[(size_t)step.table].keys = step.after;
    return true;
}

int Edits::edited() const {
    return (int)std::count_if(all.begin(), all.end(), [](const EditedTable &t) { return t.edited(); });
}

bool Edits::changedMeanwhile() const {
    return std::any_of(files.begin(), files.end(), [](const SourceFile &f) { return f.changedMeanwhile(); });
}

std::string Edits::save() {
    std::string wrong;
    for (SourceFile &file : files) {
        std::string name = fs::path(file.path()).lexically_relative(folder), text = file.text();
        std::vector<EditedTable *> here;
        for (EditedTable &t : all)
            if (t.file == name && t.edited()) here.push_back(&t);
        if (here.empty()) continue;
        // From the last table on, so that the places of those before stay true
        std::reverse(here.begin(), here.end());
        for (const EditedTable *t : here) text = withKeys(text, t->source, t->built, t->keys);
        std::string why = file.write(text);
        if (!why.empty()) {
            wrong += (wrong.empty() ? "" : "; ") + why;
            continue;
        }
        std::vector<SourceTable> found = findTables(file.text());
        size_t k = 0;
        for (EditedTable &t : all)
            if (t.file == name) t.source = found[k++];
        for (EditedTable *t : here) t->built = t->keys;
    }
    return wrong;
}

} // namespace odraz::maker
