#define TINYGLTF_IMPLEMENTATION
#include "tools/radiosity/read/gltf_file.h"

#include "tools/common/text.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/read/mtl_reader.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstring>

namespace odraz::radiosity {

using common::need;
using common::Refused;
using nlohmann::json;

namespace {

constexpr size_t kMostEmpty = 1 << 20;                       // items of an accessor without a buffer
constexpr uint32_t kChunkTypes[] = {0x4e4f534a, 0x004e4942}; // JSON, binary

uint32_t word(std::string_view bytes, size_t at) {
    uint32_t value = 0;
    if (at + sizeof value <= bytes.size()) std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

json listOf(json &object, const char *name) {
    auto found = object.find(name);
    if (found == object.end()) return json::array();
    json list = std::move(*found);
    object.erase(found);
    return list;
}

std::string textOf(const json &object, const char *name) {
    auto found = object.find(name);
    return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

size_t sizeOf(const json &object, const char *name) {
    auto found = object.find(name);
    need(found != object.end() && found->is_number_unsigned(), std::string("a ") + name + " is missing");
    return found->get<size_t>();
}

bool isData(const std::string &uri) { return uri.starts_with("data:"); }

// Decodes %20 and other escapes in a part of a URI.
std::string decoded(std::string_view uri) {
    std::string text;
    for (size_t i = 0; i < uri.size(); ++i) {
        unsigned code = 0;
        if (uri[i] == '%' && i + 2 < uri.size() &&
            std::from_chars(&uri[i + 1], &uri[i + 3], code, 16).ptr == &uri[i + 3])
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
    return tinygltf::base64_decode(data);
}

} // namespace

bool hasScheme(const std::string &uri) { return uri.find("://") != std::string::npos; }

bool isGltf(std::string_view start) {
    if (start.starts_with("\xef\xbb\xbf")) start.remove_prefix(3);
    size_t first = start.find_first_not_of(" \t\r\n");
    return start.starts_with("glTF") || (first != std::string_view::npos && start[first] == '{');
}

void GltfFile::refuseIndex(const char *what, int index) {
    throw Refused(common::format("there is no %s %d", what, index));
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
    json all = parseGltf(text);
    json list = listOf(all, "buffers");
    images = listOf(all, "images");
    for (const json &image : images) // unused ones too
        if (const std::string uri = textOf(image, "uri"); !uri.empty() && !isData(uri) && !hasScheme(uri))
            common::noteInput(findFile(folderOf(path), decoded(uri)));
    // Add defaults that tinygltf lacks, and keep only the names of animations
    for (json &skin : all["skins"]) skin.emplace("inverseBindMatrices", -1);
    for (json &one : all["animations"]) one = {{"name", textOf(one, "name")}};
    all.erase("cameras");
    tinygltf::TinyGLTF reader;
    std::string error, warning;
    try {
        const std::string rest = all.dump();
        need(rest.size() < (1u << 31), "its JSON is larger than 2 GB");
        bool good =
            reader.LoadASCIIFromString(&model, &error, &warning, rest.data(), (unsigned)rest.size(), "");
        if (!good || !error.empty())
            throw Refused("is damaged: " + error.substr(0, std::min(error.find('\n'), (size_t)200)));
    } catch (const json::exception &) {
        throw Refused("is damaged: a value has a wrong type");
    }
    readBuffers(list, binary);
}

void GltfFile::readBuffers(const json &list, std::string_view binary) {
    for (const json &b : list) {
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
}

std::string_view GltfFile::view(int number) const {
    const tinygltf::BufferView &v = at(model.bufferViews, number, "bufferView");
    std::string_view all = at(buffers, v.buffer, "buffer");
    need(v.byteOffset <= all.size() && v.byteLength <= all.size() - v.byteOffset,
         "bufferView " + std::to_string(number) + " ends outside its buffer");
    return all.substr(v.byteOffset, v.byteLength);
}

// Appends `count` items of `width` components each.
void GltfFile::copy(int number, size_t offset, int component, bool normalised, size_t width, size_t count,
                    std::vector<double> &to) const {
    if (count == 0) return;
    std::string_view bytes = view(number);
    const int size = tinygltf::GetComponentSizeInBytes((uint32_t)component);
    need(size > 0 && component <= TINYGLTF_COMPONENT_TYPE_FLOAT,
         "there is no component type " + std::to_string(component));
    const size_t item = (size_t)size * width, given = model.bufferViews[(size_t)number].byteStride,
                 stride = given ? given : item;
    need(offset <= bytes.size() && item <= bytes.size() - offset &&
             count - 1 <= (bytes.size() - offset - item) / stride,
         "an accessor of " + std::to_string(count) + " items ends outside bufferView " +
             std::to_string(number));
    to.reserve(to.size() + width * count);
    auto append = [&](auto type) {
        using T = decltype(type);
        const double one = normalised && std::is_integral_v<T> ? (double)std::numeric_limits<T>::max() : 1;
        for (size_t i = 0; i < count; ++i)
            for (size_t k = 0; k < width; ++k) {
                T x;
                std::memcpy(&x, bytes.data() + offset + i * stride + k * sizeof x, sizeof x);
                to.push_back(normalised ? std::max((double)x / one, -1.) : (double)x);
            }
    };
    // Component types are numbered in this order
    int componentType = TINYGLTF_COMPONENT_TYPE_BYTE;
    auto appendAs = [&](auto... types) { ((componentType++ == component ? append(types) : void()), ...); };
    std::apply(appendAs, std::tuple<int8_t, uint8_t, int16_t, uint16_t, int32_t, uint32_t, float>());
}

std::vector<double> GltfFile::numbers(int number, int type) const {
    const tinygltf::Accessor &a = at(model.accessors, number, "accessor");
    const std::string name = "accessor " + std::to_string(number);
    need(a.type == type, name + " has the wrong type for its use");
    const size_t width = (size_t)tinygltf::GetNumComponentsInType((uint32_t)type);
    std::vector<double> all;
    if (a.bufferView >= 0)
        copy(a.bufferView, a.byteOffset, a.componentType, a.normalized, width, a.count, all);
    else {
        need(a.sparse.isSparse && a.count <= kMostEmpty, name + " has no bufferView");
        all.resize(width * a.count);
    }
    if (!a.sparse.isSparse) return all;
    const auto &[count, sparse, indices, values] = a.sparse;
    need(count >= 0 && indices.byteOffset >= 0 && values.byteOffset >= 0, name + " is damaged");
    std::vector<double> at, replacements;
    copy(indices.bufferView, (size_t)indices.byteOffset, indices.componentType, false, 1, (size_t)count, at);
    copy(values.bufferView, (size_t)values.byteOffset, a.componentType, a.normalized, width, (size_t)count,
         replacements);
    for (size_t i = 0; i < at.size(); ++i) {
        need(at[i] >= 0 && at[i] < (double)a.count, name + " has a sparse index that is too large");
        std::copy_n(replacements.begin() + (std::ptrdiff_t)(i * width), width,
                    all.begin() + (std::ptrdiff_t)((size_t)at[i] * width));
    }
    return all;
}

MeshPicture GltfFile::picture(int texture) {
    const tinygltf::Texture &t = at(model.textures, texture, "texture");
    MeshPicture picture = pictures[texture];
    if (t.source < 0 || !picture.path.empty()) return picture;
    need((size_t)t.source < images.size(), "there is no image " + std::to_string(t.source));
    const json &image = images[(size_t)t.source];
    const std::string uri = textOf(image, "uri"), name = textOf(image, "name");
    picture.path = path + ": picture " + (name.empty() ? std::to_string(t.source) : name);
    if (isData(uri))
        picture.bytes = std::make_shared<const std::string>(dataOf(uri));
    else if (!uri.empty())
        picture.path = hasScheme(uri) ? uri : findFile(folderOf(path), decoded(uri));
    else
        picture.bytes = std::make_shared<const std::string>(
            view((int)std::min(sizeOf(image, "bufferView"), (size_t)1 << 30)));
    return pictures[texture] = picture;
}

} // namespace odraz::radiosity
