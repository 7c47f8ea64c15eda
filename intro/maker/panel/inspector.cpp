#include "maker/panel/inspector.h"

#include "inside.h"
#include "show/events.h"

#include <utility>

namespace odraz::maker {

namespace {

int shots(ShotInfo *to, int most) {
    int count = min(kFilm.count, most);
    for (int i = 0; i < count; ++i) {
        const Shot &s = kFilm.shots[i];
        float end = i + 1 < kFilm.count ? kFilm.shots[i + 1].row : kFilm.endRow;
        to[i] = {s.row / kRowsPerSecond, end / kRowsPerSecond, s.storyRow / kRowsPerSecond, s.scene, &s.path};
    }
    return count;
}

// The text ends with the enumerator's name: "... Id = odraz::kLightIsBorn]"
template <EventId Id> const char *enumerator() { return __PRETTY_FUNCTION__; }

template <int... Ids> void nameOf(int id, EventInfo &to, std::integer_sequence<int, Ids...>) {
    const char *const all[] = {enumerator<(EventId)Ids>()...}, *from = all[id], *begin = from;
    for (const char *c = from; *c; ++c)
        if (*c == ':' || *c == ' ') begin = c + 1;
    for (int i = 0; i + 1 < (int)sizeof to.name && begin[i] && begin[i] != ']' && begin[i] != ';'; ++i)
        to.name[i] = begin[i];
}

int events(EventInfo *to, int most) {
    int count = 0;
    for (const Event &e : kEvents) {
        const Shot *shot = nullptr;
        for (int i = kFilm.count - 1; i >= 0; --i)
            if (kFilm.shots[i].scene == e.scene) shot = &kFilm.shots[i];
        if (!shot || count == most) continue;
        EventInfo &event =
            to[count++] = {(shot->storyRow + e.row) / kRowsPerSecond, (float)e.row, e.heard, {}};
        nameOf(e.id, event, std::make_integer_sequence<int, kEventCount>());
    }
    return count;
}

} // namespace

const Inspector &inspector() {
    static constexpr Inspector kInspector = {shots, events, watchPictures, drawText};
    return kInspector;
}

} // namespace odraz::maker
