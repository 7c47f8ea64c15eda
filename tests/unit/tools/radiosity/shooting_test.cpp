// Compares shooting with gathering, Gauss-Seidel and a direct solution in double precision, and odd
// hemicubes' pixels with their sum. (The tests radiosity and radiosity_study compare shots by hemicubes, from
// patches and from blocks, with rows; radiosity_light compares the form factors of odd hemicubes with closed
// forms.)
#include "tests/support/dice.h"
#include "tests/support/room.h"
#include "tools/radiosity/patches/any_hemicube.h"
#include "tools/radiosity/patches/patch_system.h"
#include "tools/radiosity/patches/shooting.h"
#include "tools/support/heap_arena.h"

using namespace odraz;
using namespace odraz::radiosity;

// A system of a few patches with random form factors.
struct RandomSystem {
    int count;
    PatchSystem system;
    std::vector<Patch> &patches = system.patches;
    std::vector<Rgb> &direct = system.direct;
    std::unique_ptr<Model> &model = system.model;

    // Makes the system. As in a closed room, rows sum to 1, and area times form factor is the same both ways
    RandomSystem(int patchCount, float reflects, float light, unsigned seed) : count(patchCount) {
        patches.resize((size_t)count), system.rows = FormFactorRows((size_t)count);
        std::vector<std::vector<Link>> &links = system.rows.of;
        Dice dice(seed);
        for (size_t i = 0; i < patches.size(); ++i) {
            patches[i].share = 1;
            patches[i].reflects = {reflects, reflects * 0.5f, 0};
            direct.push_back(i == 0 || dice(0, 1) < 0.3f ? Rgb{light, light * dice(0, 1), light} : Rgb{});
            for (size_t j = 0; j < i; ++j) {
                if (dice(0, 1) > 0.7f) continue;
                float exchange = dice(0.01f, 1);
                links[i].push_back({(uint32_t)j, exchange}), links[j].push_back({(uint32_t)i, exchange});
            }
        }
        for (size_t i = 0; i < patches.size(); ++i) {
            float sum = std::accumulate(links[i].begin(), links[i].end(), 0.f,
                                        [](float s, const Link &link) { return s + link.share; });
            for (Link &link : links[i]) link.share /= sum;
            patches[i].area = links[i].empty() ? 1 : sum;
        }
        model->patches = patches.data(), model->patchCount = count;
    }

    // Solves (1 - rho F) B = rho D by elimination, for a channel. The diagonal dominates, so no pivots are
    // needed
    std::vector<double> solvedDirectly(float Rgb::*channel) const {
        auto n = (size_t)count;
        std::vector<std::vector<double>> m(n, std::vector<double>(n + 1));
        for (size_t i = 0; i < n; ++i) {
            double rho = (double)(patches[i].reflects.*channel);
            m[i][i] += 1;
            for (const Link &link : system.rows.of[i]) m[i][link.patch] -= rho * (double)link.share;
            m[i][n] = rho * (double)(direct[i].*channel);
        }
        for (size_t c = 0; c < n; ++c)
            for (size_t r = 0; r < n; ++r) {
                if (r == c || m[r][c] == 0) continue;
                double factor = m[r][c] / m[c][c];
                for (size_t k = c; k <= n; ++k) m[r][k] -= factor * m[c][k];
            }
        std::vector<double> b;
        for (size_t i = 0; i < n; ++i) b.push_back(m[i][n] / m[i][i]);
        return b;
    }

    Shooting shooting() const {
        return {*model, patchesAlone(*model), std::vector<Rgb>(patches.size()), direct};
    }
    // Shoots until less than the residual is left. Returns the number of shots
    int shoot(Shooting &shooting, double residual) const {
        const auto columns = system.rows.columns();
        int shots = 0;
        for (; shooting.left() > residual && shots < 1000000; ++shots) {
            int k = shooting.brightest(1)[0];
            Shooting::Shot shot = shooting.nextShot(k);
            shooting.distribute(shot.power * (1 / patches[(size_t)shot.patch].area),
                                columns[(size_t)shot.patch]);
        }
        return shots;
    }
};

