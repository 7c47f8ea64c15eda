#include "tools/radiosity/read/gltf_file.h"

#include "tools/common/text.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/read/mtl_reader.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstring>
#include <resolv.h>
#include <tuple>

namespace odraz::radiosity {

using common::need;
using common::Refused;

namespace {

constexpr size_t kMostEmpty = 1 << 20;                       // items of an accessor without a buffer
constexpr int kByte = 5120, kFloat = 5126;                   // the first and the last component type
constexpr uint32_t kChunkTypes[] = {0x4e4f534a, 0x004e4942}; // JSON, binary

uint32_t word(std::string_view bytes, size_t at) {
    uint32_t value = 0;
    if (at + sizeof value <= bytes.size()) std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

size_t sizeOf(const json &object, const char *name) {
    need(object.contains(name), std::string("a ") + name + " is missing");
    return valueOf(object, name, (size_t)0);
}

bool isData(const std::string &uri) { return uri.starts_with("data:"); }

// Decodes %20 and other escapes in a part of a URI.
std::string decoded(std::string_view uri) {
    std::string text;
    for (size_t i = 0; i < uri.size(); ++i) {
        unsigned code = 0;
        const char *digits = uri.data() + i + 1;
        if (uri[i] == '%' && i + 2 < uri.size() &&
            std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2)
            text += (char)code, i += 2;
        else
            text += uri[i];
    }
    return text;
}

// The bytes of a data URI.
std::string dataOf(std::string_view uri) {
    const size_t comma = uri.find(',');
    need(comma != std::string::npos && uri.size() < (1u << 31), "a data URI has no data");
    std::string data = decoded(uri.substr(comma + 1));
    if (!uri.substr(0, comma).ends_with(";base64")) return data;
    std::erase_if(data, [](unsigned char c) { return std::isspace(c); });
    data.resize((data.size() + 3) / 4 * 4, '='); // some writers omit the padding
    std::string bytes(data.size(), 0);
    const int size = b64_pton(data.c_str(), (unsigned char *)bytes.data(), bytes.size());
    need(size >= 0, "a data URI is damaged");
    return bytes.substr(0, (size_t)size);
}

// Lists of 2.0 were objects in 1.0, whose asset could be missing.
void needVersion2(const json &all) {
    const json &asset = objectOf(all, "asset");
    auto versionOf = [&](const char *name) -> std::string {
        auto found = asset.find(name);
        if (found == asset.end() || found->is_structured()) return "";
        return found->is_string() ? found->get<std::string>() : found->dump();
    };
    std::string version = versionOf("version"), least = versionOf("minVersion");
    for (const char *list : {"accessors", "bufferViews", "meshes", "nodes", "scenes"})
        if (version.empty() && all.contains(list) && all[list].is_object()) version = "1.0";
    need(!version.empty() || all.contains("asset"), "is JSON, but not glTF: it has no asset");
    need(version.starts_with("2.") && least <= "2.0",
         "is glTF " + std::max(version, least) + ": only 2.0 is read");
}

} // namespace

bool hasScheme(const std::string &uri) { return uri.find("://") != std::string::npos; }

bool isGltf(std::string_view start) {
    if (start.starts_with("\xef\xbb\xbf")) start.remove_prefix(3);
    size_t first = start.find_first_not_of(" \t\r\n");
    return start.starts_with("glTF") || (first != std::string_view::npos && start[first] == '{');
}

GltfFile::GltfFile(const std::string &path) : path(path) {
    const std::string file = common::readWhole(path);
    std::string_view all = file;
    need(!all.empty(), "is empty");
    need(isGltf(all), "is neither .glb nor JSON in UTF-8: it is damaged, or another format");
    if (!all.starts_with("glTF")) {
        readJson(all, {});
        return;
    }
    const size_t version = word(all, 4), size = word(all, 8);
    need(version == 2, "is glTF " + std::to_string(version) + ": only 2.0 is read");
    need(size <= all.size(),
         "ends early: it has " + std::to_string(all.size()) + " of " + std::to_string(size) + " bytes");
    all = all.substr(0, size);
    std::string_view chunks[2];
    for (size_t at = 12, chunk; at + 8 <= all.size(); at += 8 + chunk) {
        chunk = word(all, at);
        need(chunk <= all.size() - at - 8, "ends early, within a chunk");
        for (size_t k : {0, 1}) // chunks of other types are skipped
            if (word(all, at + 4) == kChunkTypes[k] && chunks[k].empty())
                chunks[k] = all.substr(at + 8, chunk);
    }
    need(!chunks[0].empty(), "has no JSON");
    readJson(chunks[0], chunks[1]);
}

void GltfFile::readJson(std::string_view text, std::string_view binary) {
    try {
        root = json::parse(text);
    } catch (const json::parse_error &e) {
        throw Refused("its JSON is damaged at byte " + std::to_string(e.byte));
    } catch (const json::exception &) {
        throw Refused("its JSON has a number that is too large");
    }
    need(root.is_object(), "is JSON, but not glTF: it has no asset");
    needVersion2(root);
    for (const char *list : {"accessors", "animations", "bufferViews", "buffers", "images", "materials",
                             "meshes", "nodes", "samplers", "scenes", "skins", "textures"}) {
        objectsOf(root, list);
        root[list]; // null if it is missing
    }
    for (const json &image : root["images"]) // unused ones too
        if (const std::string uri = textOf(image, "uri"); !uri.empty() && !isData(uri) && !hasScheme(uri))
            common::noteInput(findFile(folderOf(path), decoded(uri)));
    readBuffers(binary);
}

void GltfFile::readBuffers(std::string_view binary) {
    for (const json &b : root["buffers"]) {
        const std::string number = std::to_string(buffers.size()), uri = textOf(b, "uri");
        const size_t size = sizeOf(b, "byteLength");
        std::string bytes;
        if (isData(uri))
            bytes = dataOf(uri);
        else if (!uri.empty()) {
            need(!hasScheme(uri),
                 "buffer " + number + " is not read, as its URI has a scheme: " + uri.substr(0, 200));
            bytes = common::readWhole(findFile(folderOf(path), decoded(uri)));
        } else if (buffers.empty())
            bytes = binary;
        // Further buffers without a URI are filled by extensions
        if (!uri.empty() || buffers.empty())
            need(bytes.size() >= size, "buffer " + number + " has " + std::to_string(bytes.size()) + " of " +
                                           std::to_string(size) + " bytes");
        bytes.resize(std::min(bytes.size(), size));
        buffers.push_back(std::move(bytes));
    }
    root.erase("buffers"); // frees memory
}

std::string_view GltfFile::view(int number) const {
    const json &v = itemOf(root["bufferViews"], number, "bufferView");
    const size_t buffer = sizeOf(v, "buffer");
    need(buffer < buffers.size(), common::format("there is no buffer %zu", buffer));
    std::string_view all = buffers[buffer];
    const size_t offset = valueOf(v, "byteOffset", (size_t)0), size = sizeOf(v, "byteLength");
    need(offset <= all.size() && size <= all.size() - offset,
         "bufferView " + std::to_string(number) + " ends outside its buffer");
    return all.substr(offset, size);
}

void GltfFile::copy(int number, size_t offset, int component, bool normalised, size_t width, size_t count,
                    std::vector<double> &to) const {
    if (count == 0) return;
    std::string_view bytes = view(number);
    const size_t given = valueOf(root["bufferViews"][(size_t)number], "byteStride", (size_t)0);
    auto append = [&](auto type) {
        using T = decltype(type);
        const size_t item = sizeof(T) * width, stride = given ? given : item;
        need(offset <= bytes.size() && item <= bytes.size() - offset &&
                 count - 1 <= (bytes.size() - offset - item) / stride,
             "an accessor of " + std::to_string(count) + " items ends outside bufferView " +
                 std::to_string(number));
        to.reserve(to.size() + width * count);
        const double one = normalised && std::is_integral_v<T> ? (double)std::numeric_limits<T>::max() : 1;
        for (size_t i = 0; i < count; ++i)
            for (size_t k = 0; k < width; ++k) {
                T x;
                std::memcpy(&x, bytes.data() + offset + i * stride + k * sizeof x, sizeof x);
                to.push_back(normalised ? std::max((double)x / one, -1.) : (double)x);
            }
    };
    need(component >= 0, "a componentType is missing");
    need(component >= kByte && component <= kFloat,
         "there is no component type " + std::to_string(component));
    // Component types are numbered in this order
    int componentType = kByte;
    auto appendAs = [&](auto... types) { ((componentType++ == component ? append(types) : void()), ...); };
    std::apply(appendAs, std::tuple<int8_t, uint8_t, int16_t, uint16_t, int32_t, uint32_t, float>());
}

std::vector<double> GltfFile::numbers(int number, const std::string &type) const {
    const json &a = itemOf(root["accessors"], number, "accessor");
    const std::string name = "accessor " + std::to_string(number);
    need(textOf(a, "type") == type, name + " has the wrong type for its use");
    const size_t width = type == "SCALAR" ? 1
                         : type == "MAT4" ? 16
                                          : (size_t)(type.back() - '0'),
                 count = sizeOf(a, "count");
    const int component = indexOf(a, "componentType"), bufferView = indexOf(a, "bufferView");
    const bool normalised = valueOf(a, "normalized", false), isSparse = a.contains("sparse");
    std::vector<double> all;
    if (bufferView >= 0)
        copy(bufferView, valueOf(a, "byteOffset", (size_t)0), component, normalised, width, count, all);
    else {
        need(isSparse && count <= kMostEmpty, name + " has no bufferView");
        all.resize(width * count);
    }
    if (!isSparse) return all;
    const json &sparse = objectOf(a, "sparse");
    const size_t replaced = sizeOf(sparse, "count");
    auto read = [&](const char *part, int component, bool normalised, size_t width) {
        const json &from = objectOf(sparse, part);
        std::vector<double> numbers;
        copy(indexOf(from, "bufferView"), valueOf(from, "byteOffset", (size_t)0),
             component < 0 ? indexOf(from, "componentType") : component, normalised, width, replaced,
             numbers);
        return numbers;
    };
    const std::vector<double> at = read("indices", -1, false, 1),
                              values = read("values", component, normalised, width);
    for (size_t i = 0; i < at.size(); ++i) {
        need(at[i] >= 0 && at[i] < (double)count, name + " has a sparse index that is too large");
        std::copy_n(values.begin() + (std::ptrdiff_t)(i * width), width,
                    all.begin() + (std::ptrdiff_t)((size_t)at[i] * width));
    }
    return all;
}

MeshPicture GltfFile::picture(int texture) {
    const json &t = itemOf(root["textures"], texture, "texture");
    const int source = indexOf(t, "source");
    MeshPicture picture = pictures[texture];
    if (source < 0 || !picture.path.empty()) return picture;
    const json &image = itemOf(root["images"], source, "image");
    const std::string uri = textOf(image, "uri"), name = textOf(image, "name");
    picture.path = path + ": picture " + (name.empty() ? std::to_string(source) : name);
    if (isData(uri))
        picture.bytes = std::make_shared<const std::string>(dataOf(uri));
    else if (!uri.empty())
        picture.path = hasScheme(uri) ? uri : findFile(folderOf(path), decoded(uri));
    else {
        need(image.contains("bufferView"), "a bufferView is missing");
        picture.bytes = std::make_shared<const std::string>(view(indexOf(image, "bufferView")));
    }
    return pictures[texture] = picture;
}

} // namespace odraz::radiosity
