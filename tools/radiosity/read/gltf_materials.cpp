#include "tools/radiosity/read/gltf_materials.h"

#include <cmath>

namespace odraz::radiosity {

namespace {

constexpr int kRepeat = 10497, kClamp = 33071, kMirroredRepeat = 33648; // wrapS and wrapT

class MaterialReader {
public:
    MaterialReader(GltfFile &file, const std::string &path, NotedKinds &kinds,
                   std::vector<std::string> &notes)
        : file(file), path(path), kinds(kinds), notes(notes) {}

    std::vector<GltfMaterial> read() {
        std::vector<GltfMaterial> all;
        for (const json &m : file.root["materials"]) all.push_back(read(m, all.size()));
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

    GltfMaterial read(const json &m, size_t number) {
        setName(textOf(m, "name"), number);
        GltfMaterial to = {{name, {}, {}}};
        to.mesh.twoSided = valueOf(m, "doubleSided", false);
        const json &rough = objectOf(m, "pbrMetallicRoughness"),
                   &glossy = extensionOf(m, "KHR_materials_pbrSpecularGlossiness");
        const std::vector<double> white = {1, 1, 1, 1},
                                  colour = glossy.empty() ? numbersOf(rough, "baseColorFactor", white)
                                                          : numbersOf(glossy, "diffuseFactor", white),
                                  glow = numbersOf(m, "emissiveFactor", {0, 0, 0});
        const json &base =
            glossy.empty() ? objectOf(rough, "baseColorTexture") : objectOf(glossy, "diffuseTexture");
        const bool unlit = objectOf(m, "extensions").contains("KHR_materials_unlit");
        if (glossy.empty() && !unlit && valueOf(rough, "metallicFactor", 0.) > 0)
            note("metal counts as diffuse");
        const double strength =
            valueOf(extensionOf(m, "KHR_materials_emissive_strength"), "emissiveStrength", 1.);
        const std::array<double, 3> reflects = {colour[0], colour[1], colour[2]},
                                    emits = {glow[0] * strength, glow[1] * strength, glow[2] * strength};
        setColours(to.mesh, reflects, emits, {"baseColorFactor", "emission"}, path, notes);
        readPicture(to, base, to.mesh.picture, to.mesh.reflects);
        const bool pictured = !to.mesh.picture.path.empty();
        // This reflectance is used if the picture cannot be read
        for (size_t k = 0; k < 3 && pictured; ++k) to.mesh.reflects[k] *= 0.7f;
        GltfMaterial emission = to;
        MeshPicture &picture = to.mesh.emissionPicture;
        readPicture(emission, objectOf(m, "emissiveTexture"), picture, to.mesh.emits);
        if (!picture.path.empty() && pictured && (emission.set != to.set || emission.uv != to.uv)) {
            note("emissiveTexture has other coordinates than baseColorTexture: its mean is used");
            picture.scale = {}, picture.offset = {NAN, NAN};
        } else if (!pictured)
            to.set = emission.set, to.uv = emission.uv;
        for (const char *texture : {"normalTexture", "occlusionTexture"})
            if (m.contains(texture)) note(std::string(texture) + " is not used");
        if (rough.contains("metallicRoughnessTexture")) note("metallicRoughnessTexture is not used");
        if (const std::string mode = textOf(m, "alphaMode");
            mode == "MASK" || mode == "BLEND" || colour[3] < 1)
            note("alpha is not used, so all surfaces are opaque");
        if (unlit) note("unlit materials reflect their colour");
        return to;
    }

    // Reads a picture and the transform of its coordinates. Leaves out a picture whose factor is black.
    void readPicture(GltfMaterial &to, const json &info, MeshPicture &picture,
                     const std::array<float, 3> &tint) {
        const int index = indexOf(info, "index");
        if (index < 0) return;
        MeshPicture found;
        try {
            found = file.picture(index);
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
        const json &texture = file.root["textures"][(size_t)index];
        if (const int sampler = indexOf(texture, "sampler"); sampler >= 0) {
            const json &wraps = itemOf(file.root["samplers"], sampler, "sampler");
            const int s = valueOf(wraps, "wrapS", kRepeat), t = valueOf(wraps, "wrapT", kRepeat);
            picture.clamp = s == kClamp && t == s;
            if (s != t || s == kMirroredRepeat)
                note("a mirrored picture, or one that repeats along one axis only, repeats along both");
        }
        to.set = valueOf(info, "texCoord", 0), to.uv = {1, 0, 0, 0, 1, 0};
        if (const json &moved = extensionOf(info, "KHR_texture_transform"); !moved.empty()) {
            to.set = valueOf(moved, "texCoord", to.set);
            const auto scale = numbersOf(moved, "scale", {1, 1}), offset = numbersOf(moved, "offset", {0, 0});
            const double turn = valueOf(moved, "rotation", 0.), c = std::cos(turn), s = std::sin(turn);
            to.uv = {c * scale[0], s * scale[1], offset[0], -s * scale[0], c * scale[1], offset[1]};
        }
    }
};

} // namespace

std::vector<GltfMaterial> readMaterials(GltfFile &file, const std::string &path, NotedKinds &kinds,
                                        std::vector<std::string> &notes) {
    return MaterialReader(file, path, kinds, notes).read();
}

} // namespace odraz::radiosity
