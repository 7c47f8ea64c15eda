#include "tools/radiosity/read/gltf_file.h"

#include "tools/common/command_line.h"

#include <algorithm>
#include <map>
#include <set>

namespace odraz::radiosity {

using common::need;
using common::Refused;
using nlohmann::json;

namespace {

constexpr int kMostDepth = 64; // tinygltf is recursive

// FB_ngon_encoding only groups triangles, which are joined in any case
const std::set<std::string> kExtensions = {"KHR_lights_punctual",   "KHR_materials_emissive_strength",
                                           "KHR_materials_unlit",   "KHR_materials_pbrSpecularGlossiness",
                                           "KHR_mesh_quantization", "KHR_texture_transform",
                                           "FB_ngon_encoding"};

bool isWhole(const json &x, int bits) { return x.is_number_unsigned() && x.get<uint64_t>() >> bits == 0; }

// The type of a property: its name for errors, and a test for it.
struct ValueType {
    std::string name;
    bool (*is)(const json &);
};
template <bool (*Is)(const json &)> bool eachIs(const json &x) {
    return x.is_array() && std::all_of(x.begin(), x.end(), Is);
}
bool isNumber(const json &x) { return x.is_number(); }
bool isObject(const json &x) { return x.is_object(); }
bool isIndex(const json &x) { return isWhole(x, 31); }
template <size_t N> ValueType numbers() {
    return {"a list of " + std::to_string(N) + " numbers",
            [](const json &x) { return eachIs<isNumber>(x) && x.size() == N; }};
}
const ValueType kIndex = {"a whole number below 2^31", isIndex},
                kSize = {"a whole number below 2^53", [](const json &x) { return isWhole(x, 53); }},
                kIndices = {"a list of whole numbers below 2^31", eachIs<isIndex>},
                kNumber = {"a number", isNumber}, kNumbers = {"a list of numbers", eachIs<isNumber>},
                kFactor = {"a number, or a list of numbers",
                           [](const json &x) { return x.is_number() || eachIs<isNumber>(x); }},
                kFlag = {"true or false", [](const json &x) { return x.is_boolean(); }},
                kText = {"text", [](const json &x) { return x.is_string(); }},
                kObject = {"an object", isObject}, kObjects = {"a list of objects", eachIs<isObject>};

// Types by property, as "name" or "object.name"; * is any name.
const std::map<std::string, ValueType> kTypes = [] {
    std::map<std::string, ValueType> all;
    auto add = [&](const ValueType &kind, std::initializer_list<const char *> names) {
        for (const char *name : names) all[name] = kind;
    };
    add(kIndex, {"attributes.*", "buffer", "bufferView", "byteLength", "byteOffset", "byteStride", "camera"});
    add(kIndex, {"componentType", "count", "index", "inverseBindMatrices", "light", "material", "mesh"});
    add(kIndex,
        {"mode", "primitives.indices", "sampler", "scene", "skin", "source", "targets.*", "texCoord"});
    // In sparse accessors the same properties stay below 2^31: tinygltf reads them as int
    add(kSize, {"accessors.byteOffset", "accessors.count", "bufferViews.byteLength", "bufferViews.byteOffset",
                "bufferViews.byteStride", "buffers.byteLength"});
    add(kIndices, {"children", "joints", "scenes.nodes"});
    add(kNumbers, {"weights"});
    add(kNumber, {"KHR_texture_transform.rotation", "emissiveStrength", "intensity", "range"});
    add(numbers<2>(), {"KHR_texture_transform.offset", "KHR_texture_transform.scale"});
    add(numbers<3>(), {"emissiveFactor", "lights.color", "nodes.scale", "nodes.translation"});
    add(numbers<4>(), {"baseColorFactor", "diffuseFactor", "nodes.rotation"});
    add(numbers<16>(), {"nodes.matrix"});
    add(kFlag, {"doubleSided", "normalized"});
    add(kText, {"alphaMode", "type", "uri"});
    add(kObject,
        {"asset", "attributes", "baseColorTexture", "diffuseTexture", "emissiveTexture", "extensions",
         "extensions.*", "pbrMetallicRoughness", "sparse", "sparse.indices", "sparse.values"});
    add(kObjects, {"accessors", "animations", "bufferViews", "buffers", "images", "lights", "materials",
                   "meshes", "nodes", "primitives", "samplers", "scenes", "skins", "targets", "textures"});
    return all;
}();

void checkProperty(const std::string &holder, const std::string &name, const json &value) {
    for (const std::string &key : {holder + "." + name, name, holder + ".*"})
        if (auto kind = kTypes.find(key); kind != kTypes.end())
            return need(kind->second.is(value), name + " is not " + kind->second.name);
    if (name.ends_with("Factor")) need(kFactor.is(value), name + " is not " + kFactor.name);
}

void check(const json &all) {
    // The values to check, with their names
    std::vector<std::pair<const json *, std::string>> open = {{&all, ""}};
    while (!open.empty()) {
        const auto [object, holder] = open.back();
        open.pop_back();
        if (object->is_array())
            for (const json &item : *object)
                if (item.is_structured()) open.push_back({&item, holder});
        if (!object->is_object()) continue;
        for (const auto &[name, value] : object->items()) {
            if (name == "extras" || (holder == "extensions" && !isExtensionRead(name))) continue;
            checkProperty(holder, name, value);
            if (value.is_structured() && name != "asset") open.push_back({&value, name});
        }
    }
}

// Lists of 2.0 were objects in 1.0, whose asset could be missing.
void needVersion2(const json &all) {
    const json asset = all.value("asset", json::object());
    auto textOf = [&](const char *name) {
        std::string text =
            asset.is_object() ? asset.value(name, json("")).dump() : "2.0"; // check() refuses that
        std::erase(text, '"');
        return text;
    };
    std::string version = textOf("version"), least = textOf("minVersion");
    for (const char *list : {"accessors", "bufferViews", "meshes", "nodes", "scenes"})
        if (version.empty() && all.contains(list) && all[list].is_object()) version = "1.0";
    need(!version.empty() || all.contains("asset"), "is JSON, but not glTF: it has no asset");
    need(version.starts_with("2.") && least <= "2.0",
         "is glTF " + std::max(version, least) + ": only 2.0 is read");
}

} // namespace

bool isExtensionRead(const std::string &name) { return kExtensions.count(name); }

json parseGltf(std::string_view text) {
    int depth = 0;
    bool quoted = false;
    for (size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted && c == '\\') ++i;
        if (c == '"') quoted = !quoted;
        if (!quoted && (c == '[' || c == '{')) need(++depth < kMostDepth, "its JSON is nested too deeply");
        if (!quoted && (c == ']' || c == '}')) --depth;
    }
    json all;
    try {
        all = json::parse(text);
    } catch (const json::parse_error &e) {
        throw Refused("its JSON is damaged at byte " + std::to_string(e.byte));
    } catch (const json::exception &) {
        throw Refused("its JSON has a number that is too large");
    }
    need(all.is_object(), "is JSON, but not glTF: it has no asset");
    needVersion2(all);
    check(all);
    return all;
}

} // namespace odraz::radiosity
