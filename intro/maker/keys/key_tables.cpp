#include "maker/keys/key_tables.h"

#include "tools/common/whole_file.h"

#include <algorithm>
#include <stdexcept>

namespace odraz::maker {

void KeyTables::read(const std::set<std::string> &names, const Events &events) {
    for (const std::string &name : names) {
        File &file = files[name];
        try {
            std::string text = common::readWhole(folder + "/" + name);
            KeyFile lines(name, text, events);
            for (EditedTable &table : all)
                if (table.file == name) table.conflict = table.edited(); // stays if the file lacks the table
            for (const KeyFile::Table &now : lines.tables()) {
                int i = find(name, now.name);
                if (i < 0) {
                    all.push_back({name, now, now.keys});
                    continue;
                }
                EditedTable &table = all[(size_t)i];
                if (table.edited()) {
                    table.conflict = now.keys != table.saved.keys;
                } else if (now.keys != table.keys) {
                    forget(i);
                    table = {name, now, now.keys};
                }
            }
            file = {text, events, ""};
        } catch (const std::runtime_error &e) {
            file.problem = e.what();
        }
    }
}

int KeyTables::find(const std::string &file, const std::string &name) const {
    for (size_t i = 0; i < all.size(); ++i)
        if (all[i].file == file && all[i].saved.name == name) return (int)i;
    return -1;
}

std::string KeyTables::problems() const {
    std::string line;
    for (auto &[name, file] : files)
        if (!file.problem.empty()) line += (line.empty() ? "" : "; ") + file.problem;
    return line;
}

void KeyTables::change(int i, std::vector<KeyNumbers> keys) {
    EditedTable &table = all[(size_t)i];
    for (KeyNumbers &key : keys) key = table.saved.rounded(key);
    std::stable_sort(keys.begin(), keys.end(),
                     [](const KeyNumbers &a, const KeyNumbers &b) { return a[0] < b[0]; });
    if (keys == table.keys) return;
    steps.resize(done);
    steps.push_back({i, table.keys, keys});
    ++done;
    table.keys = std::move(keys);
}

bool KeyTables::undo() {
    if (!done) return false;
    const UndoStep &step = steps[--done];
    all[(size_t)step.table].keys = step.before;
    return true;
}
bool KeyTables::redo() {
    if (done == steps.size()) return false;
    const UndoStep &step = steps[done++];
    all[(size_t)step.table].keys = step.after;
    return true;
}

void KeyTables::forget(int table) {
    auto ofTable = [&](const UndoStep &s) { return s.table == table; };
    done -= (size_t)std::count_if(steps.begin(), steps.begin() + (long)done, ofTable);
    std::erase_if(steps, ofTable);
}

int KeyTables::edited() const {
    return (int)std::count_if(all.begin(), all.end(), [](const EditedTable &t) { return t.edited(); });
}

// Writes the edited tables of a file. Throws std::runtime_error with the reason if it cannot.
void KeyTables::saveFile(const std::string &name) {
    File &file = files[name];
    if (common::readWhole(folder + "/" + name) != file.text)
        throw std::runtime_error(
            name + " was changed by another program: not saved. Save again when it has been reloaded");
    for (const EditedTable &table : all)
        if (table.file == name && table.edited() && table.conflict)
            throw std::runtime_error(name + " was changed by another program, which also edited " +
                                     table.saved.name + ": undo your edits, or write them into the file");
    KeyFile lines(name, file.text, file.events);
    for (size_t i = 0; i < lines.tables().size(); ++i) {
        const EditedTable &table = all[(size_t)find(name, lines.tables()[i].name)];
        if (table.edited()) lines.set(i, table.keys);
    }
    common::writeWhole(folder + "/" + name, lines.text());
    file.text = lines.text();
    for (EditedTable &table : all)
        if (table.file == name) table.saved.keys = table.keys;
}

std::string KeyTables::save(std::set<std::string> &written) {
    std::string wrong;
    std::set<std::string> names;
    for (const EditedTable &table : all)
        if (table.edited()) names.insert(table.file);
    for (const std::string &name : names) try {
            saveFile(name);
            written.insert(name);
        } catch (const std::runtime_error &e) {
            wrong += (wrong.empty() ? "" : "; ") + std::string(e.what());
        }
    return wrong;
}

} // namespace odraz::maker
