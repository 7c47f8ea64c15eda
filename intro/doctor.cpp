#include "doctor.h"

#include "base/text.h"
#include "host/cpu.h"
#include "host/headless.h"
#include "host/process.h"
#include "host/sound.h"
#include "host/threads.h"
#include "output/output.h"
#include "start/early.h"

namespace odraz {

constexpr size_t kMost = 512 << 20; // bytes that the film may take

int examine() {
    FilmWindow &window = theEarly.window;
    const Gl &gl = window.gl;
    int lacking = 0, unwritten = 0;
    auto tell = [&](const char *what, const char *missing, const char *found = "fine") {
        Text<512> t;
        t << what << ": " << (missing ? missing : found) << '\n';
        lacking |= missing != nullptr;
        if (!unwritten) unwritten = writeOutput("-", t.data, (size_t)t.size);
    };
    auto tellGl = [&](const char *what, const char *missing) {
        tell(what, missing, missing ? "" : (const char *)gl.glGetString(GL_RENDERER));
    };
    char name[49];
    cpuName(name);
    Text<80> processor;
    processor << cpuCount() << " x " << name;
    tell("processor", nullptr, processor.data);
    tell("memory", couldAddress(kMost) ? nullptr : "too little");
    tell("write and run", jitForbidden());
    const char *missing = openWindow(window, false, 320, 180, &theEarly.viewerLeft);
    tellGl("OpenGL", missing);
    if (!missing) leaveContext(window);
    tellGl("OpenGL for --dump", openHeadlessGl(window.gl));
    tell("sound", kSystemSound.open() ? nullptr : kNoSound);
    return lacking | unwritten;
}

} // namespace odraz
