// The film's hall, solved as the film does, or as the page does.
#pragma once

#include "show/hall.h"
#include "tests/support/headless_gl.h"

namespace odraz {

struct FilmHall {
    HeapArena memory{kRoomBytes + sizeof(Hall)};
    Workers workers = serialWorkers();
    std::unique_ptr<Scene> scene = emptyScene();
    Hall *hall = memory.arena.allocate<Hall>(1);

    explicit FilmHall(const HemicubeMethod &method, const Gl *gl) {
        prepareHall(*hall, *scene);
        EXPECT_STREQ(solveRoom(*hall, *scene, hallSettings(*hall), {method, gl, memory.arena, workers, {}}),
                     nullptr);
    }
    static FilmHall &drawn() {
        static FilmHall hall(kDrawnHemicubes, &headlessGl());
        return hall;
    }
    static FilmHall &traced() {
        static FilmHall hall(kTracedHemicubes, nullptr);
        return hall;
    }
};

} // namespace odraz
