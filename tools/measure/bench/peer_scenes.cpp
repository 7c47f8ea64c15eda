#include "tools/measure/bench/peer_scenes.h"

#include "tools/common/text.h"
#include "tools/support/vec3d.h"

#include <cmath>
#include <memory>

namespace odraz::measure {

namespace {

constexpr float kAmbient = 0.1f;
constexpr Vec3 kMiddleA = {0, 0.7f, 0}, kMiddleB = {};

Material plain(Rgb colour, float diffuse, float reflect, float specular, float exponent) {
    Material m = {};
    m.texture = {Pattern::Plain, 1, {colour, colour, colour, colour}};
    m.diffuse = diffuse;
    m.specular = specular;
    m.exponent = exponent;
    m.reflect = reflect;
    m.tint = {1, 1, 1};
    return m;
}

Texture cloud(Rgb low, Rgb high, float scale) {
    return {Pattern::Plaster, 1 / scale, {low, lerp(low, high, 1 / 3.f), lerp(low, high, 2 / 3.f), high}};
}

// A light that fades with distance and has this colour in the middle of the scene.
Light light(Vec3 at, Rgb colour, Vec3 middle) { return Light{at, colour * dot(at - middle, at - middle)}; }

} // namespace

void posePeerA(Scene &scene) {
    struct Ball {
        Vec3 centre;
        float radius;
        Rgb colour;
        float diffuse, reflect, phong;
        int kind; // 0 plain, 1 glass, 2 noise
    } const balls[] = {
        {{0, 1, 0}, 1, {0.9f, 0.9f, 0.95f}, 0.15f, 0.75f, 0.6f, 0},
        {{-2.4f, 1, 0.6f}, 1, {1, 0.8f, 0.4f}, 0.25f, 0.65f, 0.6f, 0},
        {{2.4f, 1, 0.8f}, 1, {1, 1, 1}, 0, 0, 0.8f, 1},
        {{0.9f, 0.5f, -2.2f}, 0.5f, {0.9f, 0.4f, 0.2f}, 0.7f, 0, 0.5f, 2},
        {{-1.1f, 0.45f, -2}, 0.45f, {0.9f, 0.15f, 0.1f}, 0.7f, 0, 0.6f, 0},
        {{-3.6f, 0.6f, -1.2f}, 0.6f, {0.15f, 0.8f, 0.2f}, 0.7f, 0, 0.6f, 0},
        {{3.7f, 0.7f, -1}, 0.7f, {0.15f, 0.3f, 0.9f}, 0.7f, 0, 0.6f, 0},
        {{1.4f, 2.6f, 1.6f}, 0.8f, {0.8f, 0.8f, 0.9f}, 0.15f, 0.7f, 0.6f, 0},
        {{-1.6f, 2.7f, 2.2f}, 0.7f, {0.95f, 0.85f, 0.2f}, 0.7f, 0, 0.6f, 0},
        {{0.1f, 0.25f, -3.2f}, 0.25f, {0.95f, 0.95f, 0.9f}, 0.7f, 0, 0.6f, 2},
    };
    // POV-Ray does not scale ambient light by the diffuse weight; we do, so emission adds the rest
    float ambient = kAmbient / 0.7f;
    Material floor = plain({0.25f, 0.22f, 0.2f}, 0.7f, 0, 0, 1);
    floor.other = cloud({0.55f, 0.5f, 0.45f}, {1, 0.95f, 0.9f}, 0.35f);
    floor.cell = 1;
    scene.add(plane({0, 0, 0}, scene.add(floor)));
    for (const Ball &b : balls) {
        Material m = plain(b.colour, b.diffuse, b.reflect, b.phong, 64);
        m.emit = b.colour * max(kAmbient - b.diffuse * ambient, 0.f);
        if (b.kind == 1) {
            m.ior = 1.5f;
            m.emit = {};
        }
        if (b.kind == 2) m.texture = cloud(b.colour * 0.3f, b.colour, 0.15f);
        scene.add(sphere({b.centre.x, b.centre.y, -b.centre.z}, b.radius, scene.add(m)));
    }
    scene.add(light({-6, 8, 7}, {0.8f, 0.75f, 0.7f}, kMiddleA));
    scene.add(light({7, 6, 4}, {0.5f, 0.55f, 0.6f}, kMiddleA));
    scene.ambientLow = scene.ambientHigh = {ambient, ambient, ambient};
    scene.sky = plainSky({0.2f, 0.35f, 0.6f}, {0.2f, 0.35f, 0.6f});
}

namespace {

// Turns a point about a unit axis (Rodrigues).
Vec3d turned(Vec3d p, Vec3d axis, double angle) {
    double c = std::cos(angle);
    return p * c + cross(axis, p) * std::sin(angle) + axis * (dot(axis, p) * (1 - c));
}

struct Flake {
    Scene &scene;
    Vec3d children[9];
    int material;

