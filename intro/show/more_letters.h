// Rows of font.cpp's table for characters that only compilers' messages need. Only the target `live` defines
// ODRAZ_MORE_LETTERS, so the film does not have them.

// clang-format off
    '\'', L 0, 12, 0, 9, kEnd,
    '"', L 0, 12, 0, 9, L 3, 12, 3, 9, kEnd,
    '`', L 0, 12, 2, 9, kEnd,
    '(', L 3, 13, 0, 9, L 0, 9, 0, 2, L 0, 2, 3, -2, kEnd,
    ')', L 0, 13, 3, 9, L 3, 9, 3, 2, L 3, 2, 0, -2, kEnd,
    '[', L 3, 13, 0, 13, L 0, 13, 0, -2, L 0, -2, 3, -2, kEnd,
    ']', L 0, 13, 3, 13, L 3, 13, 3, -2, L 3, -2, 0, -2, kEnd,
    '{', L 4, 13, 2, 12, L 2, 12, 2, 7, L 2, 7, 0, 5, L 0, 5, 2, 4, L 2, 4, 2, -1, L 2, -1, 4, -2, kEnd,
    '}', L 0, 13, 2, 12, L 2, 12, 2, 7, L 2, 7, 4, 5, L 4, 5, 2, 4, L 2, 4, 2, -1, L 2, -1, 0, -2, kEnd,
    '<', L 6, 9, 0, 5, L 0, 5, 6, 1, kEnd,
    '>', L 0, 9, 6, 5, L 6, 5, 0, 1, kEnd,
    '=', L 0, 7, 6, 7, L 0, 3, 6, 3, kEnd,
    '_', L 0, -2, 7, -2, kEnd,
    ';', L 1, 7, 1, 7, L 1, 0, 0, -3, kEnd,
    '*', L 3, 11, 3, 5, L 0, 10, 6, 6, L 6, 10, 0, 6, kEnd,
    '&', L 8, 0, 1, 9, A 3, 10, 2, 4, -5, L 4, 8, 1, 5, A 3, 3, 3, 3, 3, L 3, 0, 8, 5, kEnd,
    '!', L 0, 12, 0, 4, L 0, 0, 0, 0, kEnd,
    '?', A 3, 9, 3, 4, -5, L 3, 6, 3, 4, L 3, 0, 3, 0, kEnd,
    '#', L 2, 11, 1, 1, L 6, 11, 5, 1, L 0, 8, 7, 8, L 0, 4, 7, 4, kEnd,
    '%', A 1, 10, 1, 0, 8, L 7, 12, 1, 0, A 7, 2, 1, 0, 8, kEnd,
    '~', L 0, 4, 2, 6, L 2, 6, 5, 4, L 5, 4, 7, 6, kEnd,
    '|', L 0, 13, 0, -2, kEnd,
    '^', L 0, 9, 3, 12, L 3, 12, 6, 9, kEnd,
    '\\', L 0, 13, 6, -2, kEnd,
    // clang-format on
