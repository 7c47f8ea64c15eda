// Hemicubes with any number of pixels along the top face. The film's hemicubes have an even number; the
// thesis's smallest has 25.
//
// With an odd px a half face is px / 2 = h + 1/2 rows high. The picture is drawn as for an even px: the faces
// begin at rows px, px + h + 1/2, 2 px and 2 px + h + 1/2. Row px + h is half the upper edge of the first
// face and half the horizon of the second one. Its content is undefined and not used: the rows next to it
// stand for its halves. The same holds for row 2 px + h.
#pragma once

#include "radiosity/form_factor.h"
#include "tools/support/heap_arena.h"

#include <span>
#include <vector>

namespace odraz::radiosity {

// Running sums of the pixels' form factors along 3 px rows, px + 1 sums for each. px may be odd.
std::vector<float> formFactorSums(int px);

// Hemicubes with 4 .. kMaxHemicube pixels along the top face, drawn by OpenGL, and their memory.
class AnyHemicubes {
public:
    // Throws std::runtime_error if OpenGL cannot draw them.
    AnyHemicubes(const Gl &gl, int px);
    AnyHemicubes(const AnyHemicubes &) = delete;
    ~AnyHemicubes() { closeHemicubes(h); }

    // Draws hemicubes at up to h.batch eyes into h.ids. Throws std::runtime_error if OpenGL fails.
    void draw(const Model &model, std::span<const Eye> eyes);
    // Draws them, and returns for each eye the form factors to all patches.
    const std::vector<std::vector<float>> &rows(const Model &model, std::span<const Eye> eyes,
                                                Workers &workers);

private:
    HeapArena memory;
    const std::vector<float> sums;
    std::vector<std::vector<float>> found;

public:
    Hemicubes h;
};

// The rows of form factors of all patches. Hidden patches, and patches that need none, have no known row.
struct FormFactorRows {
    std::vector<std::vector<Link>> of; // of[i]: the row of patch i
    std::vector<uint8_t> known;

    explicit FormFactorRows(size_t patches) : of(patches), known(patches) {}
    // The light that arrives at a patch if the patches have these radiosities.
    Rgb gather(int patch, const std::vector<Rgb> &radiosity) const {
        Rgb sum = {};
        for (const Link &link : of[(size_t)patch]) sum += radiosity[link.patch] * link.share;
        return sum;
    }
    // The columns of the system: column i has the shares F_ji of patch i in the rows of all patches.
    std::vector<std::vector<Link>> columns() const {
        std::vector<std::vector<Link>> all(of.size());
        for (size_t j = 0; j < of.size(); ++j)
            for (const Link &link : of[j]) all[link.patch].push_back({(uint32_t)j, link.share});
        return all;
    }
};

} // namespace odraz::radiosity
