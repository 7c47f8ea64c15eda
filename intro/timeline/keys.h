// Keys as data: a file NAME.keys contains tables of keys, and code includes it.
//
//     // The lamp's light
//     TRACK(kLamp)
//         {rowOf(kLampLights), 0, Smooth}, // row, value, interpolation
//         {rowOf(kLampLights) + 8, 0.8, Linear},
//     END
//     PATH(kSink, 12)
//         {128, {4.97, 2.6, 0.514}, {0, 0.48, 0}, 0, 38.7}, // row, eye, target, roll, field of view
//     END
//
// A line is empty or contains a head, a key, END or only a comment; any line may end with a comment. A row is
// a number, or rowOf(an event) plus or minus a number. Rows count from the start of the scene that the file
// is named after; in TRACK(kLamp, rowOf(kLampLights)) they count from the event. PATH(kSink, 12) rounds the
// numbers of its keys to 12 significant bits (key_bits.h); 24 are all. odraz-debug reads and writes these
// files (maker/keys/key_file.h).
#pragma once

#include "timeline/key_bits.h"
#include "timeline/track.h"

#ifdef ODRAZ_LIVE
#include "timeline/key_table.h"
#endif

namespace odraz {

using enum Interpolation;

// clang-format off
#ifdef ODRAZ_LIVE

#define TRACK(name, ...) static KeyTable name = {#name, __FILE__, float{__VA_ARGS__}, {
#define PATH(name, bits) static KeyTable name = {#name, __FILE__, bits, {
#define END }};
#define KEYED // for data that refer to tables, which are not constant here

#else

#define TRACK(name, ...) static constexpr auto name = keys({
#define PATH(name, bits) static constexpr auto name = keys<bits>({
#define END });
#define KEYED constexpr
// clang-format on

template <class K, int N> struct Keys { K key[N]; };

template <int N> consteval Keys<Key, N> keys(const Key (&keys)[N]) {
    Keys<Key, N> to = {};
    for (int i = 0; i < N; ++i) to.key[i] = keys[i];
    return to;
}
template <int kBits, int N> consteval Keys<CameraKey, N> keys(const CameraKey (&keys)[N]) {
    Keys<CameraKey, N> to = {};
    for (int i = 0; i < N; ++i) to.key[i] = withBits(keys[i], kBits);
    return to;
}

template <int N> constexpr Track track(const Keys<Key, N> &keys) { return {keys.key, N}; }
template <int N> constexpr CameraPath path(const Keys<CameraKey, N> &keys) { return {keys.key, N}; }

#endif

} // namespace odraz
