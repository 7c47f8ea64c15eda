// Reads a Wavefront OBJ.
#include "tools/common/whole_file.h"
#include "tools/radiosity/read/mesh_builder.h"
#include "tools/radiosity/read/mtl_reader.h"
#include "tools/radiosity/read/text_lines.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace odraz::radiosity {

namespace {

constexpr const char *kKeywords[] = {"v", "vt", "f", "fo", "usemtl", "mtllib", "o", "g"};
constexpr int kFirstOfNames = 4; // names follow the keywords from here on
// Notes on lines that are left out, by keyword
const std::map<std::string_view, const char *> kLeftOut = {
    {"p", "points and lines are left out"},     {"l", "points and lines are left out"},
    {"surf", "surfaces are left out"},          {"bzp", "surfaces are left out"},
    {"bsp", "surfaces are left out"},           {"usemap", "pictures of polygons (usemap) are not used"},
    {"call", "other files (call) are not read"}};
const std::set<std::string_view> kCommands = {"v", "vn", "vt", "vp", "f",      "fo",    "l",
                                              "p", "o",  "g",  "s",  "usemtl", "mtllib"};

struct ObjContent {
    Polygons polygons;                  // materials are indices into `asked`
    std::vector<std::string> libraries; // the text after each mtllib
    std::vector<std::string> asked;     // names given by usemtl, each once
    std::vector<std::string> notes;
};

class ObjReader : ObjContent {
public:
    explicit ObjReader(const std::string &path) : path(path), lines(path) {}

    ObjContent read() {
        if (!lines.isText && !isObj(common::readStart(path, 4096))) refuseFormat();
        while (lines.next()) {
            int keyword = lines.keyword(kKeywords);
            commands += keyword >= 0 || kCommands.count(lines.word);
            // Remove a comment. Names may contain a #
            if (keyword < kFirstOfNames) lines.rest = lines.rest.substr(0, lines.rest.find('#'));
            // In the order of the keywords
            static constexpr void (ObjReader::*kReaders[])() = {
                &ObjReader::readPoint,   &ObjReader::readCoordinate,
                &ObjReader::readPolygon, &ObjReader::readPolygon,
                &ObjReader::use,         &ObjReader::addLibrary,
                &ObjReader::beginObject, &ObjReader::beginGroup};
            static_assert(std::size(kReaders) == std::size(kKeywords));
            if (keyword >= 0) {
                auto read = kReaders[keyword];
                (this->*read)();
            } else if (auto found = kLeftOut.find(lines.word); found != kLeftOut.end())
                note(found->second);
        }
        if (polygons.points.empty() && lines.number > 0 && !commands) refuseFormat();
        if (largest > (int)polygons.points.size())
            refuse(largestLine, "there is no point " + std::to_string(largest) + ": the file has " +
                                    std::to_string(polygons.points.size()));
        for (const auto &[word, keyword] : lines.otherCase)
            notes.push_back(path + ": " + word + " is read as " + keyword);
        for (const auto &[what, in] : unused)
            notes.push_back(path + ": " + std::string(what) + ": line " + std::to_string(in[0]) +
                            (in.size() > 1 ? " and " + std::to_string(in.size() - 1) + " more" : ""));
        return std::move(*this);
    }

private:
    const std::string &path;
    TextLines lines;
    std::map<std::string, int, std::less<>> numberOf; // a name's index in `asked`
    int material = -1, objectNumber = -1;
    MeshObject object;                 // the current one
    std::map<MeshObject, int> objects; // its index in `polygons`
    size_t commands = 0;               // number of lines with a command of OBJ
    int largest = 0;                   // largest point number in a polygon, and the polygon's line
    size_t largestLine = 0;
    std::map<std::string_view, std::vector<size_t>> unused; // features that are not used, and their lines
    void note(const char *kind) { unused[kind].push_back(lines.number); }

