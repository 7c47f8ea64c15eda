// radiosity: solves the light in any model, and shows it.
#include "tools/radiosity/baked.h"
#include "tools/radiosity/generate.h"
#include "host/headless.h"
#include "host/threads.h"
#include "tools/radiosity/lamps.h"
#include "trace/picture/frame.h"

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <unistd.h>

using namespace odraz;

namespace {

constexpr char kUsage[] =
    "usage: radiosity generate cube|columns|corner -o MODEL.obj [--area A]\n"
    "       radiosity solve MODEL.obj -o OUT [OPTION...]\n"
    "       radiosity export OUT --csv|--ply|--obj FILE\n"
    "       radiosity render OUT -o FILE.png --eye X,Y,Z --at X,Y,Z [--size WxH] [--tone log|film]\n"
    "\n"
    "solve reads Wavefront OBJ: polygons of any count, lit on the side from which they run\n"
    "counter-clockwise; materials reflect (Kd) and shine (Ke). Ctrl-C ends it early and writes what is "
    "there.\n"
    "  --hemicube PX      pixels of a hemicube's top face, even, 4 to 1024 (default 16)\n"
    "  --patch AREA       of a patch, which has a hemicube (default: a 6000th of the model's area)\n"
    "  --element AREA     of an element, which keeps light (default: a 30000th)\n"
    "  --adaptive         start with elements of 16 times the area and divide them where light changes\n"
    "  --bounces N        follow light over N bounces (default: until the residual is reached)\n"
    "  --residual R       stop when a sweep changes less than this share of the light (default 1e-4)\n"
    "  --lamp-samples N   parts of the largest lamp, 1 to 256 (default 16)\n"
    "  --direct analytic|hemicube   light from lamps by shadow rays, or as hemicubes see them (which are\n"
    "                     taken for more than 256 lamps)\n"
    "  --memory MB        most memory for the solution (default 2048)\n"
    "generate divides polygons into triangles of at most --area; without it they stay whole.\n"
    "export: CSV has a line for every element; PLY and OBJ have colours at their points.\n";

int refuse(const std::string &line) {
    std::fprintf(stderr, "radiosity: %s\n", line.c_str());
    return 2;
}

int stop = 0;

// A bar on a terminal; nothing where stderr is a file.
struct Bar {
    bool terminal = isatty(2);
    const char *step = nullptr;
    double began = 0;

    static double now() {
        timespec t;
        clock_gettime(CLOCK_MONOTONIC, &t);
        return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
    }
    void tell(const char *name, float done, float residual) {
        if (!terminal) return;
        if (!name) {
            std::fputs("\r\033[K", stderr);
            return;
        }
        if (name != step) step = name, began = now();
        char bar[31] = {}, rest[60] = "";
        for (int i = 0; i < 30; ++i) bar[i] = (float)i < done * 30 ? '#' : '.';
        if (residual >= 0) std::snprintf(rest, sizeof rest, ", residual %.1e", (double)residual);
        double left = done > 0.02f ? (now() - began) * (1 / (double)done - 1) : -1;
        std::fprintf(stderr, "\r\033[K%-13s [%s] %3.0f %%%s", name, bar, (double)done * 100, rest);
        if (left >= 0) std::fprintf(stderr, ", %.0f s left", left);
        std::fflush(stderr);
    }
};

struct Arguments {
    int count;
    char **words;
    int at = 2;
    std::string problem;

