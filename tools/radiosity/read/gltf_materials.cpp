#include "tools/radiosity/read/gltf_materials.h"

#include <cmath>

namespace odraz::radiosity {

using tinygltf::Value;

namespace {

const Value *find(const tinygltf::ExtensionMap &extensions, const char *name) {
    auto found = extensions.find(name);
    return found != extensions.end() && found->second.IsObject() ? &found->second : nullptr;
}

double numberOf(const Value *object, const char *name, double otherwise) {
    if (!object || !object->Has(name) || !object->Get(name).IsNumber()) return otherwise;
    return object->Get(name).GetNumberAsDouble();
}

template <size_t N>
std::array<double, N> numbersOf(const Value &object, const char *name, std::array<double, N> otherwise) {
    const Value &list = object.Get(name);
    for (size_t k = 0; k < N && list.IsArray() && list.ArrayLen() >= N; ++k)
        otherwise[k] = list.Get(k).GetNumberAsDouble();
    return otherwise;
}

class MaterialReader {
public:
    MaterialReader(GltfFile &file, const std::string &path, NotedKinds &kinds,
                   std::vector<std::string> &notes)
        : file(file), path(path), kinds(kinds), notes(notes) {}

    std::vector<GltfMaterial> read() {
        std::vector<GltfMaterial> all;
        for (const tinygltf::Material &m : file.model.materials) all.push_back(read(m, all.size()));
        return all;
    }

private:
    GltfFile &file;
    const std::string &path;
    NotedKinds &kinds;
    std::vector<std::string> &notes;
    std::map<std::string, int> names; // names so far, each with its number of uses
    std::string name;                 // name of the current material

    void note(const std::string &what) { kinds[what].push_back("material " + name); }

    // Makes names differ, because options change materials by name.
    void setName(const std::string &given, size_t number) {
        const std::string first = given.empty() ? "unnamed " + std::to_string(number) : given;
        int &used = names[name = first];
        if (used++ == 0) return;
        while (names.count(name = first + " (" + std::to_string(used) + ")")) ++used;
        names[name] = 1;
        note("materials that share a name get a number");
    }

    GltfMaterial read(const tinygltf::Material &m, size_t number) {
        setName(m.name, number);
        GltfMaterial to = {{name, {}, {}}};
        to.mesh.twoSided = m.doubleSided;
        const auto &surface = m.pbrMetallicRoughness;
        tinygltf::TextureInfo base = surface.baseColorTexture;
        std::array<double, 4> colour = {1, 1, 1, 1};
        std::copy_n(surface.baseColorFactor.begin(), 4, colour.begin());
        if (const Value *glossy = find(m.extensions, "KHR_materials_pbrSpecularGlossiness")) {
            colour = numbersOf(*glossy, "diffuseFactor", std::array<double, 4>{1, 1, 1, 1});
            base = {};
            const Value &texture = glossy->Get("diffuseTexture");
            if (texture.IsObject()) {
                base.index = (int)numberOf(&texture, "index", -1);
                base.texCoord = (int)numberOf(&texture, "texCoord", 0);
                if (const Value &more = texture.Get("extensions"); more.IsObject())
                    for (const std::string &key : more.Keys()) base.extensions[key] = more.Get(key);
            }
        } else if (m.values.count("metallicFactor") && surface.metallicFactor > 0 &&
                   !find(m.extensions, "KHR_materials_unlit")) {
            note("metal counts as diffuse");
        }
        const double strength =
            numberOf(find(m.extensions, "KHR_materials_emissive_strength"), "emissiveStrength", 1);
        const std::array<double, 3> reflects = {colour[0], colour[1], colour[2]};
        std::array<double, 3> emits;
        for (size_t k = 0; k < 3; ++k) emits[k] = m.emissiveFactor[k] * strength;
        setColours(to.mesh, reflects, emits, {"baseColorFactor", "emission"}, path, notes);
        readPicture(to, base, to.mesh.picture, to.mesh.reflects);
        const bool pictured = !to.mesh.picture.path.empty();
        // This reflectance is used if the picture cannot be read
        for (size_t k = 0; k < 3 && pictured; ++k) to.mesh.reflects[k] *= 0.7f;
        GltfMaterial emission = to;
        MeshPicture &picture = to.mesh.emissionPicture;
        readPicture(emission, m.emissiveTexture, picture, to.mesh.emits);
        if (!picture.path.empty() && pictured && (emission.set != to.set || emission.uv != to.uv)) {
            note("emissiveTexture has other coordinates than baseColorTexture: its mean is used");
            picture.scale = {}, picture.offset = {NAN, NAN};
        } else if (!pictured)
            to.set = emission.set, to.uv = emission.uv;
        noteUnused(m, colour[3]);
        return to;
    }

    // Reads a picture and the transform of its coordinates. Leaves out a picture whose factor is black.
    void readPicture(GltfMaterial &to, const tinygltf::TextureInfo &info, MeshPicture &picture,
                     const std::array<float, 3> &tint) {
        if (info.index < 0) return;
        MeshPicture found;
        try {
            found = file.picture(info.index);
        } catch (const common::Refused &e) { // the model is read without it
            return note(std::string("a picture is damaged: ") + e.what());
        }
        if (found.path.empty()) return note("a picture's format is not read");
        if (!found.bytes && hasScheme(found.path))
            return note("a picture's URI has a scheme, and is not read");
        if (tint == std::array<float, 3>{})
            return note(&picture == &to.mesh.picture ? "baseColorTexture is not used: its factor is black"
                                                     : "emissiveTexture needs an emissiveFactor");
        picture = found;
        picture.tint = tint;
        const tinygltf::Texture &texture = file.model.textures[(size_t)info.index];
        if (texture.sampler >= 0) {
            const auto &wraps = GltfFile::at(file.model.samplers, texture.sampler, "sampler");
            picture.clamp = wraps.wrapS == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE && wraps.wrapT == wraps.wrapS;
            if (wraps.wrapS != wraps.wrapT || wraps.wrapS == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT)
                note("a mirrored picture, or one that repeats along one axis only, repeats along both");
        }
        to.set = info.texCoord, to.uv = {1, 0, 0, 0, 1, 0};
        if (const Value *moved = find(info.extensions, "KHR_texture_transform")) {
            to.set = (int)numberOf(moved, "texCoord", to.set);
            auto scale = numbersOf(*moved, "scale", std::array<double, 2>{1, 1}),
                 offset = numbersOf(*moved, "offset", std::array<double, 2>{0, 0});
            const double turn = numberOf(moved, "rotation", 0), c = std::cos(turn), s = std::sin(turn);
            to.uv = {c * scale[0], s * scale[1], offset[0], -s * scale[0], c * scale[1], offset[1]};
        }
    }

    void noteUnused(const tinygltf::Material &m, double alpha) {
        if (m.normalTexture.index >= 0) note("normalTexture is not used");
        if (m.occlusionTexture.index >= 0) note("occlusionTexture is not used");
        if (m.pbrMetallicRoughness.metallicRoughnessTexture.index >= 0)
            note("metallicRoughnessTexture is not used");
        if (m.alphaMode == "MASK" || m.alphaMode == "BLEND" || alpha < 1)
            note("alpha is not used, so all surfaces are opaque");
        if (m.extensions.count("KHR_materials_unlit")) note("unlit materials reflect their colour");
    }
};

} // namespace

std::vector<GltfMaterial> readMaterials(GltfFile &file, const std::string &path, NotedKinds &kinds,
                                        std::vector<std::string> &notes) {
    return MaterialReader(file, path, kinds, notes).read();
}

} // namespace odraz::radiosity
