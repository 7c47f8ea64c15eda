#include "tools/measure/reference_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace odraz {

namespace {

constexpr double kPiD = std::numbers::pi, kNever = 1e30, kOff = 1e-7;
constexpr int kMostTurns = 24; // of a path

Vec3d wide(const Vec3 &v) { return {(double)v.x, (double)v.y, (double)v.z}; }
Vec3d times(Vec3d a, Vec3d b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
double largest(Vec3d a) { return std::max({a.x, a.y, a.z}); }

// --- Numbers that are spread evenly ---

uint64_t mixed(uint64_t x) { // splitmix64
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

// A path's numbers: the first ones of all paths of a pixel fill a cube evenly (Roberts' additive recurrence,
// shifted at random), the others are random.
struct Numbers {
    static constexpr size_t kEven = 8;
    uint64_t state, index;
    uint64_t shift;

    Numbers(uint64_t stream, uint64_t index)
        : state(mixed(mixed(stream) ^ index)), index(index), shift(mixed(stream)) {}
    double random() {
        state = mixed(state);
        return (double)(state >> 11) * 0x1p-53;
    }
    double even(size_t k) const {
        static const std::vector<double> steps = [] {
            double root = 2;
            for (int i = 0; i < 60; ++i) root = std::pow(1 + root, 1. / (kEven + 1));
            std::vector<double> all;
            for (size_t i = 0; i < kEven; ++i) all.push_back(std::pow(1 / root, (double)i + 1));
            return all;
        }();
        double v = (double)(mixed(shift + k) >> 11) * 0x1p-53 + (double)(index + 1) * steps[k];
        return v - std::floor(v);
    }
};

// Two unit vectors across a third
struct Across {
    Vec3d u, v;
    explicit Across(Vec3d n)
        : u(normalize(cross(n, std::fabs(n.x) > 0.5 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0}))), v(cross(n, u)) {}
    Vec3d at(double angle) const { return u * std::cos(angle) + v * std::sin(angle); }
};

// Evenly in the cone about an axis whose half angle has that cosine
Vec3d inCone(Vec3d axis, double least, double a, double b) {
    double c = 1 - a * (1 - least), s = std::sqrt(std::max(1 - c * c, 0.));
    return axis * c + Across(axis).at(2 * kPiD * b) * s;
}
// By cosine about a normal
Vec3d byCosine(Vec3d n, double a, double b) {
    return n * std::sqrt(1 - a) + Across(n).at(2 * kPiD * b) * std::sqrt(a);
}
// How wide a ball is seen: the cosine of the half angle
double coneOf(double distance, double radius) {
    double sine = std::min(radius / distance, 1.);
    return std::sqrt(1 - sine * sine);
}

// --- The scene ---

struct Look {
    Vec3d albedo, absorb, tint, emit;
    double specular, exponent, reflect, ior;
    bool fresnel;

    explicit Look(const Material &m)
        : albedo(wide(m.texture.palette[0]) * (double)m.diffuse), absorb(wide(m.absorb)), tint(wide(m.tint)),
          emit(wide(m.emit)), specular((double)m.specular), exponent((double)m.exponent),
          reflect((double)m.reflect), ior((double)m.ior), fresnel(m.fresnel) {
        if (!m.plain() || m.transmit > 0)
            throw std::logic_error("paths know plain colours and whole glass only");
    }
    double mirrors(double cosine) const {
        return reflect + (fresnel ? (1 - reflect) * std::pow(1 - cosine, 5) : 0);
    }
};
struct Ball {
    Vec3d centre;
    double radius;
    Look look;
    bool lamp;
};
struct Shining {
    Vec3d at, intensity;
    double radius;
};

struct Hit {
    double t = kNever;
    const Ball *ball = nullptr; // null: the floor
};

struct World {
    std::vector<Ball> balls;
    std::vector<Shining> lights;
    std::vector<Look> floor; // of one, or none
    double floorAt = 0;
    Vec3d sky;

    explicit World(const Scene &scene) : sky(wide(scene.ambientHigh)) {
        for (int i = 0; i < scene.shapeCount; ++i) {
            const Shape &s = scene.shapes[i];
            const Material &m = scene.materials[s.material];
            if (s.kind == ShapeKind::Sphere)
                balls.push_back({wide(s.centre), (double)s.half.x, Look(m), m.lamp()});
            else if (s.kind == ShapeKind::Plane && s.aligned && floor.empty() && m.ior == 0) {
                floor.push_back(Look(m));
                floorAt = (double)s.centre.y;
            } else
                throw std::logic_error("paths know balls and a floor only");
        }
        for (int i = 0; i < scene.lightCount; ++i) {
            const Light &l = scene.lights[i];
            if (l.radius <= 0) throw std::logic_error("paths know lights with a radius only");
            lights.push_back({wide(l.position), wide(l.intensity), (double)l.radius});
        }
    }

    Hit nearest(Vec3d o, Vec3d d, bool lamps) const {
        Hit hit;
        if (!floor.empty() && d.y != 0) {
            double t = (floorAt - o.y) / d.y;
            if (t > kOff) hit.t = t;
        }
        for (const Ball &b : balls) {
            if (b.lamp && !lamps) continue;
            Vec3d to = b.centre - o;
            double along = dot(to, d);
            Vec3d aside = to - d * along;
            double square = b.radius * b.radius - dot(aside, aside);
            if (square < 0) continue;
            double root = std::sqrt(square), t = along - root > kOff ? along - root : along + root;
            if (t > kOff && t < hit.t) hit = {t, &b};
        }
        return hit;
    }
};

// --- What glass and mirrors gather: photons in cells of the floor ---

struct Cells {
    static constexpr int kSide = 640;
    static constexpr double kReach = 3.2; // the floor's part: |x|, |z| below that
    std::vector<Vec3d> light;             // as Light has it: what a white place would show

    Cells() : light((size_t)kSide * kSide) {}
    Vec3d *at(Vec3d p) {
        int x = (int)std::floor((p.x + kReach) * (kSide / (2 * kReach))),
            z = (int)std::floor((p.z + kReach) * (kSide / (2 * kReach)));
        if (x < 0 || z < 0 || x >= kSide || z >= kSide) return nullptr;
        return &light[(size_t)z * kSide + (size_t)x];
    }
};

// Where a ray goes on from glass or a mirror, one of its ways taken at random by `u`. False where it ends.
bool turn(const Look &look, Vec3d &d, Vec3d n, double u, Vec3d &weight) {
    double cosine = -dot(d, n);
    bool inside = cosine < 0;
    if (inside) n = n * -1, cosine = -cosine;
    Vec3d mirrored = normalize(d + n * (2 * cosine));
    if (look.ior == 0) {
        double share = look.mirrors(cosine);
        weight = times(weight, look.tint) * share;
        d = mirrored;
        return share > 0;
    }
    double eta = inside ? look.ior : 1 / look.ior, sine2 = eta * eta * (1 - cosine * cosine);
    double reflected = 1, through = std::sqrt(std::max(1 - sine2, 0.));
    if (sine2 < 1) {
        double across = (eta * cosine - through) / (eta * cosine + through),
               along = (cosine - eta * through) / (cosine + eta * through);
        reflected = (across * across + along * along) / 2;
    }
    d = u < reflected ? mirrored : normalize(d * eta + n * (eta * cosine - through));
    return true;
}

// What is left of it behind a way through glass
void absorb(const Look &look, double t, Vec3d &weight) {
    weight = times(weight, {std::exp2(-look.absorb.x * t), std::exp2(-look.absorb.y * t),
                            std::exp2(-look.absorb.z * t)});
}

void shoot(const World &world, const Shining &light, const Ball &at, uint64_t stream, int first, int end,
           double count, Cells &cells) {
    double area = 4 * kPiD * light.radius * light.radius,
           cell = std::pow(2 * Cells::kReach / Cells::kSide, 2);
    for (int i = first; i < end; ++i) {
        Numbers numbers(stream, (uint64_t)i);
        double height = 2 * numbers.even(0) - 1;
        Vec3d n = Vec3d{0, height, 0} +
                  Vec3d{std::cos(2 * kPiD * numbers.even(1)), 0, std::sin(2 * kPiD * numbers.even(1))} *
                      std::sqrt(1 - height * height);
        Vec3d o = light.at + n * light.radius, to = at.centre - o;
        double cone = coneOf(length(to), at.radius);
        Vec3d d = inCone(normalize(to), cone, numbers.even(2), numbers.even(3));
        double cosine = dot(n, d);
        if (cosine <= 0) continue;
        // Its power, spread over a cell, in units of which a radiance of 1 from all above makes 1
        Vec3d weight = light.intensity * (cosine * area * 2 * kPiD * (1 - cone) /
                                          (light.radius * light.radius * count * cell * kPiD));
        for (int k = 0; k < kMostTurns; ++k) {
            Hit hit = world.nearest(o, d, false);
            if (hit.t == kNever || (k == 0 && hit.ball != &at)) break;
            o = o + d * hit.t;
            if (!hit.ball) {
                if (Vec3d *to = cells.at(o)) *to = *to + weight;
                break;
            }
            Vec3d out = (o - hit.ball->centre) / hit.ball->radius;
            if (dot(out, d) > 0) absorb(hit.ball->look, hit.t, weight);
            if (!turn(hit.ball->look, d, out, numbers.random(), weight)) break;
        }
    }
}

void gather(const World &world, const PathSettings &settings, Workers &workers, Cells &all) {
    constexpr int kParts = 8; // whose sums are added in order, whatever thread made them
    int each = settings.photons * (1000 / kParts);
    for (const Shining &light : world.lights)
        for (const Ball &ball : world.balls) {
            if (ball.lamp || !(ball.look.ior > 0 || (settings.bounces && ball.look.reflect > 0))) continue;
            std::vector<Cells> part(kParts);
            parallelFor(workers, kParts, [&](int k, int) {
                shoot(world, light, ball, mixed(settings.seed) + 1, k * each, (k + 1) * each, each * kParts,
                      part[(size_t)k]);
            });
            for (const Cells &p : part)
                for (size_t i = 0; i < p.light.size(); ++i) all.light[i] = all.light[i] + p.light[i];
        }
}

// --- From the eye ---

// What of a light arrives at a place and shows: on what is matte, and in Phong's highlight.
Vec3d lit(const World &world, const Look &look, Vec3d p, Vec3d n, Vec3d d, bool highlight, double a, double b,
          const Shining &light) {
    Vec3d to = light.at - p;
    double far = length(to), cone = coneOf(far, light.radius);
    Vec3d l = inCone(to / far, cone, a, b);
    double cosine = dot(n, l);
    if (cosine <= 0) return {};
    Hit before = world.nearest(p, l, false);
    if (before.t < far) return {};
    Vec3d arrives = light.intensity * (2 * (1 - cone) / (light.radius * light.radius));
    double lobe = 0;
    if (highlight && look.specular > 0)
        lobe = look.specular * std::pow(std::max(dot(d - n * (2 * dot(n, d)), l), 0.), look.exponent);
    return times(arrives, look.albedo * cosine + Vec3d{lobe, lobe, lobe});
}

Vec3d radianceOf(const World &world, const PathSettings &settings, Cells &cells, Vec3d o, Vec3d d,
                 Numbers &numbers) {
    Vec3d sum = {}, weight = {1, 1, 1};
    int matte = 0; // places met so far
    for (int k = 0; k < kMostTurns; ++k) {
        Hit hit = world.nearest(o, d, matte == 0);
        if (hit.t == kNever) return sum + times(weight, world.sky);
        const Look &look = hit.ball ? hit.ball->look : world.floor[0];
        if (hit.ball && hit.ball->lamp) return sum + times(weight, look.emit);
        o = o + d * hit.t;
        Vec3d n = hit.ball ? (o - hit.ball->centre) / hit.ball->radius : Vec3d{0, 1, 0};
        bool inside = hit.ball && dot(n, d) > 0;
        if (inside) absorb(look, hit.t, weight);
        auto number = [&](size_t which) { return matte == 0 ? numbers.even(which) : numbers.random(); };

        // What falls straight on it
        double diffuse = largest(look.albedo), reflect = look.mirrors(std::fabs(dot(n, d)));
        if (!inside && (matte == 0 || settings.bounces)) {
            if (diffuse > 0 || look.specular > 0)
                for (const Shining &light : world.lights)
                    sum = sum +
                          times(weight, lit(world, look, o, n, d, matte == 0, number(2), number(3), light));
            if (!hit.ball)
                if (Vec3d *more = cells.at(o)) sum = sum + times(weight, times(look.albedo, *more));
        }
        // One of the ways on
        if (look.ior > 0) {
            if (!turn(look, d, n, k == 0 ? numbers.even(6) : numbers.random(), weight)) return sum;
            continue;
        }
        bool goesOn = diffuse > 0 && (matte == 0 || settings.bounces);
        double mirror = reflect > 0 ? goesOn ? 0.5 : 1 : 0;
        if (!goesOn && mirror == 0) return sum;
        if ((k == 0 ? numbers.even(7) : numbers.random()) < mirror) {
            weight = weight / mirror;
            if (!turn(look, d, n, 0, weight)) return sum;
        } else {
            weight = times(weight, look.albedo) / (1 - mirror);
            d = byCosine(n, number(4), number(5));
            ++matte;
        }
    }
    return sum;
}

} // namespace

std::vector<Vec3d> tracePaths(const Scene &scene, const View &view, const PathSettings &settings,
                              Workers &workers) {
    World world(scene);
    Cells cells;
    gather(world, settings, workers, cells);
    int width = (int)view.width, height = (int)view.height;
    std::vector<Vec3d> picture((size_t)width * (size_t)height);
    Vec3d eye = wide(view.eye), forward = wide(view.forward), right = wide(view.right),
          down = wide(view.down);
    parallelFor(workers, height, [&](int y, int) {
        for (int x = 0; x < width; ++x) {
            size_t at = (size_t)y * (size_t)width + (size_t)x;
            Vec3d sum = {};
            for (int i = 0; i < settings.samples; ++i) {
                Numbers numbers(mixed(settings.seed) + at + 2, (uint64_t)i);
                Vec3d d = forward + right * ((x + numbers.even(0)) / width - 0.5) +
                          down * ((y + numbers.even(1)) / height - 0.5);
                sum = sum + radianceOf(world, settings, cells, eye, normalize(d), numbers);
            }
            picture[at] = sum / settings.samples;
        }
    });
    return picture;
}

} // namespace odraz
