#include "tools/radiosity/solve/solve_options.h"

#include "radiosity/light_bases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace odraz::radiosity {

namespace {

// Reads N numbers separated by commas.
template <size_t N> std::array<double, N> readNumbers(const std::string &option, const std::string &text) {
    std::array<double, N> n;
    const char *p = text.c_str();
    for (size_t i = 0; i < N; ++i) {
        char *end;
        n[i] = std::strtod(p, &end);
        if (end == p || !std::isfinite(n[i]) || *end != (i + 1 < N ? ',' : 0))
            throw common::Refused(option + " takes " + std::to_string(N) +
                                  " numbers with commas between, not '" + text + "'");
        p = end + 1;
    }
    return n;
}

Rgb readLight(const std::string &option, const double *n) {
    for (int k = 0; k < 3; ++k)
        if (!(n[k] >= 0 && n[k] < 1e12)) throw common::Refused(option + ": light must be from 0 to 1e12");
    return {(float)n[0], (float)n[1], (float)n[2]};
}

} // namespace

bool SolveOptions::take(const std::string &w, common::Arguments &words) {
    SolveSettings &s = settings;
    if (w == "--rays")
        s.rays = words.whole(w, 8, 32768), byRays = w;
    else if (w == "--final")
        s.finalRays = words.whole(w, 8, 32768), byRays = w;
    else if (w == "--hemicube") {
        byPatches = w;
        s.hemicube = words.whole(w, 4, kMaxHemicube);
    } else if (w == "--shots")
        s.shots = words.whole(w, 1, 100000000), byPatches = w;
    else if (w == "--patch")
        s.patch = words.number(w, 1e-18, 1e30), byPatches = w;
    else if (w == "--element")
        s.element = words.number(w, 1e-18, 1e30);
    else if (w == "--bounces")
        s.bounces = words.whole(w, 0, 10000);
    else if (w == "--residual")
        s.residual = (float)words.number(w, 1e-7, 1);
    else if (w == "--lamp-samples")
        s.lampSamples = words.whole(w, 1, kMaxLampCells);
    else if (w == "--memory")
        s.memory = (size_t)(words.number(w, 1, 1e6) * 1048576);
    else if (w == "--sky")
        sky = words.value(w);
    else if (w == "--sun")
        suns.push_back(words.value(w));
    else if (w == "--lamp")
        lamps.push_back(words.value(w));
    else if (w == "--up")
        upIsZ = words.choice(w, "z", "y");
    else if (w == "--scale")
        read.scale = words.number(w, 1e-9, 1e9);
    else if (w == "--two-sided")
        read.twoSided = true;
    else if (w == "--reflectance" || w == "--power") {
        read.changes.push_back(readMaterialChange(w, words.value(w)));
        if (w == "--power") s.evenSky = false; // who puts the lamps out wants it dark
    } else if (w == "--adaptive")
        s.adaptive = true, byPatches = w;
    else if (w == "--direct")
        s.analytic = words.choice(w, "analytic", "hemicube"), byPatches = w;
    else
        return false;
    given.push_back(w);
    return true;
}

bool SolveOptions::has(const std::string &option) const {
    return std::find(given.begin(), given.end(), option) != given.end();
}

std::string SolveOptions::tell(const std::string &w) const {
    const SolveSettings &s = settings;
    auto number = [&](double x) {
        char text[40];
        std::snprintf(text, sizeof text, "%.9g", x);
        return x > 0 ? w + " " + text : "no " + w;
    };
    auto words = [&](const std::vector<std::string> &all) {
        std::string text;
        for (const std::string &word : all) text += (text.empty() ? "" : " ") + w + " " + word;
        return text.empty() ? "no " + w : text;
    };
    auto flag = [&](bool on) { return on ? w : "no " + w; };
    return w == "--rays"           ? number(s.rays)
           : w == "--final"        ? number(s.finalRays)
           : w == "--hemicube"     ? number(s.hemicube)
           : w == "--patch"        ? number(s.patch)
           : w == "--element"      ? number(s.element)
           : w == "--lamp-samples" ? number(s.lampSamples)
           : w == "--scale"        ? number(read.scale)
           : w == "--sky"  ? words(sky.empty() ? std::vector<std::string>{} : std::vector<std::string>{sky})
           : w == "--sun"  ? words(suns)
           : w == "--lamp" ? words(lamps)
           : w == "--up"   ? w + (upIsZ ? " z" : " y")
           : w == "--two-sided" ? flag(read.twoSided)
           : w == "--adaptive"  ? flag(s.adaptive)
                                : w + (s.analytic ? " analytic" : " hemicube");
}

void SolveOptions::follow(const SolveOptions &kept, const std::string &file) {
    auto refuse = [&](const std::string &had, const std::string &asked) {
        throw common::Refused(file + ": its rows are of " + had + ", not of " + asked +
                              ": solve the model again");
    };
    if (!byPatches.empty() && kept.settings.way == Way::kRays) refuse("rays", "hemicubes");
    if (!byRays.empty() && kept.settings.way == Way::kPatches) refuse("hemicubes", "rays");
    for (const std::string &w : given) {
        bool free = w == "--reflectance" || w == "--power" || w == "--bounces" || w == "--residual" ||
                    w == "--memory";
        if (!free && tell(w) != kept.tell(w)) refuse(kept.tell(w), tell(w));
    }
    SolveOptions own = *this;
    *this = kept;
    read.changes = own.read.changes;
    settings.evenSky = own.settings.evenSky;
    if (own.has("--bounces")) settings.bounces = own.settings.bounces;
    if (own.has("--residual")) settings.residual = own.settings.residual;
    stopsAlike = settings.bounces == kept.settings.bounces && settings.residual == kept.settings.residual;
    if (own.has("--memory")) settings.memory = own.settings.memory;
}

void SolveOptions::finish() {
    if (!byRays.empty() && !byPatches.empty())
        throw common::Refused(byRays + " and " + byPatches +
                              " do not go together: one solves by rays, the other between patches");
    if (!byPatches.empty()) settings.way = Way::kPatches;
    if (settings.shots > 0 && settings.bounces >= 0)
        throw common::Refused(
            "--shots and --bounces do not go together: a shot is sent out whenever much light waits");
    Surroundings &to = settings.surroundings;
    double n[3];
    char rest;
    if (std::sscanf(sky.c_str(), "%lf,%lf,%lf%c", n, n + 1, n + 2, &rest) == 3)
        to.sky = evenSky(readLight("--sky", n));
    else if (!sky.empty() && sky.find_first_not_of("0123456789.,+-eE") == std::string::npos)
        throw common::Refused("--sky takes R,G,B or a picture, not '" + sky + "'");
    else if (!sky.empty())
        to.sky = readSky(sky, upIsZ, to.suns);
    for (const std::string &text : suns) {
        auto s = readNumbers<5>("--sun", text);
        to.suns.push_back({sunTowards(s[0], s[1], upIsZ), readLight("--sun", &s[2])});
    }
    for (const std::string &text : lamps) {
        auto l = readNumbers<7>("--lamp", text);
        if (!(l[3] > 0)) throw common::Refused("--lamp: its size must be above 0");
        to.lamps.push_back(
            {{(float)l[0], (float)l[1], (float)l[2]}, (float)l[3] / 2, readLight("--lamp", &l[4])});
    }
    if (to.suns.size() > kMaxSuns || to.lamps.size() > kMaxLamps)
        throw common::Refused("at most " + std::to_string(kMaxSuns) +
                              " suns, those of a sky's picture too, and " + std::to_string(kMaxLamps) +
                              " lamps");
}

} // namespace odraz::radiosity
