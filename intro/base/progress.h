// Reports the progress of long work: 0 .. 1.
#pragma once

namespace odraz {

struct Progress {
    // May be null. It is called on the thread that began the work
    void (*report)(float done, void *context) = nullptr;
    void *context = nullptr;
    float from = 0, to = 1; // progress of the whole at the beginning and end of this work

    void operator()(float done) const {
        if (report) report(from + (to - from) * done, context);
    }
    Progress part(float a, float b) const {
        return {report, context, from + (to - from) * a, from + (to - from) * b};
    }
};

} // namespace odraz
