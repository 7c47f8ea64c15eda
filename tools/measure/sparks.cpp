// sparks: how many sparks the film shows, or a folder of its pictures.
#include "show/show.h"
#include "tools/common/arguments.h"
#include "tools/measure/screening.h"
#include "tools/measure/spark.h"
#include "tools/picture/picture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

using namespace odraz;

static constexpr char kUsage[] =
    "usage: sparks [--from S=0] [--to S] [--fps N=25] [--quality NAME=play] [--size WxH=1280x720]\n"
    "              [--apart S=0.005] [--least LEVELS=24] [--reach PIXELS=3] [--list] [--keep DIR]\n"
    "       sparks FOLDER [--least LEVELS=24] [--reach PIXELS=12] [--list]\n"
    "Counts points of one to three pixels that are at least that many levels (of 255) above their surround "
    "and "
    "that\n"
    "one of the neighbouring pictures lacks: of the film, the pictures --apart before and after; of a folder "
    "of "
    "PNG or\n"
    "PPM, the files before and after by name. Writes a CSV by scene to stdout, or with --list every spark; "
    "--keep "
    "writes\n"
    "the pictures with sparks as PNG.\n";

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

struct Wishes {
    double from = 0, to = duration(), fps = 25, apart = 0.005;
    std::string quality = "play", size = "1280x720", folder, keep;
    int least = 24, reach = 0;
    bool list = false;
};

void list(const char *where, const std::vector<Spark> &sparks) {
    for (const Spark &s : sparks) std::printf("%s,%d,%d,%d,%d\n", where, s.x, s.y, s.over, s.surround);
    std::fflush(stdout);
}

void lookAtFilm(const Wishes &w) {
    IntroSettings settings = sizeFrom(w.size);
    const Quality &quality = qualityFrom(w.quality);
    Screening screening(settings, w.from, w.to);
    auto see = [&](double seconds) {
        odraz::Picture p = screening.picture(std::clamp(seconds, 0., duration()), quality);
        return greyOf(p.width, p.height, p.rgba, 4);
    };
    std::vector<Count> scenes(kMaxScenes);
    for (int64_t n = (int64_t)std::ceil(w.from * w.fps - 1e-6); (double)n / w.fps < w.to; ++n) {
        double seconds = (double)n / w.fps;
        Grey now = see(seconds);
        std::vector<Spark> sparks = pointsOf(now, w.least);
        if (!sparks.empty()) {
            Grey before = see(seconds - w.apart), after = see(seconds + w.apart);
            sparks = sparksOf(sparks, now, &before, &after, w.reach ? w.reach : 3);
        }
        scenes[(size_t)sceneAt(seconds)].add(sparks.size());
        if (w.list) list(std::to_string(seconds).c_str(), sparks);
        if (!w.keep.empty() && !sparks.empty()) {
            odraz::Picture p = screening.picture(seconds, quality);
            ::Picture image = {p.width, p.height, {}};
            for (size_t i = 0; i < (size_t)p.width * (size_t)p.height; ++i)
                image.rgb.insert(image.rgb.end(), p.rgba + 4 * i, p.rgba + 4 * i + 3);
            std::string path = w.keep + "/" + std::to_string(n) + ".png";
            if (!writePng(path, image)) throw std::runtime_error("cannot write " + path);
        }
    }
    if (w.list) return;
    Count all;
    for (int i = 0; i < kMaxScenes; ++i) {
        const Count &c = scenes[(size_t)i];
        if (c.pictures) c.tell(sceneName(i));
        all = {all.pictures + c.pictures, all.marked + c.marked, all.sparks + c.sparks,
               std::max(all.most, c.most)};
    }
    all.tell("all");
}

void lookAtFolder(const Wishes &w) {
    std::vector<std::string> files;
    for (const auto &f : std::filesystem::directory_iterator(w.folder)) files.push_back(f.path());
    std::sort(files.begin(), files.end());
    auto see = [&](size_t i) {
        ::Picture p;
        if (!readPicture(files[i], p)) throw Refused("cannot read a picture from " + files[i]);
        return greyOf(p.width, p.height, p.rgb.data(), 3);
    };
    if (files.size() < 2) throw Refused(w.folder + " holds fewer than two pictures");
    Count all;
    Grey before, now = see(0), after;
    for (size_t i = 0; i < files.size(); ++i) {
        bool first = i == 0, last = i + 1 == files.size();
        if (!last) after = see(i + 1);
        std::vector<Spark> sparks = sparksOf(pointsOf(now, w.least), now, first ? nullptr : &before,
                                             last ? nullptr : &after, w.reach ? w.reach : 12);
        all.add(sparks.size());
        if (w.list) list(files[i].c_str(), sparks);
        before = std::move(now);
        now = std::move(after);
    }
    if (!w.list) all.tell("all");
}

int run(Arguments &words) {
    Wishes w;
    while (const char *word = words.next()) {
        std::string o = word;
        if (o == "--from")
            w.from = words.number(o, 0, duration());
        else if (o == "--to")
            w.to = words.number(o, 0, duration());
        else if (o == "--fps")
            w.fps = words.number(o, 0.01, 1000);
        else if (o == "--apart")
            w.apart = words.number(o, 1e-4, 1);
        else if (o == "--quality")
            w.quality = words.value(o);
        else if (o == "--size")
            w.size = words.value(o);
        else if (o == "--least")
            w.least = words.whole(o, 1, 255);
        else if (o == "--reach")
            w.reach = words.whole(o, 1, 100);
        else if (o == "--keep")
            w.keep = words.value(o);
        else if (o == "--list")
            w.list = true;
        else if (o[0] != '-' && w.folder.empty())
            w.folder = o;
        else
            words.refuse(o);
    }
    std::puts(w.list             ? "where,x,y,over,surround"
              : w.folder.empty() ? "scene,pictures,with_sparks,sparks,most"
                                 : "folder,pictures,with_sparks,sparks,most");
    w.folder.empty() ? lookAtFilm(w) : lookAtFolder(w);
    return 0;
}

} // namespace

int main(int argc, char **argv) { return runProgram("sparks", kUsage, argc, argv, run); }
