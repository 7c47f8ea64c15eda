#include "tools/radiosity/read/gltf_json.h"

#include "tools/common/command_line.h"
#include "tools/common/text.h"

#include <algorithm>

namespace odraz::radiosity {

using common::need;

namespace {

bool isWhole(const json &x, int bits) { return x.is_number_unsigned() && x.get<uint64_t>() >> bits == 0; }
bool isIndex(const json &x) { return isWhole(x, 31); }
bool isNumber(const json &x) { return x.is_number(); }
bool isText(const json &x) { return x.is_string(); }
bool isObject(const json &x) { return x.is_object(); }
template <bool (*Is)(const json &)> bool eachIs(const json &x) {
    return x.is_array() && std::all_of(x.begin(), x.end(), Is);
}

// The type of a property: its name for errors, and a test for it.
struct ValueType {
    const char *name;
    bool (*is)(const json &);
};
ValueType typeOf(int) { return {"a whole number below 2^31", isIndex}; }
ValueType typeOf(size_t) {
    return {"a whole number below 2^53", [](const json &x) { return isWhole(x, 53); }};
}
ValueType typeOf(double) { return {"a number", isNumber}; }
ValueType typeOf(bool) {
    return {"true or false", [](const json &x) { return x.is_boolean(); }};
}
ValueType typeOf(const std::string &) { return {"text", isText}; }
ValueType typeOf(const std::vector<int> &) { return {"a list of whole numbers below 2^31", eachIs<isIndex>}; }
ValueType typeOf(const std::vector<double> &) { return {"a list of numbers", eachIs<isNumber>}; }
ValueType typeOf(const std::vector<std::string> &) { return {"a list of texts", eachIs<isText>}; }

// The property, or null if the object lacks it.
const json &property(const json &object, const char *name, const ValueType &type) {
    static const json kNone;
    auto found = object.find(name);
    if (found == object.end()) return kNone;
    need(type.is(*found), name + (" is not " + std::string(type.name)));
    return *found;
}

} // namespace

template <class T> T valueOf(const json &object, const char *name, const T &otherwise) {
    const json &value = property(object, name, typeOf(otherwise));
    return value.is_null() ? otherwise : value.get<T>();
}
template int valueOf(const json &, const char *, const int &);
template size_t valueOf(const json &, const char *, const size_t &);
template double valueOf(const json &, const char *, const double &);
template bool valueOf(const json &, const char *, const bool &);
template std::string valueOf(const json &, const char *, const std::string &);
template std::vector<int> valueOf(const json &, const char *, const std::vector<int> &);
template std::vector<double> valueOf(const json &, const char *, const std::vector<double> &);
template std::vector<std::string> valueOf(const json &, const char *, const std::vector<std::string> &);

std::vector<double> numbersOf(const json &object, const char *name, const std::vector<double> &otherwise) {
    std::vector<double> list = valueOf(object, name, otherwise);
    need(list.size() == otherwise.size(),
         common::format("%s is not a list of %zu numbers", name, otherwise.size()));
    return list;
}

const json &objectOf(const json &object, const char *name) {
    return property(object, name, {"an object", isObject});
}

const json &objectsOf(const json &object, const char *name) {
    return property(object, name, {"a list of objects", eachIs<isObject>});
}

const json &extensionOf(const json &object, const char *name) {
    return objectOf(objectOf(object, "extensions"), name);
}

const json &itemOf(const json &list, int index, const char *name) {
    need(index >= 0, std::string("a ") + name + " is missing");
    need((size_t)index < list.size(), common::format("there is no %s %d", name, index));
    return list[(size_t)index];
}

} // namespace odraz::radiosity
