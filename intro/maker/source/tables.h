// Tables of keys in a source file of the show: found, and changed in the file's own layout.
//
// A table is an initialised array of constants, whatever its name:
//
//     static constexpr Key kExposure[] = {{0, 2.1f, Smooth}, {rowOf(kWordComes) + 8, 1.9f, Linear}};
//     static constexpr CameraKey kPushIn[] = {{-64, {0.9f, 0.86f, 5.1f}, {0, 0.6f, 0}, 0, 37.8f}};
//     static constexpr auto kSink = coarse<12>({around(128, 5.9f, 5, 2.6f, 0.48f, 38.7f)});
//
// An array of arrays is as many tables: kGrow[0], kGrow[1]. Tables that a function makes are not found: their
// numbers do not stand in the source.
#pragma once

#include "timeline/camera.h"
#include "timeline/track.h"

#include <string>
#include <vector>

namespace odraz::maker {

enum class TableKind { Track, Path }; // of Key; of CameraKey

// The numbers of a key in their order: row, value, interpolation; or row, eye, target, roll, field of view.
using KeyNumbers = std::vector<float>;
KeyNumbers numbersOf(const Key &key);
KeyNumbers numbersOf(const CameraKey &key);
Key keyOf(const KeyNumbers &numbers);
CameraKey cameraKeyOf(const KeyNumbers &numbers);

// A place in the text: [begin, end).
struct Span {
    size_t begin, end;
};
struct SourceKey {
    Span whole;
    std::vector<Span> numbers; // one for each of KeyNumbers; none if the key is the result of a call
};
struct SourceTable {
    std::string name; // "kSink", "kGrow[1]"
    TableKind kind;
    int bits; // coarse() leaves so many significant bits of each number of a place; 0: all
    std::vector<SourceKey> keys;
};

std::vector<SourceTable> findTables(const std::string &text);

// The key as the table will hold it: coarse() rounds eye, target and field of view.
KeyNumbers rounded(const SourceTable &table, KeyNumbers key);

// The text with the table's keys replaced: `before` are its keys as the text has them, `after` what they are
// to be, in ascending order of rows. What did not change stays as it stands, and so do comments; a row that
// is named (rowOf(kWordComes) + 8) stays named. Layout is clang-format's business (file.h). Returns the same
// text if `before` has not as many keys as the table.
std::string withKeys(const std::string &text, const SourceTable &table, const std::vector<KeyNumbers> &before,
                     const std::vector<KeyNumbers> &after);

// A number as the show writes it: the shortest that is read as the same float; "2", "0.86f".
std::string written(float number);

} // namespace odraz::maker
