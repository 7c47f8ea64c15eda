// Checks the JSON of a glTF file: tinygltf skips an optional property of a wrong type, or truncates it.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace odraz::radiosity {

// Whether an extension, such as KHR_lights_punctual, is read.
bool isExtensionRead(const std::string &name);

// The JSON, not nested deeply, with each property that is read of its type; extras and extensions that are
// not read may be anything. Throws Refused, without the file's name.
nlohmann::json parseGltf(std::string_view text);

} // namespace odraz::radiosity
