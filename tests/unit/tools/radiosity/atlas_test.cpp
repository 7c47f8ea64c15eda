// Tests that lightmaps show the solution in other programs, and that polygons share no texels.
#include "tests/support/exported.h"
#include "tests/support/headless_gl.h"
#include "tests/support/read_model.h"
#include "tools/common/folders.h"
#include "tools/picture/psnr.h"
#include "tools/radiosity/export/atlas.h"
#include "tools/radiosity/solve/solve.h"
#include "tools/support/machine.h"

using namespace odraz;
using namespace odraz::radiosity;

// The generated room `cube` with scattered triangles.
static Solution solved() {
    Mesh mesh = generatedMesh("cube");
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1, 1);
    auto place = [&](double size) { return Vec3d{number(random), number(random), number(random)} * size; };
    for (int i = 0; i < 60; ++i) {
        Vec3d at = place(3) + Vec3d{0, 4, 0};
        int first = (int)mesh.points.size();
        for (int k = 0; k < 3; ++k) mesh.points.push_back(at + place(1));
        mesh.triangles.push_back({{first, first + 1, first + 2}, mesh.triangles.back().material});
    }
    static Workers workers = allProcessors();
    SolveSettings settings;
    settings.element = areaOf(mesh) / 8000;
    return solveModel(mesh, settings, headlessGl(), workers, &kNever, {}).solution;
}

static const Solution &room() {
    static const Solution b = solved();
    return b;
}

struct Element {
    int chart, cell;
    Vec3 middle;
    Rgb radiosity; // mean over its triangles, as in the CSV
    float area;
};
static std::vector<Element> elementsOf(const Solution &b) {
    std::vector<Element> all;
    b.forPieces([&](int chart, int cell, const std::vector<SolutionPoint> &piece) {
        if (all.empty() || cell != all.back().cell) all.push_back({chart, cell, {}, {}, 0});
        Element &e = all.back();
        for (size_t i = 2; i < piece.size(); ++i) {
            const SolutionPoint *t[3] = {&piece[0], &piece[i - 1], &piece[i]};
            float third = length(cross(t[1]->p - t[0]->p, t[2]->p - t[0]->p)) / 6;
            for (const SolutionPoint *q : t) e.middle += q->p * third, e.radiosity += q->radiosity * third;
            e.area += 3 * third;
        }
    });
    for (Element &e : all) e.middle = e.middle * (1 / e.area), e.radiosity = e.radiosity * (1 / e.area);
    return all;
}

static float most(const Rgb &c) { return std::max({std::fabs(c.x), std::fabs(c.y), std::fabs(c.z)}); }

// Differences between exported pages and the solution, in the middles of elements. `worst`: the largest
// difference from the solution's light, as a share of the largest of red, green and blue, because a page
// stores eight bits. `rmsOfTable`: the rms difference from the means in the CSV.
struct Difference {
    float worst = 0;
    double rmsOfTable = 0;
    int count = 0, lost = 0;
};
static Difference compare(const Solution &b, const Exported &out) {
    Difference d;
    float mean = 0;
    std::vector<Element> elements = elementsOf(b);
    for (const Element &e : elements) mean += most(e.radiosity) / (float)elements.size();
    for (const Element &e : elements) {
        Rgb shown;
        if (!out.radianceAt(e.chart, e.middle, shown)) {
            ++d.lost; // it falls between two parts of its polygon
            continue;
        }
        const Chart &c = b.charts[(size_t)e.chart];
        Vec3 p = e.middle - c.corner;
        Rgb exact =
            b.lightIn(e.cell, dot(p, c.u), dot(p, c.v)) * b.reflectsOf(e.cell) + b.emits[(size_t)e.chart];
        float share = most(shown - e.radiosity) / (most(e.radiosity) + 0.02f * mean);
        d.worst = std::max(d.worst, most(shown - exact) / (most(exact) + 1e-4f * mean));
        d.rmsOfTable += (double)(share * share);
        ++d.count;
    }
    d.rmsOfTable = std::sqrt(d.rmsOfTable / d.count);
    return d;
}

static Exported exported(const Solution &b, const AtlasSettings &s) {
    common::TemporaryFolder folder;
    std::vector<std::string> notes;
    exportAtlas(b, s, folder / "out", notes);
    return Exported(folder / "out", s.radiosity ? "radiosity" : "light");
}

TEST(Atlas, ShowsTheSolution) {
    for (bool radiosity : {false, true}) {
        const AtlasSettings s = {.radiosity = radiosity};
        Exported out = exported(room(), s);
        out.mustHaveGap(2 * s.padding);
        Difference d = compare(room(), out);
        EXPECT_GT(d.count, 2000);
        EXPECT_LT(d.lost, d.count / 100);
        EXPECT_LT(d.worst, 1 / 150.f); // more than one 8-bit step, because light is redder than surfaces
        EXPECT_LT(d.rmsOfTable, 0.01);
    }
}

