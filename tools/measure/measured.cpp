#include "tools/measure/measured.h"

#include "tools/radiosity/generate.h"
#include "host/headless.h"
#include "host/threads.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <unistd.h>

namespace odraz {

Mesh generatedMesh(const std::string &kind, double area) {
    // By a file: what is measured is what users read
    char folder[] = "/tmp/odraz-XXXXXX";
    if (!mkdtemp(folder)) throw std::runtime_error("there is no room in /tmp");
    std::string obj = std::string(folder) + "/model.obj", mtl = std::string(folder) + "/model.mtl";
    std::ofstream(mtl) << generateMtl();
    std::ofstream(obj) << "mtllib model.mtl\n" << generateObj(kind, area);
    std::vector<std::string> notes;
    Mesh mesh;
    std::string wrong;
    try {
        mesh = readObj(obj, notes);
    } catch (const std::runtime_error &e) {
        wrong = e.what();
    }
    unlink(obj.c_str()), unlink(mtl.c_str()), rmdir(folder);
    if (!wrong.empty()) throw std::runtime_error(wrong);
    return mesh;
}

void openAll(Gl &gl, Workers &workers) {
    static const int never = 0;
    const char *missing = openHeadlessGl(gl);
    if (!missing) missing = startWorkers(workers, (int)sysconf(_SC_NPROCESSORS_ONLN), &never);
    if (missing) throw std::runtime_error(missing);
}

std::vector<Probe> referenceOf(const Mesh &mesh, const Gl &gl, Workers &workers, int probes, bool quick) {
    static const int never = 0;
    double area = areaOf(mesh);
    BakeSettings fine;
    fine.rays = quick ? 32 : 64;
    fine.patch = area / (quick ? 4000 : 12000);
    fine.element = area / (quick ? 100000 : 500000);
    fine.lampSamples = 128;
    fine.memory = (size_t)8 << 30;
    auto solved = bake(mesh, fine, gl, workers, &never, {});
    std::vector<Probe> places = placeProbes(*solved->model, probes);
    gatherProbes(*solved, places, quick ? 48 : 96, workers);
    return places;
}

} // namespace odraz
