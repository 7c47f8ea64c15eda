// The text of an error.
#pragma once

#include <stdexcept>
#include <string>

// The text of the Error that `code` throws; empty if it throws none.
template <class Error = std::runtime_error, class Code> std::string thrown(Code code) {
    try {
        code();
    } catch (const Error &e) {
        return e.what();
    }
    return "";
}
