#include "tools/radiosity/export/atlas.h"

#include "tools/radiosity/divide/facets.h"

#include <algorithm>
#include <cmath>
#include <map>

#define STB_RECT_PACK_IMPLEMENTATION
#define STBRP_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_rect_pack.h>
#pragma GCC diagnostic pop

namespace odraz::radiosity {

namespace {

// Rounds up to a multiple of 4, as compressed textures need.
int roundedUp(double x) { return ((int)std::ceil(x) + 3) / 4 * 4; }

// Finds the number of texels along each chart's sides.
void sizeCharts(const Solution &b, Atlas &atlas) {
    const AtlasSettings &s = atlas.settings;
    std::vector<uint8_t> pictured(b.charts.size());
    for (size_t i = 0; i < b.cells.size(); ++i) {
        const Cell &c = b.cells[i];
        size_t chart = (size_t)c.chart;
        Rgb differs = b.reflectsOf((int)i) - b.reflects[chart];
        pictured[chart] |= dot(differs, differs) > 0;
    }
    for (size_t i = 0; i < b.charts.size(); ++i) {
        const Chart &c = b.charts[i];
        AtlasPlace p = {};
        p.exact = s.texels == 0;
        p.pictured = pictured[i];
        p.within = p.pictured && (s.radiosity || p.exact);
        bool coarse = false;
        auto along = [&](float length, int cells) {
            int elements = cells * (p.within ? 2 : 1);
            double wanted = p.exact ? elements : std::clamp(std::ceil((double)length * s.texels), 1., 1e6);
            int most = s.page - 2 * s.padding - !p.within;
            coarse |= wanted > most;
            return (int)std::min<double>(wanted, most) + !p.within;
        };
        p.across = along(c.width, c.across), p.down = along(c.height, c.down);
        if (coarse) ++atlas.coarse, p.exact = false;
        atlas.places.push_back(p);
    }
}

// Charts of one size with padding, packed side by side. Bundles keep the number of rectangles small: a model
// may have a million charts, and the packer's time grows with the square of the number of rectangles.
struct Bundle {
    int width, height; // size of each chart
    int side;          // number of charts along a side
    std::vector<size_t> charts;
};

std::vector<Bundle> bundle(Atlas &atlas) {
    std::map<std::pair<int, int>, std::vector<size_t>> sizes;
    for (size_t i = 0; i < atlas.places.size(); ++i) {
        const AtlasPlace &p = atlas.places[i];
        int width = p.across + 2 * atlas.settings.padding, height = p.down + 2 * atlas.settings.padding;
        sizes[{width, height}].push_back(i);
        atlas.used += (int64_t)width * height;
    }
    std::vector<Bundle> bundles;
    for (const auto &[size, charts] : sizes) {
        auto [width, height] = size;
        constexpr int kSide = 8;
        bool small = std::max(width, height) * kSide <= atlas.settings.page / 4;
        for (size_t i = 0; i < charts.size();) {
            int side = small && charts.size() - i >= kSide * kSide ? kSide : 1;
            auto first = charts.begin() + (long)i;
            bundles.push_back({width, height, side, {first, first + side * side}});
            i += (size_t)(side * side);
        }
    }
    return bundles;
}

} // namespace

Atlas packAtlas(const Solution &b, const AtlasSettings &s) {
    Atlas atlas;
    atlas.settings = s;
    atlas.occupied.resize(b.cells.size());
    b.forPieces([&](int, int cell, const std::vector<SolutionPoint> &) { atlas.occupied[(size_t)cell] = 1; });
    sizeCharts(b, atlas);

    std::vector<Bundle> bundles = bundle(atlas);
    std::vector<stbrp_rect> left;
    for (size_t i = 0; i < bundles.size(); ++i)
        left.push_back(
            {(int)i, bundles[i].width * bundles[i].side, bundles[i].height * bundles[i].side, 0, 0, 0});
    while (!left.empty()) {
        // Make the page square if everything fits on it
        double area = 0;
        int widest = 1;
        for (const stbrp_rect &r : left) area += (double)r.w * r.h, widest = std::max(widest, r.w);
        int width = std::min(roundedUp(std::max<double>(std::sqrt(area) * 1.02, widest)), s.page);
        std::vector<stbrp_node> nodes((size_t)width);
        stbrp_context context;
        stbrp_init_target(&context, width, s.page, nodes.data(), width);
        stbrp_pack_rects(&context, left.data(), (int)left.size());
        int height = 1;
        std::erase_if(left, [&](const stbrp_rect &r) {
            if (!r.was_packed) return false;
            const Bundle &all = bundles[(size_t)r.id];
            for (size_t k = 0; k < all.charts.size(); ++k) {
                AtlasPlace &p = atlas.places[all.charts[k]];
                p.page = (int)atlas.pages.size();
                p.x = r.x + (int)k % all.side * all.width + s.padding;
                p.y = r.y + (int)k / all.side * all.height + s.padding;
            }
            height = std::max(height, r.y + r.h);
            return true;
        });
        atlas.pages.push_back({width, std::min(roundedUp(height), s.page)});
    }
    return atlas;
}

namespace {

// Paints the texels of one chart.
class Painter {
public:
    Painter(const Solution &b, const Atlas &atlas, int chart, PageContent content)
        : b(b), atlas(atlas), content(content), chart(chart), c(b.charts[(size_t)chart]),
          place(atlas.places[(size_t)chart]), texels((size_t)(place.across * place.down)),
          painted(texels.size()) {}

