// Properties of glTF's JSON, whose types are checked where they are read. All functions throw Refused for a
// property of another type; the message lacks the file's name.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace odraz::radiosity {

using nlohmann::json;

// A property of an object; `otherwise` if the object lacks it. T: int, below 2^31, as indices are; size_t,
// below 2^53; double; bool; std::string; or a list of int, double or std::string.
template <class T> T valueOf(const json &object, const char *name, const T &otherwise);
inline int indexOf(const json &object, const char *name) { return valueOf(object, name, -1); }
inline std::string textOf(const json &object, const char *name) {
    return valueOf(object, name, std::string());
}
// As many numbers as `otherwise` has.
std::vector<double> numbersOf(const json &object, const char *name, const std::vector<double> &otherwise);
// Null if the object lacks it.
const json &objectOf(const json &object, const char *name);
const json &objectsOf(const json &object, const char *name); // a list of objects
const json &extensionOf(const json &object, const char *name);

// The item of a list, which errors call `name`. Below 0: it is missing.
const json &itemOf(const json &list, int index, const char *name);

} // namespace odraz::radiosity
