// sparks: counts the sparks in the film, or in a folder of pictures.
#include "show/show.h"
#include "tools/common/arguments.h"
#include "tools/measure/detect/screening.h"
#include "tools/measure/detect/spark.h"
#include "tools/picture/picture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

using namespace odraz;

static constexpr char kUsage[] =
    "usage: sparks [--from S=0] [--to S] [--fps N=25] [--quality NAME=play] [--size WxH=1280x720]\n"
    "              [--apart S=0.005] [--least LEVELS=24] [--reach PIXELS=3] [--list] [--keep DIR]\n"
    "       sparks FOLDER [--least LEVELS=24] [--reach PIXELS=12] [--list]\n"
    "Counts sparks: points of one to three pixels that are at least --least levels (of 255) brighter than\n"
    "what surrounds them, and that a neighbouring picture lacks. The neighbours are the film's pictures\n"
    "--apart seconds before and after, or in a folder of PNG or PPM the files before and after by name.\n"
    "It lacks the point if it shows nothing half as bright within --reach pixels.\n"
    "Writes a CSV to stdout: a row for each scene, or with --list for each spark. --keep writes the\n"
    "pictures that have sparks as PNG.\n";

namespace {

struct Count {
    int pictures = 0, marked = 0, sparks = 0, most = 0;
    void add(size_t found) {
        ++pictures;
        marked += found > 0;
        sparks += (int)found;
        most = std::max(most, (int)found);
    }
    void tell(const char *name) const {
        if (pictures) std::printf("%s,%d,%d,%d,%d\n", name, pictures, marked, sparks, most);
        std::fflush(stdout);
    }
};

struct Options : ScreeningOptions {
    double from = 0, to = duration(), fps = 25, apart = 0.005; // seconds; pictures a second
    std::string folder;
    int least = 24, reach = 0;
    bool list = false;
};

void list(const char *where, const std::vector<Spark> &sparks) {
    for (const Spark &s : sparks) std::printf("%s,%d,%d,%d,%d\n", where, s.x, s.y, s.over, s.surround);
    std::fflush(stdout);
}

void lookAtFilm(const Options &o) {
    IntroSettings settings = sizeFrom(o.size);
    const Quality &quality = qualityFrom(o.qualities.empty() ? "play" : o.qualities.back());
    Screening screening(settings, o.from, o.to);
    auto see = [&](double seconds) {
        odraz::Picture p = screening.picture(std::clamp(seconds, 0., duration()), quality);
        return greyOf(p.width, p.height, p.rgba, 4);
    };
    std::vector<Count> scenes(kMaxScenes);
    for (int64_t n = (int64_t)std::ceil(o.from * o.fps - 1e-6); (double)n / o.fps < o.to; ++n) {
        double seconds = (double)n / o.fps;
        Grey now = see(seconds);
        std::vector<Spark> sparks = pointsOf(now, o.least);
        if (!sparks.empty()) {
            Grey before = see(seconds - o.apart), after = see(seconds + o.apart);
            sparks = sparksOf(sparks, now, &before, &after, o.reach ? o.reach : 3);
        }
        scenes[(size_t)sceneAt(seconds)].add(sparks.size());
        if (o.list) list(std::to_string(seconds).c_str(), sparks);
        if (!o.keep.empty() && !sparks.empty()) {
            odraz::Picture p = screening.picture(seconds, quality);
            pictures::Image image = {p.width, p.height, {}};
            for (size_t i = 0; i < (size_t)p.width * (size_t)p.height; ++i)
                image.rgb.insert(image.rgb.end(), p.rgba + 4 * i, p.rgba + 4 * i + 3);
            std::string path = o.keep + "/" + std::to_string(n) + ".png";
            pictures::writePng(path, image);
        }
    }
    if (o.list) return;
    Count all;
    for (int i = 0; i < kMaxScenes; ++i) {
        const Count &c = scenes[(size_t)i];
        if (c.pictures) c.tell(sceneName(i));
        all = {all.pictures + c.pictures, all.marked + c.marked, all.sparks + c.sparks,
               std::max(all.most, c.most)};
    }
    all.tell("all");
}

void lookAtFolder(const Options &o) {
    std::vector<std::string> files;
    for (const auto &f : std::filesystem::directory_iterator(o.folder)) files.push_back(f.path());
    std::sort(files.begin(), files.end());
    auto see = [&](size_t i) {
        pictures::Image p = pictures::readPicture(files[i]);
        return greyOf(p.width, p.height, p.rgb.data(), 3);
    };
    if (files.size() < 2) throw common::Refused(o.folder + " holds fewer than two pictures");
    Count all;
    Grey before, now = see(0), after;
    for (size_t i = 0; i < files.size(); ++i) {
        bool first = i == 0, last = i + 1 == files.size();
        if (!last) after = see(i + 1);
        std::vector<Spark> sparks = sparksOf(pointsOf(now, o.least), now, first ? nullptr : &before,
                                             last ? nullptr : &after, o.reach ? o.reach : 12);
        all.add(sparks.size());
        if (o.list) list(files[i].c_str(), sparks);
        before = std::move(now);
        now = std::move(after);
    }
    if (!o.list) all.tell("all");
}

int run(common::Arguments &words) {
    Options o;
    while (const char *word = words.next()) {
        std::string w = word;
        if (w == "--from")
            o.from = words.number(w, 0, duration());
        else if (w == "--to")
            o.to = words.number(w, 0, duration());
        else if (w == "--fps")
            o.fps = words.number(w, 0.01, 1000);
        else if (w == "--apart")
            o.apart = words.number(w, 1e-4, 1);
        else if (w == "--least")
            o.least = words.whole(w, 1, 255);
        else if (w == "--reach")
            o.reach = words.whole(w, 1, 100);
        else if (w == "--list")
            o.list = true;
        else if (w[0] != '-' && o.folder.empty())
            o.folder = w;
        else if (!o.take(w, words))
            words.refuse(w);
    }
    std::puts(o.list             ? "where,x,y,over,surround"
              : o.folder.empty() ? "scene,pictures,with_sparks,sparks,most"
                                 : "folder,pictures,with_sparks,sparks,most");
    o.folder.empty() ? lookAtFilm(o) : lookAtFolder(o);
    return 0;
}

} // namespace

int main(int argc, char **argv) { return common::runProgram("sparks", kUsage, argc, argv, run); }
