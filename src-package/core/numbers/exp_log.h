// SPDX-License-Identifier: GPL-2.0-or-later
// Exponential and logarithm by series, for a double or a Lane, accurate to 2 units in the last
// place.
//
// The last bits of the C library's functions depend on the processor, and these functions process
// one number at a time. Only + - * / and shifts are used here, so the results are bitwise identical
// on all processors and in all lanes.
//
// Exponential: x = k ln 2 + r, |r| <= ln(2)/2; e^r is computed by the Taylor series to r^13
// (remainder below 5e-18). The result is 0 for x < -708, where it would lose precision, and
// infinite for x > 709.
//
// Logarithm: x = 2^k m, sqrt(1/2) <= m < sqrt(2); ln m = 2 artanh f, f = (m - 1)/(m + 1),
// |f| < 0.1716, by the series to f^21 (remainder below 2e-18). It is minus infinity for x below the
// smallest normal number and undefined for x < 0 or infinite x.
//
// The rough versions provide starting values for an iteration: the logarithm is accurate to 3e-4,
// and the exponential to 2 % for -1 <= x <= 0. Below -1 the exponential keeps its value at -1.
//
// All functions return NaN if the argument is NaN.
#pragma once

#include "lane.h"

#include <cstring>

namespace raceway {

namespace detail {
typedef unsigned long long Bits;
typedef Bits LaneBits __attribute__((vector_size(8 * lanes)));

RACEWAY_INLINE Bits bits(double x)
{
  Bits i;
  std::memcpy(&i, &x, sizeof i);
  return i;
}
RACEWAY_INLINE double number(Bits i)
{
  double x;
  std::memcpy(&x, &i, sizeof x);
  return x;
}
RACEWAY_INLINE LaneBits bits(const Lane &x) { return (LaneBits)x; }
RACEWAY_INLINE Lane number(const LaneBits &i) { return (Lane)i; }

constexpr double ln2_high = 0x1.62e42fefap-1,
                 ln2_low = 0x1.cf79abc9e3b398p-40;    // the high part times k < 2^14 is exact
constexpr double whole = 0x1.8p52;    // adding it moves the integer part into the last bits
}    // namespace detail

template <class T> RACEWAY_INLINE T exponential(const T &x)
{
  using namespace detail;
  const T shifted = x * 1.4426950408889634 + whole, k = shifted - whole;
  const T r = (x - k * ln2_high) - k * ln2_low, r2 = r * r, r4 = r2 * r2;
  // the terms are added in groups of four, which shortens the chain of dependent sums
  const T low = (1.0 / 6 + r * (1.0 / 24)) + r2 * (1.0 / 120 + r * (1.0 / 720));
  const T middle = (1.0 / 5040 + r * (1.0 / 40320)) + r2 * (1.0 / 362880 + r * (1.0 / 3628800));
  const T high = 1.0 / 39916800 + r * (1.0 / 479001600) + r2 * (1.0 / 6227020800);
  const T rest = low + r4 * (middle + r4 * high);
  const T y = 1.0 + (r + r2 * (0.5 + r * rest));
  const T scaled = number(bits(y) + (bits(shifted) << 52));
  return where(x < -708.0, 0.0, where(x > 709.0, HUGE_VAL, where(x == x, scaled, x)));
}

template <class T> RACEWAY_INLINE T logarithm(const T &x)
{
  using namespace detail;
  // exponent of x/sqrt(1/2), rounded down; as with `whole`, it is converted to a number by placing
  // it, with an offset, in the last bits of a large number
  const auto above = bits(x) - 0x3fe6a09e667f3bcdULL + (2048ULL << 52);
  const auto exponent = above >> 52;
  const T k = number(exponent | 0x4330000000000000ULL) - (0x1p52 + 2048.0);
  const T m = number(bits(x) - ((exponent - 2048ULL) << 52));
  const T f = (m - 1.0) / (m + 1.0), f2 = f * f, f4 = f2 * f2, f8 = f4 * f4;
  const T low = (2.0 / 3 + f2 * (2.0 / 5)) + f4 * (2.0 / 7 + f2 * (2.0 / 9));
  const T high = (2.0 / 11 + f2 * (2.0 / 13)) + f4 * (2.0 / 15 + f2 * (2.0 / 17));
  const T series = f2 * (low + f8 * (high + f8 * (2.0 / 19 + f2 * (2.0 / 21))));
  const T y = k * ln2_high + (2.0 * f + (f * series + k * ln2_low));
  return where(x < 0x1p-1022, -HUGE_VAL, where(x == x, y, x));
}

// Uses the bits of x in the same way as logarithm(). The polynomial in m - 1 is exact at m = 1.
template <class T> RACEWAY_INLINE T rough_logarithm(const T &x)
{
  using namespace detail;
  const auto above = bits(x) - 0x3fe6a09e667f3bcdULL + (2048ULL << 52);
  const auto exponent = above >> 52;
  const T k = number(exponent | 0x4330000000000000ULL) - (0x1p52 + 2048.0);
  const T f = number(bits(x) - ((exponent - 2048ULL) << 52)) - 1.0;
  const T bend = (-0.5032762 + f * 0.3478824) + f * f * -0.2082878;
  return k * 0.6931471805599453 + (f + f * f * bend);
}

template <class T> RACEWAY_INLINE T rough_exponential(const T &x)
{
  const T z = where(x > -1.0, x, -1.0), z2 = z * z;
  return (1.0 + z) + z2 * ((0.5 + z * (1.0 / 6)) + z2 * (1.0 / 24));
}

}    // namespace raceway
