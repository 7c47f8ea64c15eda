#include "tools/radiosity/export/camera_options.h"

#include "tools/common/text.h"
#include "trace/picture/frame.h"

#include <cstdio>

namespace odraz::radiosity {

namespace {

Vec3d pointOf(const std::string &option, const std::string &text) {
    std::vector<double> p = common::numbersOf(option, text, 3);
    return {p[0], p[1], p[2]};
}

// Returns a point as an option, and sets the point to the rounded numbers of this option.
std::string pointOption(const char *option, Vec3 &p, const Vec3 &origin) {
    Vec3d at = toDouble(origin) + toDouble(p);
    int digits = Solution::digitsAt(origin) - 1;
    std::string text = common::format("%.*g,%.*g,%.*g", digits, at.x, digits, at.y, digits, at.z);
    p = toFloat(pointOf(option, text) - toDouble(origin));
    return std::string(option) + " " + text;
}

} // namespace

void CameraOptions::addTo(common::CommandLine &line) {
    RenderSettings &s = settings;
    line.group("Camera");
    auto place = [&](const std::string &option, Vec3d &to, const std::string &what) {
        line.option(
            option, "X,Y,Z", [&to, option](const std::string &text) { to = pointOf(option, text); }, what);
    };
    place("--eye", eye, "the camera's position; without --eye and --at the whole model, from its open side");
    place("--at", target, "the point that the camera looks at");
    line.option("--lens", "DEGREES", s.lens, {1, 170}, "vertical field of view");
    line.option("--up", {"y", "z"}, s.upIsZ, "the axis that points up; by default y, or the room's");
    line.option(
        "--size", "WxH",
        [&s](const std::string &text) {
            auto [width, height] = common::sizeOf("--size", text, {kMaxWidth, kMaxHeight});
            s.width = width, s.height = height;
        },
        "pixels (default " + std::to_string(s.width) + "x" + std::to_string(s.height) + ")");
    line.option("--exposure", "STOPS", s.stops, {-20, 20}, "multiply the brightness by 2^STOPS");
    line.option("--tone", {"film", "log"}, s.logarithmic,
                "use the film's curve, or show the logarithm of the light");
}

void CameraOptions::finish(const common::CommandLine &line) {
    placed = line.has("--eye"), up = line.has("--up");
    if (placed != line.has("--at")) line.refuse("--eye and --at go together: give both, or neither");
}

void CameraOptions::moveTo(const Vec3 &origin) {
    settings.origin = origin;
    settings.eye = toFloat(eye - toDouble(origin)), settings.target = toFloat(target - toDouble(origin));
}

std::string placeOptions(RenderSettings &s) {
    std::string first = pointOption("--eye", s.eye, s.origin);
    return first + " " + pointOption("--at", s.target, s.origin);
}

std::string cameraLine(RenderSettings s) {
    char rest[160];
    std::snprintf(rest, sizeof rest, " --lens %g --up %s --exposure %g --tone %s --size %dx%d",
                  (double)s.lens, s.upIsZ ? "z" : "y", (double)s.stops, s.logarithmic ? "log" : "film",
                  s.width, s.height);
    return placeOptions(s) + rest;
}

} // namespace odraz::radiosity
