// Tests that the film's protagonist, the point of light, is in every shot: itself, or its image in mirrors
// and glass. The images are found by rays of the test's own (Whitted's tree), so they are those of whatever
// mirrors there are.
#include "inside.h"
#include "show/point_of_light.h"
#include "tests/support/sanitized.h"
#include "tests/support/shots.h"
#include "tests/support/small_film.h"

using namespace odraz;

namespace {

constexpr int kMoments = 4;                // in each shot
constexpr int kAcross = 1280, kDown = 720; // size of the picture whose pixels are counted
constexpr int kLeastPixels = 2, kLegs = 6; // a path's legs from the eye to the point
constexpr float kLeastShare = 0.01f; // share of its light: it is a hundred times as bright as a lit wall

// The picture as rays see it.
struct Sight {
    const Scene &scene;
    int point; // index of its ball

    // Returns whether a ray ends at the point, with a visible share of its light.
    bool sees(Vec3 o, Vec3 d, float share, int legs) const {
        if (!legs || share < kLeastShare) return false;
        Ray8 ray = {broadcast(o), broadcast(d)};
        Hit8 hit = intersect(scene, ray, kLanes < 8);
        int s = hit.shape[0];
        return s == point || (s >= 0 && reflects(s) && sees(s, ray, hit.t, share, legs));
    }
    bool reflects(int s) const {
        const Material &m = scene.materials[scene.shapes[s].material];
        return m.reflect > 0 || m.ior > 0;
    }
    // Likewise, for a ray that hits shape s.
    bool sees(int s, const Ray8 &ray, Float8 t, float share, int legs) const {
        const Shape &shape = scene.shapes[s];
        const Material &m = scene.materials[shape.material];
        Surface8 at = surfaceAt(shape, ray, t);
        Vec3 n = lane(at.n), d = lane(ray.d);
        float cosine = -dot(n, d), side = cosine < 0 ? -1.f : 1.f;
        Vec3 facing = n * side, mirrored = d + facing * (2 * std::fabs(cosine));
        cosine = std::fabs(cosine);
        float grazing = std::pow(1 - cosine, 5.f), reflected = m.reflect;
        if (m.fresnel || m.ior > 0) {
            float r0 = m.ior > 0 ? (m.ior - 1) * (m.ior - 1) / ((m.ior + 1) * (m.ior + 1)) : m.reflect;
            reflected = r0 + (1 - r0) * grazing;
        }
        if (m.ior > 0) {
            float eta = side > 0 ? 1 / m.ior : m.ior, inside = 1 - eta * eta * (1 - cosine * cosine);
            Vec3 bent = d * eta + facing * (eta * cosine - std::sqrt(std::fmax(inside, 0.f)));
            if (inside > 0 && sees(lane(offsetOrigin(shape, at, broadcast(-side))), normalize(bent),
                                   share * (1 - reflected), legs - 1))
                return true;
            if (inside <= 0) reflected = 1;
        }
        return sees(lane(offsetOrigin(shape, at, broadcast(side))), mirrored, share * reflected, legs - 1);
    }
    static Vec3 lane(const Vec3x8 &v) { return {v.x[0], v.y[0], v.z[0]}; }

    // Returns the number of pixels in a part of the picture that show the point, `most` at most.
    int pixels(const View &view, int x0, int y0, int x1, int y1, bool mirrors, int most) const {
        int count = 0;
        for (int y = std::max(y0, 0); y < std::min(y1, kDown); ++y)
            for (int x = std::max(x0, 0); x < std::min(x1, kAcross) && count < most; x += 8) {
                Vec3x8 d = view.direction(__builtin_convertvector(kLanes, Float8) + ((float)x + 0.5f),
                                          broadcast((float)y + 0.5f));
                d = normalize(d);
                Ray8 ray = {broadcast(view.eye), d};
                Hit8 hit = intersect(scene, ray, kLanes < 8);
                for (int i = 0; i < 8 && x + i < x1; ++i) {
                    int s = hit.shape[i];
                    if (s == point && maxComponent(scene.materials[scene.shapes[s].material].tint) > 0) {
                        ++count;
                    } else if (mirrors && s >= 0 && reflects(s)) {
                        Ray8 one = {broadcast(view.eye), broadcast(Vec3{d.x[i], d.y[i], d.z[i]})};
                        count += sees(s, one, broadcast(hit.t[i]), 1, kLegs - 1);
                    }
                }
            }
        return count;
    }
};

// Returns the index of the ball of the point of light, which is known by its colour (while a pen writes, it
// is the pen's tip); -1 if it is out.
int ballOf(const Scene &scene) {
    for (int i = scene.shapeCount - 1; i >= 0; --i) {
        const Shape &s = scene.shapes[i];
        const Rgb &emit = scene.materials[s.material].emit;
        if (s.isBall() && emit.x > 1 && length(emit * (kPointLight.x / emit.x) - kPointLight) < 1e-3f)
            return i;
    }
    return -1;
}

// Returns how many pixels of the picture at a time show the point of light.
int pixelsAt(double seconds) {
    const Scene &scene = *smallFilm().film.scene;
    Posed now = poseAt(smallFilm().film, seconds);
    Sight sight = {scene, ballOf(scene)};
    if (sight.point < 0) return 0;
    Vec3 at = scene.shapes[sight.point].centre;
    View view = now.view(kAcross, kDown);
    // Look at its own place first
    if (view.ahead(at) > 0) {
        float x, y, size = scene.shapes[sight.point].half.x / view.ahead(at) / view.spread + 2;
        view.project(at, x, y);
        if (std::fabs(x) < 1e5f && std::fabs(y) < 1e5f) {
            int seen = sight.pixels(view, (int)(x - size), (int)(y - size), (int)(x + size), (int)(y + size),
                                    false, kLeastPixels);
            if (seen >= kLeastPixels) return seen;
        }
    }
    return sight.pixels(view, 0, 0, kAcross, kDown, true, kLeastPixels);
}

} // namespace

TEST(PointOfLight, IsSeenInEveryShot) {
    if (kSanitized) GTEST_SKIP() << kFiguresAlone;
    for (int i = 0; i < kFilm.count; ++i) {
        const Shot &s = kFilm.shots[i];
        for (int k = 0; k < kMoments; ++k) {
            double row = s.row + (endOf(i) - s.row) * (k + 0.5) / kMoments;
            EXPECT_GE(pixelsAt(row / kRowsPerSecond), kLeastPixels)
                << "shot " << i << " on row " << s.row << ", " << kScenes[s.scene].name << ", at "
                << row / kRowsPerSecond << " s";
        }
    }
}

// Within a shot it never jumps.
TEST(PointOfLight, MovesWithoutJumps) {
    constexpr double kStep = 1 / 60.;
    for (double t = kStep; t < duration(); t += kStep) {
        const Shot *before = momentAt(kFilm, (t - kStep) * kRowsPerSecond).shot,
                   *now = momentAt(kFilm, t * kRowsPerSecond).shot;
        if (before != now) continue;
        EXPECT_LT(length(pointAt(t).at - pointAt(t - kStep).at), 0.5f) << t << " s"; // 30 m/s
    }
}
