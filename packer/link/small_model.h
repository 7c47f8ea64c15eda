// Four contexts for programs of a few kilobytes: they take 36 bytes fewer than the default 16.
#pragma once

namespace pack::linking {

// In the format of model_parameters.h; found by a search that began with those of pack --fast, with an intro
// of 4 KB that uses SDL2 and OpenGL.
inline constexpr char kSmallModel[] = R"(slots 21
code byte1
code function+mode
code opcode+mode+so-far
code byte2+mode
code-weights byte2+mode
code-weights mode
code-weights -
code-weights opcode+mode
code-weights byte1+opcode
code-weights to-mark
code-weights byte1
data to-mark
data byte1
data byte2+byte1+to-mark+target
data byte5+byte4+byte2
data-weights to-mark+target
data-weights byte1
data-weights byte5+byte1
data-weights byte1+to-mark
data-weights column+byte2+target
data-weights byte3+byte2+byte1+target
data-weights to-mark
)";

} // namespace pack::linking
