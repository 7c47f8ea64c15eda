// A bar on the terminal that grows; nothing where stderr is a file.
#pragma once

namespace odraz {

class Bar {
public:
    Bar();
    ~Bar() { clear(); }
    // Which step (a name that stays where it is), how much of it is done, 0 .. 1; the residual where it is
    // not below 0.
    void show(const char *step, float done, float residual);
    void clear();

private:
    bool terminal;
    const char *step = nullptr;
    double began = 0;
};

} // namespace odraz
