#include "tools/radiosity/export/atlas_gltf.h"

#include "tools/common/text.h"
#include "tools/common/whole_file.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace odraz::radiosity {

AtlasModel::AtlasModel(const Solution &b, const Atlas &atlas, float one)
    : solution(b), name(atlas.settings.radiosity ? "radiosity" : "light"),
      radiosity(atlas.settings.radiosity), pictured(false), one(one), pages(atlas.pages.size()) {
    using Look = std::tuple<int, bool, float, float, float, float, float, float>;
    std::map<Look, size_t> known;
    std::vector<double> area; // of each pictured material, to average its reflectance
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
        bool own = p.pictured && !radiosity;
        if (radiosity) reflects = {1, 1, 1}, emits = {};
        Rgb key = own ? Rgb{} : reflects;
        auto [entry, added] = known.try_emplace({p.page, own, key.x, key.y, key.z, emits.x, emits.y, emits.z},
                                                materials.size());
        if (added) {
            std::string called;
            common::append(called, "%s%zu_page%d", own ? "pictured" : "material", materials.size(), p.page);
            materials.push_back({called, p.page, own ? Rgb{} : reflects, emits, own, {}});
            area.push_back(0);
        }
        AtlasMaterial &m = materials[entry->second];
        m.facets.push_back((int)i);
        if (own) {
            m.reflects += reflects * (c.width * c.height),
                area[entry->second] += (double)(c.width * c.height);
            pictured = true;
        }
    }
    first.push_back((int)points.size());
    for (size_t k = 0; k < materials.size(); ++k)
        if (materials[k].pictured) materials[k].reflects = materials[k].reflects * (float)(1 / area[k]);
}

namespace {

template <class T> void put(std::string &to, const T &value) {
    to.append((const char *)&value, sizeof value);
}

void putMaterial(std::string &to, const AtlasModel &m, const AtlasMaterial &a) {
    common::append(to, "{\"name\":\"%s\",", a.name.c_str());
    if (m.radiosity) {
        common::append(to,
                       "\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":%d,\"texCoord\":1},"
                       "\"metallicFactor\":0},\"extensions\":{\"KHR_materials_unlit\":{}}}",
                       a.page);
        return;
    }
    to += "\"pbrMetallicRoughness\":{\"metallicFactor\":0,\"roughnessFactor\":1,";
    if (a.pictured)
        common::append(to, "\"baseColorTexture\":{\"index\":%zu,\"texCoord\":1}}", m.pages + (size_t)a.page);
    else
        common::append(to, "\"baseColorFactor\":[%.7g,%.7g,%.7g,1]}", (double)a.reflects.x,
                       (double)a.reflects.y, (double)a.reflects.z);
    float most = maxComponent(a.emits), unit = most > 1 ? 1 / most : 1;
    if (most > 0)
        common::append(to, ",\"emissiveFactor\":[%.7g,%.7g,%.7g]", (double)(a.emits.x * unit),
                       (double)(a.emits.y * unit), (double)(a.emits.z * unit));
    common::append(to, ",\"extensions\":{\"MOZ_lightmap\":{\"index\":%d,\"texCoord\":1,\"intensity\":%.7g}",
                   a.page, (double)m.one);
    if (most > 1)
        common::append(to, ",\"KHR_materials_emissive_strength\":{\"emissiveStrength\":%.7g}", (double)most);
    to += "}}";
}

} // namespace

