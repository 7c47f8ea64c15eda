#include "tools/measure/oracle/reference_picture.h"

#include "tools/radiosity/reference/obstacles.h"
#include "tools/radiosity/reference/sampler.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace odraz::measure {

using namespace radiosity;

namespace {

constexpr double kPiD = std::numbers::pi, kOff = 1e-7;
constexpr int kLongest = 24; // rays of the longest path

double largest(Vec3d a) { return std::max({a.x, a.y, a.z}); }

// --- The scene ---

struct Surface {
    Vec3d albedo, absorb, tint, emit;
    double specular, exponent, reflect, ior;
    bool fresnel;

    explicit Surface(const Material &m)
        : albedo(toDouble(m.texture.palette[0]) * (double)m.diffuse), absorb(toDouble(m.absorb)),
          tint(toDouble(m.tint)), emit(toDouble(m.emit)), specular((double)m.specular),
          exponent((double)m.exponent), reflect((double)m.reflect), ior((double)m.ior), fresnel(m.fresnel) {
        if (!m.plain() || m.transmit > 0)
            throw std::logic_error("paths handle plain colours and whole glass only");
    }
    double mirrors(double cosine) const {
        return reflect + (fresnel ? (1 - reflect) * std::pow(1 - cosine, 5) : 0);
    }
};
struct Ball : Obstacles::Ball {
    Surface surface;
    bool lamp; // a lamp's body: seen, but casts no shadow
};
struct BallLight : Obstacles::Ball {
    Vec3d radiance;
};

struct Hit {
    double t;
    const Ball *ball; // null: the floor
    bool met() const { return t < INFINITY; }
};

struct World {
    std::vector<Ball> balls; // lamps last
    std::vector<BallLight> lights;
    std::vector<Surface> floor; // one or none
    double floorAt = 0;
    Vec3d sky;
    Obstacles solid, all; // without lamps, and with them

    explicit World(const Scene &scene) : sky(toDouble(scene.ambientHigh)) {
        for (int i = 0; i < scene.shapeCount; ++i) {
            const Shape &s = scene.shapes[i];
            const Material &m = scene.materials[s.material];
            if (s.isBall())
                balls.push_back({{toDouble(s.centre), (double)s.half.x}, Surface(m), m.onlyGlows()});
            else if (s.isFloor() && floor.empty() && m.ior == 0) {
                floor.push_back(Surface(m));
                floorAt = (double)s.centre.y;
            } else
                throw std::logic_error("paths handle balls and a floor only");
        }
        for (int i = 0; i < scene.lightCount; ++i) {
            const Light &l = scene.lights[i];
            if (l.radius <= 0) throw std::logic_error("paths handle lights with a radius only");
            double radius = (double)l.radius;
            lights.push_back({{toDouble(l.position), radius}, toDouble(l.intensity) / (radius * radius)});
        }
        auto lamps = std::stable_partition(balls.begin(), balls.end(), [](const Ball &b) { return !b.lamp; });
        solid = Obstacles({}, {balls.begin(), lamps});
        all = Obstacles({}, {balls.begin(), balls.end()});
    }
    Hit nearest(Vec3d o, Vec3d d, bool lamps) const {
        Obstacles::Hit ball = (lamps ? all : solid).nearest(o, d, kOff);
        double t = floor.empty() ? 0 : (floorAt - o.y) / d.y;
        if (t > kOff && t <= ball.t) return {t, nullptr};
        return {ball.t, ball.met() ? &balls[(size_t)ball.number] : nullptr};
    }
};

// --- Light that glass and mirrors throw on the floor: photons, counted in cells of it ---

struct PhotonMap {
    static constexpr int kSide = 640;
    static constexpr double kReach = 3.2; // the part of the floor that counts: |x|, |z| below this
    std::vector<Vec3d> light{(size_t)kSide * kSide, Vec3d{}}; // what a white floor would show

