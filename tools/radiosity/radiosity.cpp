// The program radiosity: computes the light in any model, and shows it.
#include "tools/common/command_line.h"

namespace odraz::radiosity {

// The commands, in the rooms' *_command.cpp. Each reads its command line and returns the exit status.
int runGenerate(common::CommandLine &line);
int runSolve(common::CommandLine &line);
int runTransfer(common::CommandLine &line);
int runExport(common::CommandLine &line);
int runRender(common::CommandLine &line);
int runStudy(common::CommandLine &line);
int runView(common::CommandLine &line);

} // namespace odraz::radiosity

using namespace odraz::radiosity;

static int run(common::CommandLine &line) {
    line.about(
        "Computes the light in a model whose surfaces reflect evenly in all directions, and shows it.");
    return line.run(
        {{"generate", "write an example model", runGenerate},
         {"solve", "compute the light in a model", runSolve},
         {"transfer", "solve a model for any light from outside, and for each of its lamps", runTransfer},
         {"export", "write a solution for other programs", runExport},
         {"render", "trace a picture of a solution", runRender},
         {"study", "measure the methods on a model", runStudy},
         {"view", "open a window to fly through a solution, or through a model while it is solved",
          runView}});
}

int main(int argc, char **argv) { return common::runProgram("radiosity", argc, argv, run); }
