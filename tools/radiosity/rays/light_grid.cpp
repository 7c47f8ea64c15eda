#include "tools/radiosity/rays/light_grid.h"

#include "tools/radiosity/divide/facets.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

std::vector<RayTree::Corners> cornersOf(const Mesh &mesh) {
    std::vector<RayTree::Corners> all(mesh.triangles.size());
    for (size_t i = 0; i < all.size(); ++i)
        for (size_t k = 0; k < 3; ++k) all[i][k] = toFloat(mesh.points[(size_t)mesh.triangles[i].corners[k]]);
    return all;
}

std::vector<RayTree::Corners> cornersOf(std::span<const Facet> facets, const Chart *charts,
                                        std::vector<int> &chartOf) {
    std::vector<RayTree::Corners> all;
    for (const Facet &f : facets)
        for (int k = 2; k < (f.triangle() ? 3 : 4); ++k) {
            const Chart &c = charts[f.chart];
            all.push_back({f.corner(c, 0), f.corner(c, k - 1), f.corner(c, k)});
            chartOf.push_back(f.chart);
        }
    return all;
}

LightGrid::LightGrid(const Mesh &mesh, Regions &regions, Workers &workers, int block)
    : regions(regions), tree(cornersOf(mesh)), charts(regions.charts) {
    divide(std::max(block, 1));
    makeSites(findVisible(workers));
    orderHidden();
    if (block > 0) return;
    for (Cell &cell : cells) {
        auto seen =
            std::find_if(cell.corner, cell.corner + 4, [&](int t) { return siteOf[(size_t)t] != kNone; });
        if (seen != cell.corner + 4) cell.patch = (int)siteOf[(size_t)*seen];
    }
}

void LightGrid::divide(int block) {
    size_t cellCount = 0, texelCount = 0;
    int patchCount = 0;
    // Choose the nearest whole number of patches, then the nearest number of cells that fills them
    auto whole = [&](int16_t &count, int16_t &patches) {
        int blocks = std::max((count + block / 2) / block, 1);
        patches = (int16_t)blocks;
        count = (int16_t)(std::max((count + blocks / 2) / blocks, 1) * blocks);
    };
    for (Chart &c : charts) {
        whole(c.across, c.patchesAcross), whole(c.down, c.patchesDown);
        c.firstCell = (int)cellCount, c.firstTexel = (int)texelCount, c.firstPatch = patchCount;
        cellCount += (size_t)c.across * (size_t)c.down, texelCount += (size_t)c.texels();
        if (texelCount > 0x7ffffff0)
            throw std::runtime_error("there are too many elements: make --element larger");
        patchCount += c.patchesAcross * c.patchesDown;
    }
    cells.resize(cellCount), texels.resize(texelCount);
    for (size_t index = 0; index < charts.size(); ++index) {
        const Chart &c = charts[index];
        for (int j = 0; j <= c.down; ++j)
            for (int i = 0; i <= c.across; ++i)
                texels[(size_t)c.texel(i, j)] = {(int)index, i, j, 0, 0, false};
        float area = c.width * c.height / (float)(c.across * c.down);
        for (int j = 0; j < c.down; ++j)
            for (int i = 0; i < c.across; ++i) {
                int t = c.texel(i, j), below = t + c.across + 1;
                int patch = c.firstPatch + j / c.patchDown() * c.patchesAcross + i / c.patchAcross();
                cells[(size_t)(c.firstCell + j * c.across + i)] = {
                    {t, t + 1, below, below + 1}, patch, (int)index, area};
            }
    }
}

Vec3 LightGrid::at(const Texel &t) const {
    const Chart &c = charts[(size_t)t.chart];
    return c.at((float)t.x * c.width / (float)c.across, (float)t.y * c.height / (float)c.down);
}

LightGrid::Spot LightGrid::spotAt(int chart, const Vec3 &p) const {
    const Chart &c = charts[(size_t)chart];
    Vec3 d = p - c.corner;
    float x = std::clamp(dot(d, c.u) / c.width, 0.f, 1.f) * (float)c.across,
          y = std::clamp(dot(d, c.v) / c.height, 0.f, 1.f) * (float)c.down;
    int i = std::min((int)x, c.across - 1), j = std::min((int)y, c.down - 1);
    return {&cells[(size_t)(c.firstCell + j * c.across + i)], x - (float)i, y - (float)j};
}

float LightGrid::weigh(const Spot &spot, float (&weight)[4]) const {
    float sum = 0;
    for (int k = 0; k < 4; ++k) {
        bool hasSite = siteOf[(size_t)spot.cell->corner[k]] != kNone;
        weight[k] = hasSite ? (k & 1 ? spot.x : 1 - spot.x) * (k & 2 ? spot.y : 1 - spot.y) + 1e-6f : 0;
        sum += weight[k];
    }
    return sum;
}

// --- Visible texels ---

// Sample point `number` of a texel, in the plane of its chart.
static Vec3 planePoint(const Chart &c, const Texel &t, int number) {
    float x = (float)t.x + (number & 1 ? 0.25f : -0.25f), y = (float)t.y + (number & 2 ? 0.25f : -0.25f);
    return c.at(x * c.width / (float)c.across, y * c.height / (float)c.down);
}