    Vec3d *at(Vec3d p) {
        double x = (p.x / kReach + 1) * kSide / 2, z = (p.z / kReach + 1) * kSide / 2;
        if (!(x >= 0 && z >= 0 && x < kSide && z < kSide)) return nullptr;
        return &light[(size_t)z * kSide + (size_t)x];
    }
};

// Reflects or refracts a ray at glass or a mirror; `u`, 0 .. 1, chooses between both. False if the path ends.
bool scatter(const Surface &surface, Vec3d &d, Vec3d n, double u, Vec3d &weight) {
    double cosine = -dot(d, n);
    bool inside = cosine < 0;
    if (inside) n = n * -1, cosine = -cosine;
    Vec3d mirrored = normalize(d + n * (2 * cosine));
    if (surface.ior == 0) {
        double share = surface.mirrors(cosine);
        weight = weight * surface.tint * share;
        d = mirrored;
        return share > 0;
    }
    double eta = inside ? surface.ior : 1 / surface.ior, sine2 = eta * eta * (1 - cosine * cosine);
    double reflected = 1, through = std::sqrt(std::max(1 - sine2, 0.));
    if (sine2 < 1) {
        double across = (eta * cosine - through) / (eta * cosine + through),
               along = (cosine - eta * through) / (cosine + eta * through);
        reflected = (across * across + along * along) / 2;
    }
    d = u < reflected ? mirrored : normalize(d * eta + n * (eta * cosine - through));
    return true;
}

// What glass absorbs along a path of length t
void absorb(const Surface &surface, double t, Vec3d &weight) {
    weight = weight * Vec3d{std::exp2(-surface.absorb.x * t), std::exp2(-surface.absorb.y * t),
                            std::exp2(-surface.absorb.z * t)};
}

// Follows photons from a light to a ball and on to the floor: numbers `first` to `end` of `count`.
void shootPhotons(const World &world, const BallLight &light, const Ball &target, uint64_t stream, int first,
                  int end, double count, PhotonMap &photons) {
    double area = 4 * kPiD * light.radius * light.radius,
           cell = std::pow(2 * PhotonMap::kReach / PhotonMap::kSide, 2);
    for (int i = first; i < end; ++i) {
        Sampler sampler(stream, (uint64_t)i);
        Vec3d n = inCone({0, 1, 0}, -1, {sampler.even(0), sampler.even(1)}),
              o = light.centre + n * light.radius, to = target.centre - o;
        double cone = coneOfBall(length(to), target.radius);
        Vec3d d = inCone(normalize(to), cone, {sampler.even(2), sampler.even(3)});
        double cosine = dot(n, d);
        if (cosine <= 0) continue;
        // The photon's power, spread over a cell; scaled so that a radiance of 1 from the whole sky makes 1
        Vec3d weight = light.radiance * (cosine * area * 2 * (1 - cone) / (count * cell));
        for (int k = 0; k < kLongest; ++k) {
            Hit hit = world.nearest(o, d, false);
            if (!hit.met() || (k == 0 && hit.ball != &target)) break;
            o = o + d * hit.t;
            if (!hit.ball) {
                if (Vec3d *there = photons.at(o)) *there = *there + weight;
                break;
            }
            Vec3d out = (o - hit.ball->centre) / hit.ball->radius;
            if (dot(out, d) > 0) absorb(hit.ball->surface, hit.t, weight);
            if (!scatter(hit.ball->surface, d, out, sampler.random(), weight)) break;
        }
    }
}

PhotonMap photonsOf(const World &world, const PathSettings &settings, Workers &workers) {
    constexpr int kParts = 8; // their sums are added in order, so the result does not depend on threads
    int each = settings.photons * (1000 / kParts);
    PhotonMap all;
    for (const BallLight &light : world.lights)
        for (const Ball &ball : world.balls) {
            const Surface &s = ball.surface;
            if (ball.lamp || !(s.ior > 0 || (settings.bounces && s.reflect > 0))) continue;
            std::vector<PhotonMap> parts(kParts);
            parallelFor(workers, kParts, [&](int k, int) {
                shootPhotons(world, light, ball, mixed(settings.seed) + 1, k * each, (k + 1) * each,
                             each * kParts, parts[(size_t)k]);
            });
            for (const PhotonMap &part : parts)
                for (size_t i = 0; i < all.light.size(); ++i) all.light[i] = all.light[i] + part.light[i];
        }
    return all;
}

// --- From the eye ---

// The direct light of a lamp at a place: on the matte surface, and in Phong's highlight.
Vec3d directLight(const World &world, const Surface &surface, Vec3d p, Vec3d n, Vec3d d, bool highlight,
                  SquarePoint at, const BallLight &light) {
    Vec3d to = light.centre - p;
    double far = length(to), cone = coneOfBall(far, light.radius);
    Vec3d l = inCone(to / far, cone, at);
    double cosine = dot(n, l);
    if (cosine <= 0) return {};
    if (world.nearest(p, l, false).t < far) return {};
    Vec3d arrives = light.radiance * (2 * (1 - cone));
    double lobe = 0;
    if (highlight && surface.specular > 0)
        lobe = surface.specular * std::pow(std::max(dot(d - n * (2 * dot(n, d)), l), 0.), surface.exponent);
    return arrives * (surface.albedo * cosine + Vec3d{lobe, lobe, lobe});
}

Vec3d radianceOf(const World &world, const PathSettings &settings, PhotonMap &photons, Vec3d o, Vec3d d,
                 Sampler &sampler) {
    Vec3d sum = {}, weight = {1, 1, 1};
    int matte = 0; // how many matte places the path may still visit
    for (int k = 0; k < kLongest; ++k) {
        Hit hit = world.nearest(o, d, matte == 0);
        if (!hit.met()) return sum + weight * world.sky;
        const Surface &surface = hit.ball ? hit.ball->surface : world.floor[0];
        if (hit.ball && hit.ball->lamp) return sum + weight * surface.emit;
        o = o + d * hit.t;
        Vec3d n = hit.ball ? (o - hit.ball->centre) / hit.ball->radius : Vec3d{0, 1, 0};
        bool inside = hit.ball && dot(n, d) > 0;
        if (inside) absorb(surface, hit.t, weight);
        auto number = [&](size_t which) { return matte == 0 ? sampler.even(which) : sampler.random(); };

        // Add the direct light
        double diffuse = largest(surface.albedo), reflect = surface.mirrors(std::fabs(dot(n, d)));
        if (!inside && (matte == 0 || settings.bounces)) {
            if (diffuse > 0 || surface.specular > 0)
                for (const BallLight &light : world.lights)
                    sum = sum + weight * directLight(world, surface, o, n, d, matte == 0,
                                                     {number(2), number(3)}, light);
            if (!hit.ball)
                if (Vec3d *more = photons.at(o)) sum = sum + weight * surface.albedo * *more;
        }
        // Choose one direction to go on
        if (surface.ior > 0) {
            if (!scatter(surface, d, n, k == 0 ? sampler.even(6) : sampler.random(), weight)) return sum;
            continue;
        }
        bool goesOn = diffuse > 0 && (matte == 0 || settings.bounces);
        double mirror = reflect > 0 ? goesOn ? 0.5 : 1 : 0;
        if (!goesOn && mirror == 0) return sum;
        if ((k == 0 ? sampler.even(7) : sampler.random()) < mirror) {
            weight = weight / mirror;
            if (!scatter(surface, d, n, 0, weight)) return sum;
        } else {
            weight = weight * surface.albedo / (1 - mirror);
            d = byCosine(n, {number(4), number(5)});
            ++matte;
        }
    }
    return sum;
}

} // namespace

std::vector<Vec3d> tracePaths(const Scene &scene, const View &view, const PathSettings &settings,
                              Workers &workers) {
    World world(scene);
    PhotonMap photons = photonsOf(world, settings, workers);
    int width = (int)view.width, height = (int)view.height;
    std::vector<Vec3d> picture((size_t)width * (size_t)height);
    Vec3d eye = toDouble(view.eye), forward = toDouble(view.forward), right = toDouble(view.right),
          down = toDouble(view.down);
    parallelFor(workers, height, [&](int y, int) {
        for (int x = 0; x < width; ++x) {
            size_t at = (size_t)y * (size_t)width + (size_t)x;
            Vec3d sum = {};
            for (int i = 0; i < settings.samples; ++i) {
                Sampler sampler(mixed(settings.seed) + at + 2, (uint64_t)i);
                Vec3d d = forward + right * ((x + sampler.even(0)) / width - 0.5) +
                          down * ((y + sampler.even(1)) / height - 0.5);
                sum = sum + radianceOf(world, settings, photons, eye, normalize(d), sampler);
            }
            picture[at] = sum / settings.samples;
        }
    });
    return picture;
}

} // namespace odraz::measure
