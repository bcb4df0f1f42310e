// SPDX-License-Identifier: GPL-2.0-or-later
// Four numbers side by side, one per ball: the formulas of this folder take them in place of a
// double.
//
// A Lane is the compiler's own vector type, so + - * / and comparisons work as they stand; what is
// missing is here, for double and Lane alike. Nothing is reordered, fused or approximated: lane k
// of a result has the bits that a double would have, on every instruction set the compiler may
// choose.
#ifndef RACEWAY_LANE_H
#define RACEWAY_LANE_H

#include <cmath>

// Lanes are compiled for processors with AVX2 and for those without, but not by sanitizers, not
// with RACEWAY_ONE_TARGET, and not for other families of processors.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(RACEWAY_ONE_TARGET)
#define RACEWAY_TWO_TARGETS 1
#endif

// A function that takes a Lane must be compiled for the instruction set of its caller, so it is
// never called. A function that calls such functions is compiled for several instruction sets; the
// best one is chosen at run time. Without fused multiply-add, so all give the same bits.
//
// Functions with the laws of contacts in them are large, and what is for processors without AVX2
// takes a compiler three quarters of the time. So these are compiled for AVX2 alone (RACEWAY_WIDE),
// and once more in a file for one target; instruction_set.h tells which to call.
//
// For one target all are plain functions, which compile several times faster: sanitizers, which do
// not know the mechanism, and builds that are not for speed (RACEWAY_ONE_TARGET).
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
// Code for AVX2 takes a Lane to be aligned to 32 bytes, but its type asks for 16 where the target
// has no AVX2. So structs of lanes that are passed between functions have alignas(sizeof(T)).
typedef double Lane __attribute__((vector_size(8 * lanes)));
using LaneMask = decltype(Lane() < Lane());    // of a comparison: 0 or all bits

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

#endif