    [[noreturn]] void refuseFormat() const {
        throw ModelError(path + ": is neither Wavefront OBJ nor glTF 2.0 (.gltf, .glb), which are read");
    }
    [[noreturn]] void refuse(size_t line, const std::string &what) const {
        throw ModelError(path + ":" + std::to_string(line) + ": " + what);
    }

    // For an error: the next word followed by `what`, or nothing at the end of the line.
    std::string nextIs(const char *what) const {
        std::string_view rest = lines.rest, word = takeWord(rest);
        return word.empty() ? "" : ": " + std::string(word.substr(0, 40)) + what;
    }

    void readPoint() {
        Vec3d p;
        for (size_t k = 0; k < 3; ++k) {
            if (!takeNumber(lines.rest, p[k]))
                refuse(lines.number, "a point needs three coordinates" + nextIs(" is not a number"));
            if (!(std::fabs(p[k]) < 1e18)) refuse(lines.number, "a coordinate is not a number below 1e18");
        }
        polygons.points.push_back(p);
        double weight = 0;
        if (!lines.rest.empty() && !(takeNumber(lines.rest, weight) && lines.rest.empty() && weight == 1))
            note(lines.rest.empty() ? "weights of points are not used" : "colours of points are not used");
    }

    void readCoordinate() {
        double u = NAN, v = 0; // v may be missing
        if (!takeNumber(lines.rest, u) || !(lines.rest.empty() || takeNumber(lines.rest, v)) ||
            !std::isfinite(u + v))
            u = NAN, note("coordinates of pictures (vt) are not numbers");
        polygons.coordinates.push_back({(float)u, (float)v});
    }

    void readPolygon() {
        polygons.polygons.push_back({polygons.corners.size(), material, (int)lines.number, objectNumber});
        while (!lines.rest.empty()) polygons.corners.push_back(corner(takeWord(lines.rest)));
    }

    // POINT, POINT/COORDINATE, POINT//NORMAL or POINT/COORDINATE/NORMAL. An empty COORDINATE or 0 means none.
    Polygons::Corner corner(std::string_view word) {
        int numbers[3] = {};
        const char *p = word.data(), *end = p + word.size();
        for (int k = 0;; ++k, ++p) {
            auto [stop, error] = std::from_chars(p, end, numbers[k]);
            if ((k == 0 && stop == p) || error == std::errc::result_out_of_range ||
                (stop < end && (*stop != '/' || k == 2)))
                refuse(lines.number,
                       "a polygon's points are numbers, not " + std::string(word.substr(0, 40)));
            p = stop;
            if (p == end) break;
        }
        const int point = numbers[0], before = (int)polygons.points.size();
        if (point == 0 || point < -before)
            refuse(lines.number, "there is no point " + std::to_string(point) + " before this polygon");
        if (point > largest) largest = point, largestLine = lines.number;
        int coordinate = numbers[1] < 0 ? numbers[1] + (int)polygons.coordinates.size() : numbers[1] - 1;
        return {point < 0 ? before + point : point - 1, coordinate};
    }

    void addLibrary() {
        if (!lines.rest.empty()) libraries.emplace_back(lines.rest);
    }

    // An `o` ends the group, because most programs write only one of the two.
    void beginObject() { begin({std::string(lines.rest), ""}); }
    void beginGroup() { begin({object.name, std::string(lines.rest)}); }
    void begin(const MeshObject &next) {
        object = next;
        objectNumber = objects.emplace(object, (int)objects.size()).first->second;
        if ((size_t)objectNumber == polygons.objects.size()) polygons.objects.push_back(object);
    }

    void use() {
        auto found = numberOf.find(lines.rest);
        if (found == numberOf.end()) {
            found = numberOf.emplace(lines.rest, (int)asked.size()).first;
            asked.emplace_back(lines.rest);
        }
        material = found->second;
    }
};

// The Levenshtein distance of two names, regardless of case.
size_t editDistance(const std::string &a, const std::string &b) {
    std::vector<size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), (size_t)0);
    for (size_t i = 0; i < a.size(); ++i) {
        size_t diagonal = std::exchange(row[0], i + 1);
        for (size_t k = 0; k < b.size(); ++k) {
            size_t same = diagonal + (std::tolower((uint8_t)a[i]) != std::tolower((uint8_t)b[k]));
            diagonal = std::exchange(row[k + 1], std::min({same, row[k] + 1, row[k + 1] + 1}));
        }
    }
    return row[b.size()];
}

