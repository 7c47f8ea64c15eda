// The film's shots and events, in the order of time.
#pragma once

#include "maker/panel/inspector.h"

#include <string>
#include <vector>

namespace odraz::maker {

struct Content {
    double end = 0;
    std::vector<ShotInfo> shots;
    std::vector<EventInfo> events;

    const ShotInfo &shotAt(double time) const; // needs at least one shot
};
Content contentOf(const Inspector &inspector);

std::string inWords(const EventInfo &event); // "light is born" for kLightIsBorn

} // namespace odraz::maker
