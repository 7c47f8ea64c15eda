#include "tools/measure/reference/reference_hall.h"

#include "tools/common/clock.h"

namespace odraz::measure {

SolvedHall::SolvedHall(const RadiositySettings &settings, const HemicubeMethod &method, const Gl &gl,
                       Workers &workers, size_t bytes, const std::function<void(Hall &)> &change,
                       const Progress &progress)
    : memory(bytes), scene(std::make_unique<Scene>()), hall(std::make_unique<Hall>()) {
    double began = common::processorSeconds();
    prepareHall(*hall, *scene);
    if (change) change(*hall);
    if (!hall->radiosity.bases.withinLimits()) throw std::runtime_error("too many light bases for the hall");
    if (!solveRadiosity(hall->radiosity, hall->model, *scene, settings,
                        {method, &gl, memory.arena, workers, progress}))
        throw std::runtime_error("cannot solve the hall with these settings");
    method.close(hall->radiosity.hemicubes);
    seconds = common::processorSeconds() - began;
}

void SolvedHall::solveGloss(Arena &arena, Workers &workers) {
    if (!findGlossy(hall->gloss, hall->model, hall->radiosity, hall->floor, kGlossExponent, arena, workers))
        throw std::runtime_error("not enough memory for the floor's gloss");
}

} // namespace odraz::measure
