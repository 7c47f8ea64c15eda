// radiosity: computes the light in any model, and shows it.
#include "tools/common/arguments.h"
#include "tools/radiosity/export/export_command.h"
#include "tools/radiosity/export/render_command.h"
#include "tools/radiosity/generate/generate_command.h"
#include "tools/radiosity/solve/solve_command.h"
#include "tools/radiosity/transfer/transfer_command.h"
#include "tools/radiosity/view/view_command.h"

using namespace odraz;

namespace {

constexpr char kUsage[] =
    "usage: radiosity generate cube|columns|corner|vault|terrain -o MODEL.obj [OPTION...]\n"
    "       radiosity solve MODEL.obj -o OUT [OPTION...]\n"
    "       radiosity solve --resume OUT.state\n"
    "       radiosity solve MODEL.obj --relight SOLUTION -o OUT [--power P]... [--reflectance R]...\n"
    "       radiosity transfer MODEL.obj -o ROOM.prt [OPTION...]\n"
    "       radiosity export OUT|ROOM.prt --csv|--ply|--obj FILE\n"
    "       radiosity export OUT --atlas DIR [OPTION...]\n"
    "       radiosity render OUT|ROOM.prt -o FILE.png [--eye X,Y,Z --at X,Y,Z] [OPTION...]\n"
    "       radiosity view OUT|ROOM.prt|MODEL.obj [OPTION...]\n"
    "\n"
    "generate writes an example model. Its polygons are divided into triangles of at most --area;\n"
    "without --area they stay whole. It takes --reflectance and --power.\n"
    "\n"
    "solve computes the light in a Wavefront OBJ model and writes it to OUT. Polygons may have any\n"
    "number of points and are lit on the side from which these run counter-clockwise. Materials\n"
    "reflect light (Kd, map_Kd) and emit it (Ke). Ctrl-C stops early: it writes the light found so\n"
    "far to OUT, and OUT.state, from which --resume continues.\n"
    "  --rays N           rays from every element, 8 to 32768 (default: 32 to 512, as its light needs)\n"
    "  --final N          end with a final gather: N more rays from every element, for quality\n"
    "  --element AREA     area of an element, which keeps light (default: a 30000th of the model's area;\n"
    "                     with --final a 120000th)\n"
    "  --lamp-samples N   shadow rays to the largest lamp, 1 to 256 (default 16)\n"
    "  --bounces N        follow light over N bounces (default: until the residual is reached)\n"
    "  --residual R       stop when a sweep changes less than this share of the light (default 1e-4)\n"
    "  --memory MB        refuse a solution that needs more memory (default 8192)\n"
    "  --keep-every S     write OUT.state every S seconds (default 60)\n"
    "  --keep-rows        keep the form factors in OUT.rows, for solutions with other materials\n"
    "  --relight SOLUTION   solve with those in SOLUTION.rows and with its options\n"
    "  --progress         report progress in lines on stderr where it is not a terminal\n"
    "These options solve between patches, by hemicubes that OpenGL draws, instead of by rays:\n"
    "  --hemicube PX      pixels along a hemicube's top face, even, 4 to 1024 (default 16)\n"
    "  --patch AREA       area of a patch, which has one hemicube (default: a 6000th of the model's area)\n"
    "  --adaptive         start with elements of 16 times the area and divide them where light changes\n"
    "  --direct analytic|hemicube   light from lamps by shadow rays, or as hemicubes see the lamps\n"
    "                     (default analytic; with more than 256 lamps hemicube)\n"
    "Light from outside the model. Where nothing shines, an even sky of 1,1,1 does:\n"
    "  --sky R,G,B|FILE.hdr   radiance from all directions: even, or a picture\n"
    "  --sun ELEVATION,AZIMUTH,R,G,B   parallel light, repeatable. Degrees above the horizon, and from\n"
    "                     -z (+y where z is up) towards +x; a white surface that faces it shows R,G,B\n"
    "  --lamp X,Y,Z,SIZE,R,G,B   a ball, SIZE across, that emits this radiance; repeatable\n"
    "  --up y|z           the axis that points up, for sky and sun (default y)\n"
    "Other materials than the model's, repeatable. FACTOR multiplies what the material has:\n"
    "  --reflectance [NAME=]R,G,B|FACTOR   what the material NAME reflects, 0 to 1; without NAME all do\n"
    "  --power [NAME=]R,G,B|FACTOR   the radiance that it emits; without NAME of all that emit\n"
    "How the model is read:\n"
    "  --scale S          multiply its coordinates\n"
    "  --two-sided        light both sides of polygons\n"
    "\n"
    "transfer solves a model for any light from outside, and for each of its lamps: a material that\n"
    "emits, a ball or a sun. render and export show the room in any of these lights. It takes those\n"
    "options of solve that say how the model is read and how rays find its light, and\n"
    "  --bands N          bands of spherical harmonics of the light, 1 to 6 (default 5)\n"
    "  --clusters K       clusters of the compressed rows (default: 4 for each function of the bands)\n"
    "  --rank R           axes of each cluster, 1 to 32 (default 8 to 24, as the bands need)\n"
    "  --glossy MATERIAL  polish its planes, which then mirror the room, blurred\n"
    "  --gloss R,E        the polish: what share it mirrors seen from above, and the exponent of its lobe,\n"
    "                     1 to 1000 (default 0.06,16)\n"
    "  --check            compare with solutions for several lights, and one subspace with clusters\n"
    "  --sky FILE.hdr     with --check: for this light too; repeatable\n"
    "Options of render, export and view for a room:\n"
    "  --sky R,G,B|FILE.hdr   the light from outside. What the bands lose of a picture is printed\n"
    "  --turn DEGREES     turn it about the axis that points up, from -z (+y) towards +x\n"
    "  --tilt DEGREES     then tilt it about x, -90 to 90; what lay ahead goes up\n"
    "  --lamps LIST       all, none, or numbers or names with commas between, also NAME=STRENGTH (all)\n"
    "  --bands N          use only the first N bands\n"
    "  --rank N           show the clusters with N axes each, instead of the exact rows\n"
    "\n"
    "render traces a picture. Without --eye and --at the camera shows the whole model, from above and\n"
    "to one side, and its place is printed. The exposure adapts to what the camera sees.\n"
    "  --size WxH         pixels (default 1280x720)\n"
    "  --lens DEGREES     vertical field of view, 1 to 170 (default 60)\n"
    "  --exposure STOPS   brighter by this many powers of two, -20 to 20 (default 0)\n"
    "  --tone log|film    show the logarithm of the light, or use the film's curve (default film)\n"
    "  --up y|z           the axis that points up (default y)\n"
    "  --pictures DIR     of a room: instead, write the functions of its bands, and what each band adds\n"
    "\n"
    "view opens a window to fly through a solution, or through a model while it is solved. It takes\n"
    "the options of render and, for a model, those of solve. It prints its keys when it starts. A room\n"
    "of transfer is relit while you look at it: the right mouse button turns the sky.\n"
    "  --relight FILE.hdr the same as --sky, for a room\n"
    "  --spin S           turn a room's sky once in S seconds, print the pictures a second, then exit\n"
    "  --layer NAME       a layer to show at the start, repeatable: patches in a colour each, outlines of\n"
    "                     elements, wireframe, or what the hemicube under the pointer sees\n"
    "  --screenshot FILE.png   write the picture when all light is there, then exit\n"
    "\n"
    "export writes a solution for other programs. CSV has a line for every element; PLY and OBJ have\n"
    "colours at their points. --atlas makes a new folder with lightmaps (PNG, and linear HDR) and the\n"
    "model as OBJ and glTF with the coordinates of the lightmaps.\n"
    "  --map light|radiosity   light: irradiance over pi, to be multiplied by colours (default);\n"
    "                     radiosity: what is seen, emitted light included\n"
    "  --texels N         texels along a unit of length (default: as the elements are, which is exact)\n"
    "  --padding N        texels around every polygon's, 1 to 64 (default 2)\n"
    "  --page PX          longest side of a page, 256 to 16384 (default 8192)\n";

int run(Arguments &words) {
    const char *word = words.next();
    std::string what = word ? word : "";
    if (what == "generate") return runGenerate(words);
    if (what == "solve") return runSolve(words);
    if (what == "transfer") return runTransfer(words);
    if (what == "export") return runExport(words);
    if (what == "render") return runRender(words);
    if (what == "view") return runView(words);
    throw Refused("say what to do: generate, solve, transfer, export, render or view; see radiosity --help");
}

} // namespace

int main(int argc, char **argv) { return runProgram("radiosity", kUsage, argc, argv, run); }
