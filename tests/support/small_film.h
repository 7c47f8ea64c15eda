// The film at 160x90, with its hall if it has one. All tests of a program share it.
#pragma once

#include "tests/support/headless_gl.h"
#include "tests/support/loaded_film.h"

namespace odraz {

inline Intro &smallFilm() {
    static LoadedFilm loaded(1, 160, 90, false, needsHall(0, duration()) ? &headlessGl() : nullptr);
    return *loaded.intro;
}

} // namespace odraz