void writeGltf(const AtlasModel &m, const std::string &path, const std::string &binary) {
    // Write positions, normals and coordinates; then the triangles of each material
    std::string bytes;
    Vec3 lo = m.points.empty() ? Vec3{} : m.points[0].p, hi = lo;
    std::vector<Vec3> normals;
    for (size_t i = 0; i + 1 < m.first.size(); ++i)
        normals.resize((size_t)m.first[i + 1], m.solution.charts[(size_t)m.solution.facets[i].chart].n);
    for (const AtlasPoint &p : m.points) {
        put(bytes, p.p);
        for (float Vec3::*k : {&Vec3::x, &Vec3::y, &Vec3::z})
            lo.*k = std::min(lo.*k, p.p.*k), hi.*k = std::max(hi.*k, p.p.*k);
    }
    for (const Vec3 &n : normals) put(bytes, n);
    for (const AtlasPoint &p : m.points) put(bytes, p.u), put(bytes, p.v);
    size_t count = m.points.size(), begin = bytes.size();
    std::string views, accessors, primitives, materials, images, textures;
    auto view = [&](size_t from, size_t length, int target) {
        common::append(views, "%s{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu,\"target\":%d}",
                       views.empty() ? "" : ",", from, length, target);
    };
    view(0, count * 12, 34962), view(count * 12, count * 12, 34962), view(count * 24, count * 8, 34962);
    common::append(
        accessors,
        "{\"bufferView\":0,\"componentType\":5126,\"count\":%zu,\"type\":\"VEC3\",\"min\":[%.9g,%.9g,%.9g],"
        "\"max\":[%.9g,%.9g,%.9g]}",
        count, (double)lo.x, (double)lo.y, (double)lo.z, (double)hi.x, (double)hi.y, (double)hi.z);
    common::append(accessors, ",{\"bufferView\":1,\"componentType\":5126,\"count\":%zu,\"type\":\"VEC3\"}",
                   count);
    common::append(accessors, ",{\"bufferView\":2,\"componentType\":5126,\"count\":%zu,\"type\":\"VEC2\"}",
                   count);
    bool bright = false;
    for (size_t k = 0; k < m.materials.size(); ++k) {
        const AtlasMaterial &a = m.materials[k];
        for (int i : a.facets)
            for (int p = m.first[(size_t)i]; p + 2 < m.first[(size_t)i + 1]; ++p)
                for (int corner : {m.first[(size_t)i], p + 1, p + 2}) put(bytes, (uint32_t)corner);
        view(begin, bytes.size() - begin, 34963);
        common::append(accessors,
                       ",{\"bufferView\":%zu,\"componentType\":5125,\"count\":%zu,\"type\":\"SCALAR\"}",
                       k + 3, (bytes.size() - begin) / 4);
        common::append(primitives,
                       "%s{\"attributes\":{\"POSITION\":0,\"NORMAL\":1,\"TEXCOORD_0\":2,\"TEXCOORD_1\":2},"
                       "\"indices\":%zu,\"material\":%zu}",
                       k ? "," : "", k + 3, k);
        if (k) materials += ',';
        putMaterial(materials, m, a);
        bright |= maxComponent(a.emits) > 1;
        begin = bytes.size();
    }
    for (size_t i = 0; i < m.pages * (m.pictured ? 2 : 1); ++i) {
        common::append(images, "%s{\"uri\":\"%s-%zu.png\"}", i ? "," : "",
                       i < m.pages ? m.name.c_str() : "reflectance", i % m.pages);
        common::append(textures, "%s{\"source\":%zu,\"sampler\":0}", i ? "," : "", i);
    }
    std::string file = binary.substr(binary.rfind('/') + 1);
    std::string json =
        "{\"asset\":{\"version\":\"2.0\",\"generator\":\"odraz radiosity\"},\"extensionsUsed\":[";
    json += m.radiosity ? "\"KHR_materials_unlit\"" : "\"MOZ_lightmap\"";
    if (bright) json += ",\"KHR_materials_emissive_strength\"";
    json +=
        "],\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[" +
        primitives + "]}],\"materials\":[" + materials + "],\"textures\":[" + textures + "],\"images\":[" +
        images + "],\"samplers\":[{\"magFilter\":9729,\"minFilter\":9729," +
        "\"wrapS\":33071,\"wrapT\":33071}],\"accessors\":[" + accessors + "],\"bufferViews\":[" + views +
        "],\"buffers\":[{\"uri\":\"" + file + "\",\"byteLength\":" + std::to_string(bytes.size()) + "}]}\n";
    common::writeWhole(binary, bytes);
    common::writeWhole(path, json);
}

} // namespace odraz::radiosity
