// Texts of errors.
#pragma once

#include <stdexcept>

// Returns the text of the Error that `code` throws; an empty string if it throws none.
template <class Error = std::runtime_error, class Code> std::string thrown(Code code) {
    try {
        code();
    } catch (const Error &e) {
        return e.what();
    }
    return "";
}