    void grow(int level, Vec3d centre, Vec3d direction, double radius) {
        // In the database z is up
        scene.add(sphere({(float)centre.x, (float)centre.z, (float)-centre.y}, (float)radius, material));
        if (level == 0) return;
        auto [x, y, z] = direction;
        double across = std::hypot(x, y);
        Vec3d axis = across > 1e-6 ? Vec3d{-y / across, x / across, 0} : Vec3d{1, 0, 0};
        for (Vec3d child : children) {
            Vec3d to = turned(child, axis, std::atan2(across, z));
            grow(level - 1, centre + to * radius * 4 / 3, to, radius / 3);
        }
    }
};

} // namespace

void posePeerB(Scene &scene, int level) {
    Material ground = plain({1, 0.75f, 0.33f}, 0.8f, 0, 0, 1);
    scene.add(plane({0, -0.5f, 0}, scene.add(ground)));
    Flake flake = {scene, {}, scene.add(plain({1, 0.9f, 0.7f}, 0.5f, 0.5f, 0.3f, 16))};
    double d = std::sqrt(0.5), tilt = std::asin(2 / std::sqrt(6.));
    const Vec3d triad[3] = {{d, d, 0}, {d, 0, -d}, {0, d, -d}};
    for (int i = 0; i < 9; ++i)
        flake.children[i] = turned(turned(triad[i % 3], {d, -d, 0}, tilt), {0, 0, 1}, i / 3 * 2 * M_PI / 3);
    flake.grow(level, {}, {0, 0, 1}, 0.5);
    for (Vec3 at : {Vec3{4, 2, -3}, Vec3{1, 4, 4}, Vec3{-3, 5, -1}})
        scene.add(light(at, {0.57735f, 0.57735f, 0.57735f}, kMiddleB));
    scene.sky = plainSky({0.078f, 0.361f, 0.753f}, {0.078f, 0.361f, 0.753f});
}

namespace {

std::string povColour(const Rgb &c) {
    return common::format("rgb <%g,%g,%g>", (double)c.x, (double)c.y, (double)c.z);
}
// POV-Ray's axes are left-handed.
std::string povPoint(const Vec3 &p) {
    return common::format("<%.9g,%.9g,%.9g>", (double)p.x, (double)p.y, -(double)p.z);
}

std::string povPigment(const Texture &t) {
    if (t.pattern == Pattern::Plain) return "pigment{" + povColour(t.palette[0]) + "}";
    return common::format("pigment{bozo color_map{[0 %s][1 %s]} scale %g}", povColour(t.palette[0]).c_str(),
                          povColour(t.palette[3]).c_str(), 1 / (double)t.scale);
}

std::string povSurface(const Material &m, float ambient) {
    std::string pigment = povPigment(m.texture), reflection = common::format("%g", (double)m.reflect), more;
    if (m.cell > 0) pigment = "pigment{checker " + pigment + " " + povPigment(m.other) + " translate y*0.5}";
    if (m.ior > 0) {
        pigment = "pigment{rgbt 1}";
        reflection = "{0,1 fresnel} conserve_energy";
        more = common::format(" interior{ior %g} no_shadow", (double)m.ior);
    }
    float emission = m.emit.x > 0 ? m.emit.x / m.texture.palette[0].x : 0;
    return common::format("%s finish{ambient %g diffuse %g phong %g phong_size %g reflection %s}%s",
                          pigment.c_str(), (double)(m.ior > 0 ? 0 : m.diffuse * ambient + emission),
                          (double)m.diffuse, (double)m.specular, (double)m.exponent, reflection.c_str(),
                          more.c_str());
}

} // namespace

std::string povOf(bool b) {
    auto scene = std::make_unique<Scene>();
    scene->clear();
    b ? posePeerB(*scene) : posePeerA(*scene);
    CameraKey camera = b ? kPeerCameraB : kPeerCameraA;
    double across = 2 * std::atan(std::tan((double)camera.fov * M_PI / 360) * 16 / 9) * 180 / M_PI;
    std::string text =
        "#version 3.7; global_settings{assumed_gamma 1.0 max_trace_level 5 noise_generator 3}\n";
    common::append(text,
                   "camera{perspective location %s right x*16/9 up y angle %g look_at %s}\nbackground{%s}\n",
                   povPoint(camera.eye).c_str(), across, povPoint(camera.target).c_str(),
                   povColour(scene->sky.low).c_str());
    for (int i = 0; i < scene->lightCount; ++i) {
        const Light &l = scene->lights[i];
        Vec3 to = l.position - (b ? kMiddleB : kMiddleA); // equally bright there
        common::append(text, "light_source{%s %s}\n", povPoint(l.position).c_str(),
                       povColour(l.intensity * (1 / dot(to, to))).c_str());
    }
    for (int i = 0; i < scene->shapeCount; ++i) {
        const Shape &s = scene->shapes[i];
        std::string surface = povSurface(scene->materials[s.material], scene->ambientLow.x);
        if (s.isBall())
            common::append(text, "sphere{%s,%.9g %s}\n", povPoint(s.centre).c_str(), (double)s.half.x,
                           surface.c_str());
        else
            common::append(text, "plane{y,%g %s}\n", (double)s.centre.y, surface.c_str());
    }
    return text;
}

void poseField(Scene &scene) {
    Material m = plain({0.8f, 0.8f, 0.8f}, 0.7f, 0, 0.3f, 40);
    int matte = scene.add(m);
    m.reflect = 0.4f;
    int shiny = scene.add(m);
    float pixel = 20 * std::tan(20 * 3.14159265f / 180) / 720; // its width at the field's distance
    for (int i = 0; i < 800; ++i) {
        float x = (float)(i % 40) * 0.31f - 6.1f + 0.0031f * (float)(i % 17),
              y = (float)(i / 40) * 0.345f - 3.3f - 0.0043f * (float)(i % 29);
        scene.add(sphere({x, y, 0}, pixel * (1 + 3 * (float)(i % 37) / 36), i % 3 ? matte : shiny));
    }
    scene.add(light({-6, 8, 7}, {0.8f, 0.75f, 0.7f}, {}));
    scene.ambientLow = scene.ambientHigh = {0.1f, 0.1f, 0.1f};
    scene.sky = plainSky({0.02f, 0.03f, 0.05f}, {0.02f, 0.03f, 0.05f});
}

} // namespace odraz::measure
