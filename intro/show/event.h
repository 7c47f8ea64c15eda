// A row of events.h, whose enums name the scenes and the events of the film.
#pragma once

#include <stdint.h>

namespace odraz {

enum SceneId : uint8_t;
enum EventId : uint8_t;

struct Event {
    EventId id;
    SceneId scene;
    int16_t row; // of the scene's story
    bool heard;  // whether music.h has a sound for it
};

} // namespace odraz
