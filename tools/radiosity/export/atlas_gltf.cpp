#include "tools/radiosity/export/atlas.h"

#include "base/gl.h"
#include "tools/common/text.h"
#include "tools/common/whole_file.h"

#include <algorithm>
#include <map>
#include <tuple>

#include <nlohmann/json.hpp>

namespace odraz::radiosity {

AtlasModel::AtlasModel(const Solution &b, const Atlas &atlas, float one)
    : solution(b), name(atlas.settings.radiosity ? "radiosity" : "light"),
      radiosity(atlas.settings.radiosity), pictured(false), one(one), pages(atlas.pages.size()) {
    using Key = std::tuple<std::string, int, bool, float, float, float, float, float, float>;
    std::map<Key, size_t> known;
    std::map<std::tuple<std::string, std::string, size_t>, size_t> knownParts;
    std::map<std::string, size_t> order, uses; // objects in order; uses of a name
    std::vector<double> area;                  // area of each pictured material, to average its reflectance
    for (size_t i = 0; i < b.facets.size(); ++i) {
        const Facet &f = b.facets[i];
        const Chart &c = b.charts[(size_t)f.chart];
        const AtlasPlace &p = atlas.places[(size_t)f.chart];
        const AtlasPage &page = atlas.pages[(size_t)p.page];
        first.push_back((int)points.size());
        for (int k = 0; k < (f.triangle() ? 3 : 4); ++k)
            points.push_back({f.corner(c, k), ((float)p.x + p.column(c, f.u[k])) / (float)page.width,
                              ((float)p.y + p.row(c, f.v[k])) / (float)page.height});
        Rgb reflects = b.reflects[(size_t)f.chart], emits = b.emits[(size_t)f.chart];
        bool paged = p.pictured && !radiosity;
        if (radiosity) reflects = {1, 1, 1}, emits = {};
        Rgb key = paged ? Rgb{} : reflects;
        std::string title = b.materialOf(f.chart);
        if (title.empty()) title = "material";
        auto [entry, added] = known.try_emplace(
            {title, p.page, paged, key.x, key.y, key.z, emits.x, emits.y, emits.z}, materials.size());
        if (added) {
            title += common::format("_page%d", p.page);
            // Parts of a picture that emits share a name
            if (size_t used = ++uses[title]; used > 1) title += common::format("_%zu", used);
            materials.push_back({title, p.page, paged ? Rgb{} : reflects, emits, paged});
            area.push_back(0);
        }
        AtlasMaterial &m = materials[entry->second];
        const std::string object = b.objectOf(f.chart), group = b.groupOf(f.chart);
        order.try_emplace(object, order.size());
        auto [part, isNew] = knownParts.try_emplace({object, group, entry->second}, parts.size());
        if (isNew) parts.push_back({object, group, entry->second, {}});
        parts[part->second].facets.push_back((int)i);
        if (paged) {
            m.reflects += reflects * (c.width * c.height),
                area[entry->second] += (double)(c.width * c.height);
            pictured = true;
        }
    }
    first.push_back((int)points.size());
    std::stable_sort(parts.begin(), parts.end(), [&](const AtlasPart &a, const AtlasPart &c) {
        return std::pair(order[a.object], a.group) < std::pair(order[c.object], c.group);
    });
    for (size_t k = 0; k < materials.size(); ++k)
        if (materials[k].pictured) materials[k].reflects = materials[k].reflects * (float)(1 / area[k]);
}

namespace {

// JSON that writes floats in the shortest exact form
using Json =
    nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t, std::uint64_t, float>;

template <class T> void put(std::string &to, const T &value) {
    to.append((const char *)&value, sizeof value);
}

Json textureOf(size_t index) { return {{"index", index}, {"texCoord", 1}}; }

Json materialOf(const AtlasModel &m, const AtlasMaterial &a) {
    auto page = (size_t)a.page;
    if (m.radiosity)
        return {{"name", a.name},
                {"pbrMetallicRoughness", {{"baseColorTexture", textureOf(page)}, {"metallicFactor", 0}}},
                {"extensions", {{"KHR_materials_unlit", Json::object()}}}};
    Json surface = {{"metallicFactor", 0}, {"roughnessFactor", 1}}, lightmap = textureOf(page);
    if (a.pictured)
        surface["baseColorTexture"] = textureOf(m.pages + page);
    else
        surface["baseColorFactor"] = {a.reflects.x, a.reflects.y, a.reflects.z, 1};
    lightmap["intensity"] = m.one;
    Json material = {
        {"name", a.name}, {"pbrMetallicRoughness", surface}, {"extensions", {{"MOZ_lightmap", lightmap}}}};
    float most = maxComponent(a.emits);
    Rgb emits = a.emits * (most > 1 ? 1 / most : 1);
    if (most > 0) material["emissiveFactor"] = {emits.x, emits.y, emits.z};
    if (most > 1) material["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", most}};
    return material;
}

// The binary file, and the JSON of its views and accessors. Each accessor has a view of its own.
struct GltfBuffer {
    std::string bytes;
    Json views = Json::array(), accessors = Json::array();