// Finds each name's material: its index in `materials`, or -1.
std::vector<int> findMaterials(const std::vector<std::string> &names,
                               const std::vector<MeshMaterial> &materials) {
    std::map<std::string, int> indexOf;
    for (size_t i = 0; i < materials.size(); ++i) indexOf.try_emplace(materials[i].name, (int)i);
    std::vector<int> found;
    for (const std::string &name : names) {
        auto at = indexOf.find(name);
        found.push_back(at == indexOf.end() ? -1 : at->second);
    }
    return found;
}

// Adds a note for each used name that no material has, with the nearest name.
void noteUnknown(const std::string &path, const ObjContent &content, const std::vector<int> &found,
                 const std::vector<bool> &used, const std::vector<MeshMaterial> &materials,
                 std::vector<std::string> &notes) {
    if (materials.empty() && !content.libraries.empty()) return; // a note reports why they were not read
    constexpr size_t kMost = 20;
    size_t count = 0;
    for (size_t i = 0; i < found.size(); ++i) {
        const std::string &name = content.asked[i];
        if (found[i] >= 0 || !used[i] || name.empty() || ++count > kMost) continue;
        auto nearest = std::min_element(materials.begin(), materials.end(), [&](auto &a, auto &b) {
            return editDistance(name, a.name) < editDistance(name, b.name);
        });
        notes.push_back(path + ": no material file has " + name + ": it reflects 0.7" +
                        (nearest == materials.end() ? "" : "; the nearest name is " + nearest->name));
    }
    if (count > kMost)
        notes.push_back(path + ": no material file has " + std::to_string(count - kMost) + " more names");
}

// Whether a lamp is an open surface, with an edge beside which no other lamp lies.
bool hasOpenLamps(const Mesh &mesh) {
    std::set<std::pair<int, int>> edges;
    for (const Triangle &t : mesh.triangles)
        if (mesh.materials[(size_t)t.material].shines())
            for (size_t k = 0; k < 3; ++k) edges.emplace(t.corners[k], t.corners[(k + 1) % 3]);
    return std::any_of(edges.begin(), edges.end(), [&](auto e) { return !edges.count({e.second, e.first}); });
}

} // namespace

bool isObj(std::string_view start) {
    if (start.starts_with("\xef\xbb\xbf")) start.remove_prefix(3);
    start.remove_prefix(std::min(start.find_first_not_of(" \t\r\n"), start.size()));
    return start.starts_with('#') || kCommands.count(start.substr(0, start.find_first_of(" \t\r\n")));
}

Mesh readObj(const std::string &path, const ReadSettings &settings, std::vector<std::string> &notes) {
    ObjContent content = ObjReader(path).read();
    notes.insert(notes.end(), content.notes.begin(), content.notes.end());
    std::vector<MeshMaterial> materials = readMaterials(path, content.libraries, notes);
    std::vector<int> found = findMaterials(content.asked, materials);
    std::vector<bool> used(content.asked.size());
    for (Polygons::Polygon &p : content.polygons.polygons)
        if (p.material >= 0) used[(size_t)p.material] = true, p.material = found[(size_t)p.material];
    noteUnknown(path, content, found, used, materials, notes);
    Mesh mesh = buildMesh(path, std::move(content.polygons), std::move(materials), settings, notes);
    if (!settings.twoSided && hasOpenLamps(mesh) &&
        !common::readStart(path, sizeof kGeneratedObj).starts_with(kGeneratedObj))
        notes.push_back(path + ": its lamps shine on one side here, in Blender on both (--two-sided)");
    return mesh;
}

} // namespace odraz::radiosity
