// Shapes: the one every search starts from, and shapes as text files, one context a line:
//
//     slots 22
//     code byte1+byte2          a context of code sees these fields
//     data column               ... of data
//     code-weights opcode       what selects a set of weights
//     data-weights -            nothing but what every context sees
#pragma once

#include "model.h"

#include <string>

namespace pack {

const Shape &defaultShape();

std::string printShape(const Shape &shape);

// Returns an empty line, or what is wrong with the text, with the line's number.
std::string parseShape(const std::string &text, Shape &shape);

} // namespace pack
