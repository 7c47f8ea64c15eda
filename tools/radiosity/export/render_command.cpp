#include "tools/radiosity/export/render_command.h"

#include "tools/common/machine.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/export/camera_options.h"
#include "tools/radiosity/export/render.h"

#include <cstdio>

namespace odraz {

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
    Solution solution(in);
    RenderSettings &s = camera.settings;
    if (!camera.placed()) {
        placeCamera(solution, s);
        std::printf("%s\n", placeOptions(s).c_str());
    }
    render(solution, s, workers, out);
    return 0;
}

} // namespace odraz