    // Describes the bytes from `begin` to the end.
    void describe(size_t begin, int target, int component, size_t count, const char *type) {
        accessors.push_back(
            {{"bufferView", views.size()}, {"componentType", component}, {"count", count}, {"type", type}});
        views.push_back(
            {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", bytes.size() - begin}, {"target", target}});
    }
};

// Adds positions, normals and coordinates on the pages, as accessors 0, 1 and 2.
void addPoints(GltfBuffer &to, const AtlasModel &m) {
    size_t count = m.points.size();
    Vec3 lo = m.points.empty() ? Vec3{} : m.points[0].p, hi = lo;
    for (const AtlasPoint &p : m.points) {
        put(to.bytes, p.p);
        for (float Vec3::*k : {&Vec3::x, &Vec3::y, &Vec3::z})
            lo.*k = std::min(lo.*k, p.p.*k), hi.*k = std::max(hi.*k, p.p.*k);
    }
    to.describe(0, GL_ARRAY_BUFFER, GL_FLOAT, count, "VEC3");
    to.accessors[0]["min"] = {lo.x, lo.y, lo.z}, to.accessors[0]["max"] = {hi.x, hi.y, hi.z};
    size_t begin = to.bytes.size();
    for (size_t i = 0; i + 1 < m.first.size(); ++i)
        for (int p = m.first[i]; p < m.first[i + 1]; ++p)
            put(to.bytes, m.solution.charts[(size_t)m.solution.facets[i].chart].n);
    to.describe(begin, GL_ARRAY_BUFFER, GL_FLOAT, count, "VEC3");
    begin = to.bytes.size();
    for (const AtlasPoint &p : m.points) put(to.bytes, p.u), put(to.bytes, p.v);
    to.describe(begin, GL_ARRAY_BUFFER, GL_FLOAT, count, "VEC2");
}

// Adds the triangles of a part. Returns them as a primitive.
Json addTriangles(GltfBuffer &to, const AtlasModel &m, const AtlasPart &part) {
    size_t begin = to.bytes.size(), indices = to.accessors.size();
    for (int i : part.facets)
        for (int p = m.first[(size_t)i]; p + 2 < m.first[(size_t)i + 1]; ++p)
            for (int corner : {m.first[(size_t)i], p + 1, p + 2}) put(to.bytes, (uint32_t)corner);
    to.describe(begin, GL_ELEMENT_ARRAY_BUFFER, GL_UNSIGNED_INT, (to.bytes.size() - begin) / 4, "SCALAR");
    return {{"attributes", {{"POSITION", 0}, {"NORMAL", 1}, {"TEXCOORD_0", 2}, {"TEXCOORD_1", 2}}},
            {"indices", indices},
            {"material", part.material}};
}

} // namespace

void writeGltf(const AtlasModel &m, const std::string &path, const std::string &binary) {
    GltfBuffer buffer;
    addPoints(buffer, m);
    Json nodes = Json::array(), meshes = Json::array(), materials = Json::array(), images = Json::array(),
         textures = Json::array(), roots = Json::array();
    Json extensions = {m.radiosity ? "KHR_materials_unlit" : "MOZ_lightmap"};
    bool bright = false;
    for (const AtlasMaterial &a : m.materials) {
        materials.push_back(materialOf(m, a));
        bright |= maxComponent(a.emits) > 1;
    }
    // A node for each object, or for each group outside objects
    auto titleOf = [](const AtlasPart &part) { return part.object.empty() ? part.group : part.object; };
    for (size_t k = 0; k < m.parts.size(); ++k) {
        if (k == 0 || titleOf(m.parts[k]) != titleOf(m.parts[k - 1])) {
            roots.push_back(nodes.size());
            nodes.push_back({{"mesh", nodes.size()}});
            meshes.push_back({{"primitives", Json::array()}});
            if (!titleOf(m.parts[k]).empty()) nodes.back()["name"] = titleOf(m.parts[k]);
            if (const Vec3 &origin = m.solution.origin; length(origin) > 0)
                nodes.back()["translation"] = {origin.x, origin.y, origin.z};
        }
        meshes.back()["primitives"].push_back(addTriangles(buffer, m, m.parts[k]));
    }
    if (bright) extensions.push_back("KHR_materials_emissive_strength");
    for (size_t i = 0; i < m.pages * (m.pictured ? 2 : 1); ++i) {
        std::string name = i < m.pages ? m.name : "reflectance";
        images.push_back({{"uri", name + "-" + std::to_string(i % m.pages) + ".png"}});
        textures.push_back({{"source", i}, {"sampler", 0}});
    }
    Json sampler = {{"magFilter", GL_LINEAR},
                    {"minFilter", GL_LINEAR},
                    {"wrapS", GL_CLAMP_TO_EDGE},
                    {"wrapT", GL_CLAMP_TO_EDGE}};
    Json all = {{"asset", {{"version", "2.0"}, {"generator", "odraz radiosity"}}},
                {"extensionsUsed", extensions},
                {"scene", 0},
                {"scenes", Json::array({{{"nodes", roots}}})},
                {"nodes", nodes},
                {"meshes", meshes},
                {"materials", materials},
                {"textures", textures},
                {"images", images},
                {"samplers", Json::array({sampler})},
                {"accessors", buffer.accessors},
                {"bufferViews", buffer.views},
                {"buffers", Json::array({{{"uri", binary.substr(binary.rfind('/') + 1)},
                                          {"byteLength", buffer.bytes.size()}}})}};
    common::writeWhole(binary, buffer.bytes);
    common::writeWhole(path, all.dump() + "\n");
}

} // namespace odraz::radiosity