TEST(Shooting, GatheringAndGaussSeidelAgreeWithTheDirectSolution) {
    for (float reflects : {0.f, 0.3f, 0.8f, 0.98f})
        for (int count : {2, 3, 20, 90}) {
            RandomSystem room(count, reflects, 10, (uint32_t)count);
            std::vector<Rgb> once = room.system.reflectDirect(), next((size_t)count);
            for (int sweeps = 0; room.system.sweep(once, true) > 1e-6f && sweeps < 10000;) ++sweeps;
            for (int pass = 0; pass < (reflects > 0.9f ? 1000 : 100); ++pass) room.system.sweep(next, false);
            Shooting shooting = room.shooting();
            EXPECT_DOUBLE_EQ(shooting.left(), reflects > 0 ? 1 : 0);
            room.shoot(shooting, 1e-6);
            EXPECT_LE(shooting.left(), 1e-6);
            const std::vector<Rgb> shot = shooting.radiosity();
            for (float Rgb::*channel : {&Rgb::x, &Rgb::y, &Rgb::z}) {
                std::vector<double> exact = room.solvedDirectly(channel);
                double off = 1e-4 * *std::max_element(exact.begin(), exact.end()) + 1e-9;
                for (size_t i = 0; i < exact.size(); ++i)
                    for (const Rgb &found : {shot[i], once[i], next[i]})
                        ASSERT_NEAR(found.*channel, exact[i], off) << reflects << ' ' << count << ' ' << i;
            }
        }
}

// A geometric series bounds the radiosity that the unshot light would still add.
TEST(Shooting, TheResidualBoundsTheError) {
    RandomSystem room(60, 0.7f, 5, 3);
    std::vector<double> exact = room.solvedDirectly(&Rgb::x);
    double put = 0;
    for (size_t i = 0; i < 60; ++i) {
        Rgb d = room.patches[i].reflects * room.direct[i];
        put += (double)((d.x + d.y + d.z) * room.patches[i].area);
    }
    int before = 0;
    for (double residual : {0.1, 1e-2, 1e-3, 1e-4}) {
        Shooting shooting = room.shooting();
        int shots = room.shoot(shooting, residual);
        EXPECT_GT(shots, before);
        before = shots;
        double missing = 0;
        for (size_t i = 0; i < 60; ++i) {
            double b = (double)shooting.radiosity()[i].x;
            EXPECT_LE(b, exact[i] * (1 + 1e-4)) << residual; // radiosity only grows
            missing += (exact[i] - b) * (double)room.patches[i].area;
        }
        EXPECT_GE(missing, -1e-4 * put);
        EXPECT_LE(missing, residual * put / (1 - 0.7) + 1e-5 * put);
    }
}

TEST(Shooting, NoLightNoLampsNoPatches) {
    RandomSystem dark(10, 0.5f, 0, 1), one(1, 0.9f, 2, 1);
    Shooting none = dark.shooting();
    EXPECT_EQ(none.left(), 0);
    EXPECT_TRUE(none.brightest(5).empty());
    EXPECT_EQ(none.ambient().x, 0);
    // A patch that sees no other reflects direct light only
    Shooting alone = one.shooting();
    one.shoot(alone, 1e-9);
    EXPECT_FLOAT_EQ(alone.radiosity()[0].x, 1.8f);
    EXPECT_EQ(alone.left(), 0);
    auto empty = std::make_unique<Model>();
    EXPECT_EQ(Shooting(*empty, patchesAlone(*empty), {}, {}).left(), 0);
}

TEST(OddHemicube, PixelsSumToOne) {
    for (int px : {5, 7, 25, 51, 333, 4, 16, 50}) {
        std::vector<float> sums = formFactorSums(px);
        double sum = 0, top = 0;
        for (int y = 0; y < 3 * px; ++y) {
            float row = sums[(size_t)(y * (px + 1) + px)];
            sum += (double)row, top += (double)row * (y < px);
            // With odd px, the shared rows are not used
            bool shared = px % 2 && y >= px && (y - px) % px == px / 2;
            EXPECT_EQ(row == 0, shared) << px << ' ' << y;
        }
        EXPECT_NEAR(sum, 1, 1e-6) << px;
        EXPECT_NEAR(top, parallelFormFactor(0, 0, -1, 1, -1, 1, 1), 1e-6) << px;
    }
}
