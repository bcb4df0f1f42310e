// SPDX-License-Identifier: GPL-2.0-or-later
// A Lane contains four numbers, one for each of four balls. Formulas accept a Lane instead of a
// double.
//
// A Lane is a vector type provided by the compiler, with + - * / and comparisons. The other
// functions are defined here for both double and Lane. Nothing is reordered, fused or approximated:
// on every instruction set, lane k of a result is bitwise identical to the same operation on
// doubles.
#pragma once

#include <cmath>

// g++ compiles lanes for processors with and without AVX2, except with sanitizers, with
// RACEWAY_ONE_TARGET, and for other processor families. clang does not accept functions for two
// targets.
#if defined(__clang__) && !defined(RACEWAY_ONE_TARGET)
#define RACEWAY_ONE_TARGET 1
#endif
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(RACEWAY_ONE_TARGET)
#define RACEWAY_TWO_TARGETS 1
#endif

// A function with a Lane argument must be compiled for the instruction set of its caller, so it is
// always inlined. A function that calls such functions is compiled for several instruction sets;
// the best one is chosen at run time. None of them uses fused multiply-add, so all give bitwise
// identical results.
//
// Functions that contain contact laws are large, and the version for processors without AVX2 takes
// three quarters of the compile time. They are therefore compiled for AVX2 only (RACEWAY_WIDE), and
// once more in a file for a single target; instruction_set.h selects the version to call.
//
// If there is only a single target, all of them are plain functions, which compile several times
// faster. A single target is used with sanitizers, which do not support the selection at run time,
// and when speed does not matter (RACEWAY_ONE_TARGET).
#if defined(__SANITIZE_ADDRESS__) || defined(RACEWAY_ONE_TARGET)
#define RACEWAY_INLINE inline
#else
#define RACEWAY_INLINE __attribute__((always_inline)) inline
#endif
#if defined(RACEWAY_TWO_TARGETS) && !defined(RACEWAY_ONE_TARGET)
#define RACEWAY_LANES __attribute__((target_clones("avx2", "default")))
#define RACEWAY_WIDE __attribute__((target("avx2")))
#else
#define RACEWAY_LANES
#define RACEWAY_WIDE
#endif

namespace raceway {

constexpr int lanes = 4;
// Code for AVX2 assumes that a Lane is aligned to 32 bytes, but its type requires only 16 if the
// target lacks AVX2. Structs of lanes passed between functions therefore have alignas(sizeof(T)).
typedef double Lane __attribute__((vector_size(8 * lanes)));
using LaneMask = decltype(Lane() < Lane());    // result of a comparison: 0 or all bits

RACEWAY_INLINE Lane all_lanes(double a) { return Lane{a, a, a, a}; }

RACEWAY_INLINE double square_root(double a) { return std::sqrt(a); }
RACEWAY_INLINE double magnitude(double a) { return std::fabs(a); }

RACEWAY_INLINE Lane square_root(const Lane &a)
{
  return Lane{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
}
RACEWAY_INLINE Lane magnitude(const Lane &a) { return a < 0.0 ? -a : a; }

RACEWAY_INLINE double where(bool test, double yes, double no) { return test ? yes : no; }
RACEWAY_INLINE Lane where(const LaneMask &test, const Lane &yes, const Lane &no)
{
  return test ? yes : no;
}
RACEWAY_INLINE Lane where(const LaneMask &test, const Lane &yes, double no)
{
  return test ? yes : all_lanes(no);
}
RACEWAY_INLINE Lane where(const LaneMask &test, double yes, const Lane &no)
{
  return test ? all_lanes(yes) : no;
}

RACEWAY_INLINE Lane where(const LaneMask &test, double yes, double no)
{
  return test ? all_lanes(yes) : all_lanes(no);
}

RACEWAY_INLINE bool any(bool m) { return m; }
RACEWAY_INLINE bool any(const LaneMask &m) { return (m[0] | m[1] | m[2] | m[3]) != 0; }
RACEWAY_INLINE double sum(const Lane &a) { return ((a[0] + a[1]) + a[2]) + a[3]; }

}    // namespace raceway