TEST(Atlas, TakesSeveralPagesAndWiderPadding) {
    Exported out = exported(room(), {.padding = 9, .page = 128});
    EXPECT_GT(out.pages.size(), 1u);
    for (const ExportedPage &p : out.pages) EXPECT_TRUE(p.width <= 128 && p.height <= 128);
    out.mustHaveGap(18);
    EXPECT_LT(compare(room(), out).worst, 1 / 150.f);
}

TEST(Atlas, HasFewerTexelsOnDemand) {
    const AtlasSettings s = {.texels = 2};
    Exported out = exported(room(), s);
    out.mustHaveGap(4);
    Difference d = compare(room(), out);
    EXPECT_EQ(d.lost, 0);
    EXPECT_LT(d.rmsOfTable, 0.03); // a step of eight bits
    EXPECT_LT(d.worst, 0.5);       // nothing is black
    EXPECT_LT(packAtlas(room(), s).used, packAtlas(room(), {}).used);
    EXPECT_GT(compare(room(), exported(room(), {.texels = 1})).rmsOfTable, 2 * d.rmsOfTable);
}

// The texels around a chart repeat its border. Pages of eight bits agree with pages of floats.
TEST(Atlas, PadsAndScales) {
    AtlasSettings s;
    Atlas atlas = packAtlas(room(), s);
    std::vector<float> page = paintPage(room(), atlas, 0, PageContent::Light);
    Exported out = exported(room(), s);
    int width = atlas.pages[0].width;
    auto texel = [&](int x, int y, int k) { return page[(size_t)(y * width + x) * 3 + (size_t)k]; };
    for (const AtlasPlace &p : atlas.places)
        for (int k = 0; k < 3; ++k) {
            EXPECT_EQ(texel(p.x - s.padding, p.y - s.padding, k), texel(p.x, p.y, k));
            EXPECT_EQ(texel(p.x + p.across + s.padding - 1, p.y, k), texel(p.x + p.across - 1, p.y, k));
            EXPECT_EQ(texel(p.x, p.y + p.down + s.padding - 1, k), texel(p.x, p.y + p.down - 1, k));
        }
    const ExportedPage &got = out.pages[0];
    std::vector<double> scales;
    for (size_t i = 0; i < got.png.size(); ++i)
        if (got.png[i] > 60 && got.png[i] < 250)
            scales.push_back((double)got.hdr[i] / pictures::linearOfSrgb(got.png[i]));
    EXPECT_GT(scales.size(), 1000u);
    double mean = std::accumulate(scales.begin(), scales.end(), 0.) / (double)scales.size();
    for (double scale : scales) EXPECT_NEAR(scale / mean, 1, 0.03); // a step of eight bits
}

// A scanned figure, in which every triangle is a chart.
TEST(Atlas, HoldsManySmallTriangles) {
    constexpr int kMany = 300000;
    Solution b;
    for (int i = 0; i < kMany; ++i) {
        Chart c = {};
        c.corner = {(float)(i % 1000), 0, (float)(i / 1000)}, c.u = {1, 0, 0}, c.v = {0, 0, -1},
        c.n = {0, 1, 0};
        c.width = c.height = 1, c.across = c.down = c.patchesAcross = c.patchesDown = 1;
        c.firstCell = i, c.firstTexel = 4 * i, c.firstFacet = i, c.facetCount = 1;
        b.charts.push_back(c);
        b.facets.push_back({i, {0, 1, 0, 0}, {0, 0, 1, 1}});
        b.cells.push_back({{4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3}, i, i, 1});
        for (int k = 0; k < 4; ++k) {
            b.texels.push_back({i, k % 2, k / 2, 15, 0, false});
            b.light.push_back({(float)i, (float)k, 1});
        }
        b.reflects.push_back({0.5f, 0.5f, 0.5f}), b.emits.push_back({});
    }
    Atlas atlas = packAtlas(b, {});
    ASSERT_EQ(atlas.pages.size(), 1u);
    EXPECT_EQ(atlas.used, (int64_t)kMany * 36);
    int64_t size = (int64_t)atlas.pages[0].width * atlas.pages[0].height;
    EXPECT_LT((double)size, 1.05 * (double)atlas.used);
    std::vector<float> page = paintPage(b, atlas, 0, PageContent::Light);
    std::vector<bool> taken((size_t)size);
    for (int i = 0; i < kMany; ++i) {
        const AtlasPlace &p = atlas.places[(size_t)i];
        for (int k = 0; k < 36; ++k) {
            size_t at = (size_t)((p.y - 2 + k / 6) * atlas.pages[0].width + p.x - 2 + k % 6);
            ASSERT_FALSE(taken[at]);
            taken[at] = true;
            ASSERT_EQ(page[at * 3], (float)i);
            ASSERT_EQ(page[at * 3 + 1], (float)((k % 6 > 2) + 2 * (k / 6 > 2)));
        }
    }
}
