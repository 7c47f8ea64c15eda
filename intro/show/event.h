// A row of the table in events.h, whose enums name the film's scenes and events.
#pragma once

#include <stdint.h>

namespace odraz {

enum SceneId : uint8_t;
enum EventId : uint8_t;

struct Event {
    EventId id;
    SceneId scene;
    int16_t row; // in the scene's story
    bool heard;  // whether music.h has a sound for it
};

// The silence before an event.
struct Silence {
    SceneId scene;
    uint8_t rows;   // how long it lasts
    int16_t before; // the event's row

    consteval Silence(const Event &event, uint8_t rows) : scene(event.scene), rows(rows), before(event.row) {}
};

} // namespace odraz
