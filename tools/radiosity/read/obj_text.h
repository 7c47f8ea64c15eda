// Checks and prepares the text of a Wavefront OBJ for tinyobjloader, which skips what it cannot read and
// reports no line numbers.
#pragma once

#include <string>
#include <vector>

namespace odraz::radiosity {

// Ends every line with LF instead of CR LF or CR, joins a line that ends with a backslash to the next one,
// and removes the byte order mark and zero bytes. The number of lines stays the same.
std::string plainText(std::string text);

// Whether a line begins with `word`; if so, `rest` becomes the text after it, trimmed.
bool isLine(const std::string &line, const char *word, std::string &rest);

struct ObjText {
    std::string all;                    // without mtllib; each usemtl has an index into `used`
    std::vector<std::string> libraries; // the text after each mtllib
    std::vector<std::string> used;      // names of materials, each once
    int shortPolygons = 0;              // left out: they have fewer than three points

    // Throws ModelError with the line number for anything that the parser would misread.
    ObjText(const std::string &path, std::string text);
};

} // namespace odraz::radiosity
