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
    auto report = [&](const char *what, const char *missing, const char *found = "fine") {
        Text<512> t;
        t << what << ": " << (missing ? missing : found) << '\n';
        lacking |= missing != nullptr;
        if (!unwritten) unwritten = writeOutput("-", t.data, (size_t)t.size);
    };
    auto reportGl = [&](const char *what, const char *missing) {
        report(what, missing, missing ? "" : (const char *)gl.glGetString(GL_RENDERER));
    };
    char name[49];
    cpuName(name);
    Text<80> processor;
    processor << cpuCount() << " x " << name;
    report("processor", nullptr, processor.data);
    report("memory", couldAddress(kMost) ? nullptr : "too little");
    report("write and run", jitForbidden());
    const char *missing = openWindow(window, false, 320, 180, &theEarly.viewerLeft);
    reportGl("OpenGL", missing);
    if (!missing) leaveContext(window);
    reportGl("OpenGL for --dump", openHeadlessGl(window.gl));
    report("sound", kSystemSound.open() ? nullptr : kNoSound);
    return lacking | unwritten;
}

} // namespace odraz
