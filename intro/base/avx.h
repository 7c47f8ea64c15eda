// The instructions of x86-64-v3 that we use, and no others.
//
// GCC's <immintrin.h> also includes AVX-512 and AMX, which take 0.7 s of the second that a small file takes
// to compile. Its parts refuse to be included alone, so its guard is defined while we include them. It can
// still be included afterwards, because each part has its own guard.
#pragma once

#ifdef __wasm__
#include "base/wasm.h"
#elif defined(__GNUC__) && !defined(__clang__) && !defined(_IMMINTRIN_H_INCLUDED)
#define _IMMINTRIN_H_INCLUDED
// clang-format off
#include <smmintrin.h> // and all SSE before it
#include <avxintrin.h>
#include <avx2intrin.h>
#include <fmaintrin.h>
#include <x86gprintrin.h> // pdep, pext
// clang-format on
#undef _IMMINTRIN_H_INCLUDED
#else
#include <immintrin.h>
#endif
