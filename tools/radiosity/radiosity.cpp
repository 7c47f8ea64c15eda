// radiosity: solves the light in any model, and shows it.
#include "tools/common/machine.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/baked.h"
#include "tools/radiosity/camera_options.h"
#include "tools/radiosity/export_command.h"
#include "tools/radiosity/generate.h"
#include "tools/radiosity/solve_command.h"
#include "tools/radiosity/view_command.h"

#include <cstdio>

using namespace odraz;

namespace {

constexpr char kUsage[] =
    "usage: radiosity generate cube|columns|corner|vault|terrain -o MODEL.obj [--area A]\n"
    "       radiosity solve MODEL.obj -o OUT [OPTION...]\n"
    "       radiosity solve --resume OUT.state\n"
    "       radiosity export OUT --csv|--ply|--obj FILE\n"
    "       radiosity export OUT --atlas DIR [OPTION...]\n"
    "       radiosity render OUT -o FILE.png [--eye X,Y,Z --at X,Y,Z] [OPTION...]\n"
    "       radiosity view OUT|MODEL.obj [--layer patches|elements|wireframe|hemicube]... [OPTION...]\n"
    "\n"
    "solve reads Wavefront OBJ: polygons of any count, lit on the side from which they run\n"
    "counter-clockwise; materials reflect (Kd, map_Kd) and shine (Ke). Ctrl-C ends it early and writes what "
    "is "
    "there,\nand OUT.state, from which --resume goes on.\n"
    "  --rays N           from every element, 8 to 32768 (default: 32 to 512, as its light needs)\n"
    "  --final N          rays from every element once more in the end, in the light that was found: for "
    "quality\n"
    "  --element AREA     of an element, which keeps light (default: a 30000th of the model's area;\n"
    "                     with --final a 120000th)\n"
    "  --lamp-samples N   parts of the largest lamp, 1 to 256 (default 16)\n"
    "  --bounces N        follow light over N bounces (default: until the residual is reached)\n"
    "  --residual R       stop when a sweep changes less than this share of the light (default 1e-4)\n"
    "  --memory MB        most memory for the solution (default 8192)\n"
    "  --keep-every S     write OUT.state every S seconds, too (default 60)\n"
    "Between patches, by hemicubes that OpenGL draws, instead of by rays:\n"
    "  --hemicube PX      pixels of a hemicube's top face, even, 4 to 1024 (default 16)\n"
    "  --patch AREA       of a patch, which has a hemicube (default: a 6000th of the model's area)\n"
    "  --adaptive         start with elements of 16 times the area and divide them where light changes\n"
    "  --direct analytic|hemicube   light from lamps by shadow rays, or as hemicubes see them (which are\n"
    "                     taken for more than 256 lamps)\n"
    "  --progress         tell how far it is in lines on stderr, where that is no terminal and has no bar\n"
    "Light that the model does not bring along; where nothing shines, an even sky of 1,1,1:\n"
    "  --sky R,G,B|FILE.hdr   radiance from all directions, even or as a picture has it\n"
    "  --sun ELEVATION,AZIMUTH,R,G,B   degrees above the horizon, and from -z (+y where z is up) towards "
    "+x;\n"
    "                     R,G,B is what a white surface shows that faces it. Several may be given\n"
    "  --lamp X,Y,Z,SIZE,R,G,B   a ball, SIZE across, of that radiance. Several may be given\n"
    "  --up y|z           which way is up, for sky and sun (default y)\n"
    "  --scale S          multiply the model's coordinates\n"
    "  --two-sided        light the backs of polygons, too\n"
    "generate divides polygons into triangles of at most --area; without it they stay whole.\n"
    "render shows all of the model, from above and aside, and tells where the camera stands, or what --eye "
    "and\n"
    "--at say; exposed for what it sees.\n"
    "  --size WxH         pixels (default 1280x720)\n"
    "  --lens DEGREES     vertical field of view, 1 to 170 (default 60)\n"
    "  --exposure STOPS   brighter by so many powers of two, -20 to 20 (default 0)\n"
    "  --tone log|film    the light's logarithm, or the film's curve (default film)\n"
    "  --up y|z           which way is up (default y)\n"
    "view opens a window to fly through a solution, or a model while it is solved; it takes the options of "
    "render "
    "and,\n"
    "for a model, of solve. It tells its keys when it starts.\n"
    "  --layer NAME       shown from the start: patches in a colour each, outlines of elements, wireframe, "
    "or\n"
    "                     what the hemicube of the patch under the pointer sees. Several may be given\n"
    "  --screenshot FILE.png   write the picture, once all light is there, and end\n"
    "export: CSV has a line for every element; PLY and OBJ have colours at their points. An atlas is "
    "lightmaps\n"
    "(PNG, and HDR, which is linear) in a new folder, with the model as OBJ and glTF, which has their "
    "coordinates.\n"
    "  --map light|radiosity   what arrives, irradiance over pi, to be multiplied by colours (default), or "
    "what\n"
    "                     is seen, with what is emitted\n"
    "  --texels N         along a unit of length (default: as the elements are, which is exact)\n"
    "  --padding N        texels around every polygon's, 1 to 64 (default 2)\n"
    "  --page PX          a page's longest side, 256 to 16384 (default 8192)\n";

int runGenerate(Arguments &words) {
    std::string kind, out;
    double area = 0;
    while (const char *word = words.next()) {
        std::string w = word;
        if (w == "-o")
            out = words.value(w);
        else if (w == "--area")
            area = words.number(w, 1e-4, 1e6);
        else if (word[0] != '-' && kind.empty())
            kind = w;
        else
            words.refuse(w);
    }
    static const char *const kinds[] = {"cube", "columns", "corner", "vault", "terrain"};
    if (std::find(std::begin(kinds), std::end(kinds), kind) == std::end(kinds))
        throw Refused("generate makes a cube, columns, a corner, a vault or a terrain: name one of them");
    if (out.size() < 5 || out.compare(out.size() - 4, 4, ".obj"))
        throw Refused("name a file with -o MODEL.obj");
    checkWritable(out);
    std::string mtl = out.substr(0, out.size() - 4) + ".mtl", name = mtl.substr(mtl.rfind('/') + 1);
    size_t triangles = 0;
    std::string model = generateObj(kind, area, &triangles);
    writeWhole(mtl, generateMtl());
    writeWhole(out, "mtllib " + name + "\n" + model);
    bool fine = area > 0 || kind == "vault" || kind == "terrain";
    std::printf("%s: %zu %s\n", out.c_str(), fine ? triangles : triangles / 2,
                fine ? "triangles" : "polygons");
    return 0;
}

int runRender(Arguments &words) {
    std::string in, out;
    CameraOptions camera;
    while (const char *word = words.next()) {
        std::string w = word;
        if (w == "-o")
            out = words.value(w);
        else if (camera.take(w, words))
            continue;
        else if (word[0] != '-' && in.empty())
            in = w;
        else
            words.refuse(w);
    }
    if (in.empty() || out.empty()) throw Refused("render needs a solution and -o FILE.png");
    camera.finish("render");
    checkWritable(out);
    Workers workers = allProcessors();
    Baked baked(in);
    RenderSettings &s = camera.settings;
    if (!camera.placed()) {
        placeCamera(baked, s);
        std::printf("%s\n", placeAsTold(s).c_str());
    }
    render(baked, s, workers, out);
    return 0;
}

int run(Arguments &words) {
    const char *word = words.next();
    std::string what = word ? word : "";
    if (what == "generate") return runGenerate(words);
    if (what == "solve") return runSolve(words);
    if (what == "export") return runExport(words);
    if (what == "render") return runRender(words);
    if (what == "view") return runView(words);
    throw Refused("say what to do: generate, solve, export, render or view; see radiosity --help");
}

} // namespace

int main(int argc, char **argv) { return runProgram("radiosity", kUsage, argc, argv, run); }
