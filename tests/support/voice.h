// Renders single voices, for tests of notes.
#pragma once

#include "sound/note.h"

namespace odraz {

inline std::unique_ptr<Voice> begun(const Note &note, uint32_t seed = 7) {
    auto voice = std::make_unique<Voice>();
    beginVoice(*voice, note, seed);
    return voice;
}

// Renders a voice from its start. Each sample has eight lanes, four for the left and four for the right.
inline std::vector<Float8> rendered(Voice &voice, double seconds) {
    std::vector<Float8> out;
    for (int time = 0; time < (int)(seconds * kSampleRate); time += kBlock) {
        Float8 block[kBlock] = {};
        renderVoice(voice, time, 1, 1, block);
        out.insert(out.end(), block, block + kBlock);
    }
    return out;
}

} // namespace odraz
