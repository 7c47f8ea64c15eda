// Reports how far a long piece of work has come: 0 .. 1.
#pragma once

namespace odraz {

struct Progress {
    // May be null; called on the thread that began the work
    void (*report)(float done, void *context) = nullptr;
    void *context = nullptr;
    float from = 0, to = 1; // where this work begins and ends within the whole

    void operator()(float done) const {
        if (report) report(from + (to - from) * done, context);
    }
    Progress part(float a, float b) const {
        return {report, context, from + (to - from) * a, from + (to - from) * b};
    }
};

} // namespace odraz
