// The film's hall, solved as the film does, or as the page does.
#pragma once

#include "show/hall.h"
#include "tests/support/headless_gl.h"

namespace odraz {

struct SolvedHall {
    HeapArena memory{kRoomBytes + sizeof(Hall)};
    Workers workers = serialWorkers();
    Hall *hall = memory.arena.allocate<Hall>(1);

    explicit SolvedHall(const HemicubeMethod &method, const Gl *gl) {
        auto scene = emptyScene();
        prepareHall(*hall, *scene);
        EXPECT_STREQ(solveRoom(*hall, *scene, hallSettings(*hall), {method, gl, memory.arena, workers, {}}),
                     nullptr);
    }
    static SolvedHall &drawn() {
        static SolvedHall hall(kDrawnHemicubes, &headlessGl());
        return hall;
    }
    static SolvedHall &traced() {
        static SolvedHall hall(kTracedHemicubes, nullptr);
        return hall;
    }
};

} // namespace odraz