bool LightGrid::surfacePoint(int chart, const Vec3 &p, Vec3 &to) const {
    const Chart &c = charts[(size_t)chart];
    float height = c.off() * 4 + regions.deviation[(size_t)chart] * 2;
    RayHit below = tree.nearest(p + c.n * height, -c.n);
    if (below.triangle < 0 || below.t > 2 * height || regions.chartOf[(size_t)below.triangle] != chart)
        return false;
    to = p + c.n * height - c.n * (below.t - c.off());
    return true;
}

// Whether rays to all sides hit backs, as inside a closed body. No ray goes straight up, where it would leave
// an open tube.
static bool inside(const RayTree &tree, const Chart &c, const Vec3 &p) {
    for (int i = 0; i < 8; ++i) {
        float slant = i & 2 ? 0.5f : 2.f, a = (i & 1 ? -slant : slant) * 0.8f,
              b = (i & 4 ? -slant : slant) * 0.6f;
        if (!tree.nearest(p, normalize(c.n + c.u * (i & 4 ? -a : a) + c.v * b)).back) return false;
    }
    return true;
}

std::vector<Vec3> LightGrid::findVisible(Workers &workers) {
    std::vector<Vec3> all(texels.size() * 4);
    parallelRanges(workers, (int)texels.size(), 1024, [&](int first, int end, int) {
        for (int i = first; i < end; ++i) {
            Texel &t = texels[(size_t)i];
            const Chart &c = charts[(size_t)t.chart];
            for (int k = 0; k < 4; ++k) {
                if ((k & 1 ? t.x == c.across : t.x == 0) || (k & 2 ? t.y == c.down : t.y == 0)) continue;
                Vec3 &p = all[(size_t)i * 4 + (size_t)k];
                if (surfacePoint(t.chart, planePoint(c, t, k), p) && !inside(tree, c, p))
                    t.visible |= (uint8_t)(1 << k);
            }
        }
    });
    return all;
}

void LightGrid::makeSites(const std::vector<Vec3> &found) {
    siteOf.assign(texels.size(), kNone);
    for (size_t index = 0; index < charts.size(); ++index) {
        const Chart &c = charts[index];
        bool small = c.across == 1 && c.down == 1;
        double area = (double)(c.width * c.height / (float)(c.across * c.down));
        if (small) {
            area = 0;
            for (int f = c.firstFacet; f < c.firstFacet + c.facetCount; ++f)
                area += areaOf(outlineOf(regions.facets[(size_t)f]));
        }
        for (int t = c.firstTexel; t < c.firstTexel + c.texels(); ++t) {
            auto first = (uint32_t)points.size();
            for (size_t k = 0; k < 4; ++k)
                if (texels[(size_t)t].visible >> k & 1) points.push_back({found[(size_t)t * 4 + k], t});
            if (points.size() == first) continue;
            if (!small || sites.empty() || sites.back().chart != (int)index)
                sites.push_back({first, 0, small, (int)index, std::sqrt((float)area)});
            sites.back().pointCount = (uint16_t)(points.size() - sites.back().firstPoint);
            siteOf[(size_t)t] = (uint32_t)(sites.size() - 1);
        }
    }
}

// --- Hidden texels ---

// Visits a texel's neighbours on its chart, diagonal ones too.
template <class Visit> static void forNeighbours(const Chart &c, int texel, const Visit &visit) {
    int columns = c.across + 1, i = (texel - c.firstTexel) % columns, j = (texel - c.firstTexel) / columns;
    for (int y = std::max(j - 1, 0); y <= std::min(j + 1, (int)c.down); ++y)
        for (int x = std::max(i - 1, 0); x <= std::min(i + 1, (int)c.across); ++x)
            if (x != i || y != j) visit((size_t)c.texel(x, y));
}

void LightGrid::orderHidden() {
    constexpr uint16_t kUnvisited = 0xffff;
    ring.assign(texels.size(), kUnvisited);
    // Visit hidden texels outwards from visible ones, ring by ring
    std::vector<int> front;
    for (size_t t = 0; t < texels.size(); ++t)
        if (texels[t].visible) ring[t] = 0, front.push_back((int)t);
    for (uint16_t number = 1; !front.empty() && number < kUnvisited; ++number) {
        std::vector<int> next;
        for (int t : front)
            forNeighbours(charts[(size_t)texels[(size_t)t].chart], t, [&](size_t k) {
                if (ring[k] != kUnvisited) return;
                ring[k] = number, texels[k].filled = true;
                next.push_back((int)k);
            });
        hidden.insert(hidden.end(), next.begin(), next.end());
        front = std::move(next);
    }
}

void LightGrid::fill(std::vector<Rgb> &light) const {
    for (int t : hidden) {
        Rgb sum = {};
        int count = 0;
        forNeighbours(charts[(size_t)texels[(size_t)t].chart], t, [&](size_t k) {
            if (ring[k] < ring[(size_t)t]) sum += light[k], ++count;
        });
        light[(size_t)t] = sum * (1 / (float)count);
    }
}

} // namespace odraz::radiosity
