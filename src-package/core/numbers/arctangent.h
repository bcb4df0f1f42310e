// SPDX-License-Identifier: GPL-2.0-or-later
// Arctangent by series, for a double or a Lane, accurate to 2 units in the last place and bitwise
// identical on all processors and in all lanes, as in exp_log.h. The argument must be finite.
//
// With |x| = p/q, p <= q, the argument is reduced by atan(p/q) = atan(c) + atan(y),
// y = (p - c q)/(q + c p), where c is 0, 1/2 or 1, so |y| < 0.237. The Taylor series of atan(y) to
// y^25 has a remainder below 2e-18 of y. For |x| > 1 the result is pi/2 - atan(1/|x|).
#pragma once

#include "lane.h"

namespace raceway {

template <class T> RACEWAY_INLINE T arctangent(const T &x)
{
  const T size = magnitude(x), one = size * 0.0 + 1.0;
  const auto large = size > 1.0;
  const T p = where(large, one, size), q = where(large, size, one);
  const auto low = p < 0.2361 * q, high = p > 0.7208 * q;
  const T c = where(low, one * 0.0, where(high, one, one * 0.5));
  const T base =
      where(low, one * 0.0, where(high, one * 0.7853981633974483, one * 0.4636476090008061));
  const T y = (p - c * q) / (q + c * p), y2 = y * y, y4 = y2 * y2, y8 = y4 * y4;
  const T first = (1.0 / 3 - y2 * (1.0 / 5)) + y4 * (1.0 / 7 - y2 * (1.0 / 9));
  const T second = (1.0 / 11 - y2 * (1.0 / 13)) + y4 * (1.0 / 15 - y2 * (1.0 / 17));
  const T third = (1.0 / 19 - y2 * (1.0 / 21)) + y4 * (1.0 / 23 - y2 * (1.0 / 25));
  const T angle = base + (y - y * y2 * (first + y8 * (second + y8 * third)));
  const T whole = where(large, 1.5707963267948966 - angle, angle);
  return where(x < 0.0, -whole, whole);
}

}    // namespace raceway