    const std::vector<Rgb> &paint() {
        for (int j = 0; j < place.down; ++j)
            for (int i = 0; i < place.across; ++i) painted[at(i, j)] = find(i, j, texels[at(i, j)]);
        // Fill texels outside facets from their neighbours, because mipmaps include them
        for (int ring = 0; ring < 2 * atlas.settings.padding; ++ring)
            if (!spread()) break;
        return texels;
    }

private:
    const Solution &b;
    const Atlas &atlas;
    PageContent content;
    int chart;
    const Chart &c;
    const AtlasPlace &place;
    std::vector<Rgb> texels;
    std::vector<uint8_t> painted;

    size_t at(int i, int j) const { return (size_t)(j * place.across + i); }

    Rgb valueIn(int cell, float u, float v) const {
        switch (content) {
        case PageContent::Light:
            return b.lightIn(cell, u, v);
        case PageContent::Radiosity:
            return b.radiosityIn(cell, u, v);
        case PageContent::Reflectance:
            return b.reflectsOf(cell);
        }
        return {};
    }

    // Finds a texel's value: the mean over the occupied cells in its area or, if texels are as fine as
    // elements, the mean of these cells' values at the texel's middle. Returns false if none is occupied.
    bool find(int i, int j, Rgb &to) const {
        float u = place.uOf(c, (float)i + 0.5f), v = place.vOf(c, (float)j + 0.5f);
        float width = place.uOf(c, 1) - place.uOf(c, 0), height = place.vOf(c, 1) - place.vOf(c, 0);
        auto samples = [&](float size, float length, int cells) {
            return place.exact ? 2 : std::clamp((int)(size / length * (float)cells * 2 + 1), 2, 16);
        };
        int across = samples(width, c.width, c.across), down = samples(height, c.height, c.down), found = 0;
        Rgb sum = {};
        for (int k = 0; k < across * down; ++k) {
            float s = u + (((float)(k % across) + 0.5f) / (float)across - 0.5f) * width,
                  t = v + (((float)(k / across) + 0.5f) / (float)down - 0.5f) * height;
            if (s < 0 || t < 0 || s > c.width || t > c.height) continue;
            int cell = cellAt(c, {s, t});
            if (!atlas.occupied[(size_t)cell]) continue;
            sum += place.exact ? valueIn(cell, u, v) : valueIn(cell, s, t);
            ++found;
        }
        if (found) to = sum * (1 / (float)found);
        return found;
    }

    // Gives unpainted texels the mean of their painted neighbours. Returns false if no texel has any.
    bool spread() {
        std::vector<uint8_t> before = painted;
        bool more = false;
        for (int j = 0; j < place.down; ++j)
            for (int i = 0; i < place.across; ++i) {
                if (before[at(i, j)]) continue;
                Rgb sum = {};
                int count = 0;
                for (int y = std::max(j - 1, 0); y <= std::min(j + 1, place.down - 1); ++y)
                    for (int x = std::max(i - 1, 0); x <= std::min(i + 1, place.across - 1); ++x)
                        if (before[at(x, y)]) sum += texels[at(x, y)], ++count;
                if (!count) continue;
                texels[at(i, j)] = sum * (1 / (float)count);
                painted[at(i, j)] = more = true;
            }
        return more;
    }
};

} // namespace

std::vector<float> paintPage(const Solution &b, const Atlas &atlas, int page, PageContent content) {
    const AtlasPage &size = atlas.pages[(size_t)page];
    std::vector<float> to((size_t)size.width * (size_t)size.height * 3);
    int padding = atlas.settings.padding;
    for (size_t i = 0; i < b.charts.size(); ++i) {
        const AtlasPlace &p = atlas.places[i];
        if (p.page != page) continue;
        Painter painter(b, atlas, (int)i, content);
        const std::vector<Rgb> &texels = painter.paint();
        for (int y = -padding; y < p.down + padding; ++y)
            for (int x = -padding; x < p.across + padding; ++x) {
                const Rgb &from = texels[(size_t)(std::clamp(y, 0, p.down - 1) * p.across +
                                                  std::clamp(x, 0, p.across - 1))];
                float *at = &to[((size_t)(p.y + y) * (size_t)size.width + (size_t)(p.x + x)) * 3];
                at[0] = from.x, at[1] = from.y, at[2] = from.z;
            }
    }
    return to;
}

} // namespace odraz::radiosity
