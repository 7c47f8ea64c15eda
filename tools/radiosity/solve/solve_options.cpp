#include "tools/radiosity/solve/solve_options.h"

#include <cstdio>

namespace odraz::radiosity {

namespace {

constexpr char kByRays[] = "By rays from every element",
               kByPatches[] = "Between patches, by hemicubes that OpenGL draws, instead of by rays",
               kAccuracy[] = "Accuracy",
               kLight[] =
                   "Light from outside the model; if nothing emits light, an even sky of 1,1,1 is added",
               kReading[] = "How the model is read";

Rgb lightOf(const std::string &option, const double *n) {
    for (int k = 0; k < 3; ++k)
        common::need(n[k] >= 0 && n[k] <= kMostPower, option + ": light must be from 0 to 1e12");
    return {(float)n[0], (float)n[1], (float)n[2]};
}

} // namespace

std::optional<Rgb> evenRadiance(const std::string &sky) {
    double n[3];
    char rest;
    if (std::sscanf(sky.c_str(), "%lf,%lf,%lf%c", n, n + 1, n + 2, &rest) != 3) return {};
    return lightOf("--sky", n);
}

const std::vector<std::string> &SolveOptions::groups() {
    static const std::vector<std::string> all = {kByRays, kByPatches,     kAccuracy,
                                                 kLight,  kMaterialGroup, kReading};
    return all;
}

void SolveOptions::addTo(common::CommandLine &line, For command) {
    SolveSettings &s = settings;
    if (command != For::kView)
        line.flag("--progress", progress, "report progress in lines on stderr if it is not a terminal");
    const bool anyMethod = command == For::kSolve || command == For::kView;
    if (command != For::kStudy) {
        line.group(kByRays);
        line.option("--rays", "N", s.rays, {8, 32768},
                    "rays from an element; by default 32 to 512, depending on its light");
        if (anyMethod)
            line.option("--final", "N", s.finalRays, {8, 32768},
                        "end with a final gather: N more rays, for quality");
    }
    line.group(kAccuracy);
    if (command != For::kStudy)
        line.option("--element", "AREA", s.element, {1e-18, 1e30},
                    std::string("area of an element; by default a 30000th of the model's area") +
                        (anyMethod ? ", with --final a 120000th" : ""));
    if (anyMethod)
        line.option("--bounces", "N", s.bounces, {0, 10000},
                    "follow light over N bounces; 0 is direct light alone");
    line.option("--residual", "R", s.residual, {1e-7, 1},
                std::string(anyMethod ? "without --bounces: " : "") +
                    "stop when a sweep changes less than this share of the light");
    line.option("--lamp-samples", "N", s.lampSamples, {1, 256}, "shadow rays to the largest lamp");
    line.option("--memory", "MB", megabytes, {1, 1e6}, "refuse a solution that needs more memory");
    if (anyMethod) {
        line.group(kByPatches);
        line.option("--hemicube", "PX", s.hemicube, {4, kMaxHemicube}, "pixels along a hemicube's top face");
        line.option(
            "--patch", "AREA", s.patch, {1e-18, 1e30},
            "area of a patch, which has one hemicube; by default a 6000th of the model's, or larger if it "
            "has more than 2,000 polygons");
        line.option("--direct", {"hemicube", "analytic"}, s.analytic,
                    "find the light of lamps by hemicubes, or by shadow rays to the lamps");
        line.option(
            "--shots", "N", s.shots, {1, 100000000},
            "find no rows, but shoot light, from the brightest patches first, with at most N hemicubes; stop "
            "when the share of unshot light is below --residual");
    }
    line.group(kLight);
    if (command == For::kSolve || command == For::kStudy)
        line.option("--sky", "R,G,B|FILE", sky, "radiance from all directions: even, or a picture");
    line.option(
        "--sun", "ELEVATION,AZIMUTH,R,G,B", suns,
        "parallel light: degrees above the horizon, and from -z (+y if z is up) towards +x; R,G,B is the "
        "radiance of a white surface that faces it");
    line.option("--lamp", "X,Y,Z,SIZE,R,G,B", lamps, "a ball of diameter SIZE that emits this radiance");
    if (command != For::kView)
        line.option("--up", {"y", "z"}, upIsZ, "the axis that points up, for sky and sun");
    addMaterialChanges(line, read.changes);
    line.group(kReading);
    line.option("--scale", "S", read.scale, {1e-9, 1e9}, "multiply the model's coordinates");
    line.flag("--two-sided", read.twoSided, "light both sides of polygons");
}

void SolveOptions::finish(const common::CommandLine &line) {
    auto byRays = line.givenOf({kByRays}), byPatches = line.givenOf({kByPatches});
    if (!byRays.empty() && !byPatches.empty())
        throw common::Refused(byRays.back().option + " and " + byPatches.back().option +
                              " do not go together: one solves by rays, the other between patches");
    if (!byPatches.empty()) settings.method = SolveMethod::kPatches;
    common::need(settings.shots == 0 || settings.bounces < 0,
                 "--shots and --bounces do not go together: shots have no order by bounces");
    settings.memory = (size_t)(megabytes * 1048576);
    if (line.has("--power")) settings.evenSky = false; // without lamps the model stays dark
    Surroundings &to = settings.surroundings;
    if (std::optional<Rgb> even = evenRadiance(sky))
        to.sky = evenSky(*even);
    else if (!sky.empty() && sky.find_first_not_of("0123456789.,+-eE") == std::string::npos)
        throw common::Refused("--sky takes R,G,B or a picture, not '" + sky + "'");
    else if (!sky.empty())
        to.sky = readSky(sky, upIsZ, to.suns, &skyNotes);
    for (const std::string &text : suns) {
        auto s = common::numbersOf("--sun", text, 5);
        to.suns.push_back({sunTowards(s[0], s[1], upIsZ), lightOf("--sun", &s[2])});
    }
    for (const std::string &text : lamps) {
        auto l = common::numbersOf("--lamp", text, 7);
        common::need(l[3] > 0, "--lamp: its size must be above 0");
        to.lamps.push_back(ballLamp({l[0], l[1], l[2]}, l[3] / 2, lightOf("--lamp", &l[4])));
    }
}

void SolveOptions::addLights(const Mesh &mesh, Surroundings &to, std::vector<std::string> &notes) const {
    notes.insert(notes.end(), skyNotes.begin(), skyNotes.end());
    to.lamps.insert(to.lamps.end(), mesh.lights.lamps.begin(), mesh.lights.lamps.end());
    if (suns.empty())
        to.suns.insert(to.suns.end(), mesh.lights.suns.begin(), mesh.lights.suns.end());
    else if (!mesh.lights.suns.empty())
        notes.emplace_back("--sun replaces the model's own suns");
}

} // namespace odraz::radiosity