    const char *next() { return at < count ? words[at++] : nullptr; }
    const char *value(const char *option) {
        if (const char *v = next()) return v;
        problem = std::string(option) + " needs a value; see radiosity --help";
        return nullptr;
    }
    bool text(const char *option, std::string &to) {
        const char *text = value(option);
        if (text) to = text;
        return text;
    }
    // One of two words.
    bool choice(const char *option, const char *first, const char *second, bool &isFirst) {
        std::string word;
        if (!text(option, word)) return false;
        isFirst = word == first;
        if (!isFirst && word != second)
            problem = std::string(option) + " is " + first + " or " + second + ", not " + word;
        return problem.empty();
    }
    bool number(const char *option, double least, double most, double &to) {
        const char *text = value(option);
        if (!text) return false;
        char *end;
        double x = std::strtod(text, &end);
        if (end == text || *end || !(x >= least && x <= most)) {
            char range[100];
            std::snprintf(range, sizeof range, " takes a number from %g to %g, not ", least, most);
            problem = std::string(option) + range + text;
            return false;
        }
        to = x;
        return true;
    }
    bool whole(const char *option, int least, int most, int &to) {
        double x = 0;
        if (!number(option, least, most, x)) return false;
        if (x != std::floor(x)) {
            problem = std::string(option) + " takes a whole number";
            return false;
        }
        to = (int)x;
        return true;
    }
    bool place(const char *option, Vec3 &to) {
        const char *text = value(option);
        char rest;
        if (!text) return false;
        if (std::sscanf(text, "%f,%f,%f%c", &to.x, &to.y, &to.z, &rest) == 3 &&
            std::isfinite(to.x + to.y + to.z))
            return true;
        problem = std::string(option) + " takes three numbers like 1,2.5,-3, not " + text;
        return false;
    }
    bool unknown(const char *word) {
        problem = std::string("cannot use '") + word + "'; see radiosity --help";
        return false;
    }
};

bool mayWrite(const std::string &path) {
    size_t slash = path.rfind('/');
    std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
    return access(folder.c_str(), W_OK) == 0;
}

int runGenerate(Arguments &a) {
    std::string kind, out;
    double area = 0;
    bool good = true;
    while (const char *word = good ? a.next() : nullptr) {
        std::string w = word;
        if (w == "-o")
            good = a.text("-o", out);
        else if (w == "--area")
            good = a.number("--area", 1e-4, 1e6, area);
        else if (word[0] != '-' && kind.empty())
            kind = w;
        else
            good = a.unknown(word);
    }
    if (!good) return refuse(a.problem);
    size_t triangles = 0;
    if (kind != "cube" && kind != "columns" && kind != "corner")
        return refuse("generate makes a cube, columns or a corner: name one of them");
    if (out.size() < 5 || out.compare(out.size() - 4, 4, ".obj"))
        return refuse("name a file with -o MODEL.obj");
    std::string mtl = out.substr(0, out.size() - 4) + ".mtl", name = mtl.substr(mtl.rfind('/') + 1);
    std::string model = generateObj(kind, area, &triangles);
    writeWhole(mtl, generateMtl());
    writeWhole(out, "mtllib " + name + "\n" + model);
    std::printf("%s: %zu %s\n", out.c_str(), area > 0 ? triangles : triangles / 2,
                area > 0 ? "triangles" : "polygons");
    return 0;
}

int runSolve(Arguments &a, Workers &workers) {
    std::string model, out;
    BakeSettings s;
    double residual = 1e-4, memory = 2048;
    bool good = true;
    while (const char *word = good ? a.next() : nullptr) {
        std::string w = word;
        if (w == "-o")
            good = a.text("-o", out);
        else if (w == "--hemicube") {
            good = a.whole("--hemicube", 4, kMaxHemicube, s.hemicube);
            if (good && s.hemicube % 2) return refuse("--hemicube takes an even number");
        } else if (w == "--patch")
            good = a.number("--patch", 1e-18, 1e30, s.patch);
        else if (w == "--element")
            good = a.number("--element", 1e-18, 1e30, s.element);
        else if (w == "--bounces")
            good = a.whole("--bounces", 0, 10000, s.bounces);
        else if (w == "--residual")
            good = a.number("--residual", 1e-7, 1, residual);
        else if (w == "--lamp-samples")
            good = a.whole("--lamp-samples", 1, kMaxLampCells, s.lampSamples);
        else if (w == "--memory")
            good = a.number("--memory", 1, 1e6, memory);
        else if (w == "--adaptive")
            s.adaptive = true;
        else if (w == "--direct")
            good = a.choice("--direct", "analytic", "hemicube", s.analytic);
        else if (word[0] != '-' && model.empty())
            model = w;
        else
            good = a.unknown(word);
    }
    if (!good) return refuse(a.problem);
    if (model.empty()) return refuse("name a model: radiosity solve MODEL.obj -o OUT");
    if (out.empty()) return refuse("name a file for the solution with -o OUT");
    if (!mayWrite(out)) return refuse(out + ": cannot be written: " + std::strerror(errno));
    s.residual = (float)residual;
    s.memory = (size_t)(memory * 1048576);

    std::vector<std::string> notes;
    Mesh mesh = readObj(model, notes);
    for (const std::string &note : notes) std::fprintf(stderr, "radiosity: %s\n", note.c_str());
    Gl gl;
    if (const char *missing = openHeadlessGl(gl)) return refuse(missing);
    struct sigaction action = {};
    action.sa_handler = [](int) { __atomic_store_n(&stop, 1, __ATOMIC_RELAXED); };
    action.sa_flags = (int)SA_RESETHAND; // the second one ends the program
    sigaction(SIGINT, &action, nullptr);
    Bar bar;
    std::unique_ptr<Bake> b;
    try {
        b = bake(mesh, s, gl, workers, &stop,
                 [&](const char *step, float done, float left) { bar.tell(step, done, left); });
    } catch (const ModelError &e) {
        bar.tell(nullptr, 1, 0);
        throw ModelError(model + ": " + e.what());
    } catch (...) {
        bar.tell(nullptr, 1, 0);
        throw;
    }
    const Model &m = *b->model;
    Baked baked(*b);
    baked.save(out);
    int elements = 0, last = -1;
    baked.forPieces([&](int, int cell, const std::vector<BakedPoint> &) {
        elements += cell != last;
        last = cell;
    });
    std::printf("%zu triangles, %d polygons in one plane each; %d patches, %d elements\n",
                mesh.triangles.size(), m.chartCount, m.patchCount, elements);
    std::printf("processor seconds: dividing %.2f, form factors %.2f (%d hemicubes), direct light %.2f, "
                "solving %.2f\n",
                b->seconds[0], b->seconds[1], b->rows, b->seconds[2], b->seconds[3]);
    if (b->glows.size() > kManyLamps) std::printf("%zu lamps: seen by hemicubes\n", b->glows.size());
    if (!b->whole)
        std::printf("stopped: direct light, and the rows of %d patches\n", b->rows);
    else if (s.bounces >= 0)
        std::printf("%d bounces\n", b->sweeps);
    else
        std::printf("%d sweeps, residual %.1e\n", b->sweeps, (double)b->left);
    return 0;
}

int runExport(Arguments &a) {
    std::string in, kind, out;
    bool good = true;
    while (const char *word = good ? a.next() : nullptr) {
        std::string w = word;
        if (w == "--csv" || w == "--ply" || w == "--obj") {
            const char *v = a.value(word);
            good = v;
            if (v && !out.empty()) return refuse("export writes one file at a time");
            if (v) out = v, kind = w;
        } else if (word[0] != '-' && in.empty())
            in = w;
        else
            good = a.unknown(word);
    }
    if (!good) return refuse(a.problem);
    if (in.empty() || out.empty())
        return refuse("export needs a solution and a file: radiosity export OUT --csv FILE");
    Baked baked(in);
    kind == "--csv" ? exportCsv(baked, out) : kind == "--ply" ? exportPly(baked, out) : exportObj(baked, out);
    return 0;
}

int runRender(Arguments &a, Workers &workers) {
    std::string in, out;
    RenderSettings s;
    bool good = true, eye = false, at = false;
    while (const char *word = good ? a.next() : nullptr) {
        std::string w = word;
        if (w == "-o")
            good = a.text("-o", out);
        else if (w == "--eye")
            good = eye = a.place("--eye", s.eye);
        else if (w == "--at")
            good = at = a.place("--at", s.target);
        else if (w == "--size") {
            const char *v = a.value("--size");
            char rest;
            good = v;
            if (v && (std::sscanf(v, "%dx%d%c", &s.width, &s.height, &rest) != 2 || s.width < 1 ||
                      s.height < 1 || s.width > kMaxWidth || s.height > kMaxHeight))
                return refuse(std::string("--size takes pixels like 1280x720, up to 7680x4320, not ") + v);
        } else if (w == "--tone")
            good = a.choice("--tone", "log", "film", s.logarithmic);
        else if (word[0] != '-' && in.empty())
            in = w;
        else
            good = a.unknown(word);
    }
    if (!good) return refuse(a.problem);
    if (in.empty() || out.empty() || !eye || !at)
        return refuse("render needs a solution, -o FILE.png, --eye X,Y,Z and --at X,Y,Z");
    if (!mayWrite(out)) return refuse(out + ": cannot be written: " + std::strerror(errno));
    render(Baked(in), s, workers, out);
    return 0;
}

} // namespace

int main(int argc, char **argv) {
    std::string what = argc > 1 ? argv[1] : "";
    for (int i = 1; i < argc; ++i)
        if (!std::strcmp(argv[i], "--help")) {
            std::fputs(kUsage, stdout);
            return std::fflush(stdout) ? 1 : 0;
        }
    Arguments arguments = {argc, argv, 2, {}};
    static const int never = 0;
    Workers workers = serialWorkers();
    try {
        if (what == "solve" || what == "render")
            if (const char *missing = startWorkers(workers, (int)sysconf(_SC_NPROCESSORS_ONLN), &never))
                return refuse(missing);
        if (what == "generate") return runGenerate(arguments);
        if (what == "solve") return runSolve(arguments, workers);
        if (what == "export") return runExport(arguments);
        if (what == "render") return runRender(arguments, workers);
    } catch (const std::exception &e) {
        refuse(e.what());
        return dynamic_cast<const ModelError *>(&e) ? 2 : 1;
    }
    return refuse("say what to do: generate, solve, export or render; see radiosity --help");
}
