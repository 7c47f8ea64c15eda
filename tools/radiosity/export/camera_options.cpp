#include "tools/radiosity/export/camera_options.h"

#include "trace/picture/frame.h"

#include <cmath>
#include <cstdio>

namespace odraz::radiosity {

namespace {

Vec3 readPlace(const std::string &option, const std::string &text) {
    Vec3 p;
    char rest;
    if (std::sscanf(text.c_str(), "%f,%f,%f%c", &p.x, &p.y, &p.z, &rest) == 3 &&
        std::isfinite(p.x + p.y + p.z))
        return p;
    throw common::Refused(option + " takes three numbers like 1,2.5,-3, not " + text);
}

void readSize(const std::string &text, int &width, int &height) {
    char rest;
    if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) != 2 || width < 1 || height < 1 ||
        width > kMaxWidth || height > kMaxHeight)
        throw common::Refused("--size takes pixels like 1280x720, up to 7680x4320, not " + text);
}

// Writes a place as an option, and sets it to the value that reading the option gives.
std::string pointOption(const char *option, Vec3 &p) {
    char text[96];
    std::snprintf(text, sizeof text, "%g,%g,%g", (double)p.x, (double)p.y, (double)p.z);
    p = readPlace(option, text);
    return std::string(option) + " " + text;
}

} // namespace

bool CameraOptions::take(const std::string &w, common::Arguments &words) {
    RenderSettings &s = settings;
    if (w == "--eye")
        s.eye = readPlace(w, words.value(w)), eye = true;
    else if (w == "--at")
        s.target = readPlace(w, words.value(w)), at = true;
    else if (w == "--size")
        readSize(words.value(w), s.width, s.height);
    else if (w == "--lens")
        s.lens = (float)words.number(w, 1, 170);
    else if (w == "--exposure")
        s.stops = (float)words.number(w, -20, 20);
    else if (w == "--up")
        s.upIsZ = words.choice(w, "z", "y"), up = true;
    else if (w == "--tone")
        s.logarithmic = words.choice(w, "log", "film");
    else
        return false;
    return true;
}

void CameraOptions::finish(const std::string &command) const {
    if (eye != at) throw common::Refused(command + " needs --eye and --at, or neither");
}

std::string placeOptions(RenderSettings &s) {
    std::string first = pointOption("--eye", s.eye);
    return first + " " + pointOption("--at", s.target);
}

std::string cameraLine(RenderSettings s) {
    char rest[160];
    std::snprintf(rest, sizeof rest, " --lens %g --up %s --exposure %g --tone %s --size %dx%d",
                  (double)s.lens, s.upIsZ ? "z" : "y", (double)s.stops, s.logarithmic ? "log" : "film",
                  s.width, s.height);
    return placeOptions(s) + rest;
}

} // namespace odraz::radiosity
