// The text of a Wavefront OBJ, made plain for a parser that reads what it can and forgets where it stood.
#pragma once

#include <string>
#include <vector>

// Lines end with LF, CR LF or CR alone, go on after a backslash, may begin with the mark of UTF-8, and hold
// bytes of 0: after this they end with LF, as many as there were, and do none of the rest.
std::string plainText(std::string text);

// A line's words behind its first one, without blanks around them; false where its first one is another.
bool isLine(const std::string &line, const char *word, std::string &rest);

struct ObjText {
    std::string all;                    // without mtllib; usemtl names numbers in `used`, from 0
    std::vector<std::string> libraries; // what stands behind mtllib
    std::vector<std::string> used;      // names of materials, each once
    int shortPolygons = 0;              // of less than three points, left out

    // What the parser would read wrongly is refused with its line: throws ModelError.
    ObjText(const std::string &path, std::string text);
};
