// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers that carry their derivatives, so a law written for a number type also yields its
// derivative.
//
// Dual<B, n> is a value of type B (double or Lane) with n partial derivatives (forward mode;
// Griewank and Walther, Evaluating Derivatives, 2008, ch. 3). The value is computed by the same
// operations as for the plain type, so it is bitwise identical to the plain result. held(x) is the
// value alone, without derivatives; a law uses it for all quantities that its derivatives treat as
// constant. For a plain number, held(x) is x.
#pragma once

#include "arctangent.h"
#include "exp_log.h"

#include <cmath>
#include <type_traits>

namespace raceway {

template <class B, int n> struct alignas(sizeof(B)) Dual {
  B value = B();
  B d[n] = {};

  Dual() = default;
  RACEWAY_INLINE Dual(const B &a) : value(a) {}
  RACEWAY_INLINE Dual &operator+=(const Dual &b) { return *this = *this + b; }
};

namespace detail {
template <class T> struct ValueOf {
  using type = T;
};
template <class B, int n> struct ValueOf<Dual<B, n>> {
  using type = B;
};
template <class S>
using IfPlain =
    std::enable_if_t<std::is_same<S, double>::value || std::is_same<S, Lane>::value, int>;
}    // namespace detail

// The plain type of T, which is T itself or the type of a Dual's value.
template <class T> using Value = typename detail::ValueOf<T>::type;

RACEWAY_INLINE double held(double a) { return a; }
RACEWAY_INLINE Lane held(const Lane &a) { return a; }
template <class B, int n> RACEWAY_INLINE B held(const Dual<B, n> &a) { return a.value; }

// ---- operations on two duals
template <class B, int n>
RACEWAY_INLINE Dual<B, n> operator+(const Dual<B, n> &a, const Dual<B, n> &b)
{
  Dual<B, n> r(a.value + b.value);
  for (int i = 0; i < n; ++i) r.d[i] = a.d[i] + b.d[i];
  return r;
}
template <class B, int n>
RACEWAY_INLINE Dual<B, n> operator-(const Dual<B, n> &a, const Dual<B, n> &b)
{
  Dual<B, n> r(a.value - b.value);
  for (int i = 0; i < n; ++i) r.d[i] = a.d[i] - b.d[i];
  return r;
}
template <class B, int n>
RACEWAY_INLINE Dual<B, n> operator*(const Dual<B, n> &a, const Dual<B, n> &b)
{
  Dual<B, n> r(a.value * b.value);
  for (int i = 0; i < n; ++i) r.d[i] = a.d[i] * b.value + a.value * b.d[i];
  return r;
}
template <class B, int n>
RACEWAY_INLINE Dual<B, n> operator/(const Dual<B, n> &a, const Dual<B, n> &b)
{
  Dual<B, n> r(a.value / b.value);
  const B inverse = 1.0 / b.value;
  for (int i = 0; i < n; ++i) r.d[i] = (a.d[i] - r.value * b.d[i]) * inverse;
  return r;
}
template <class B, int n> RACEWAY_INLINE Dual<B, n> operator-(const Dual<B, n> &a)
{
  Dual<B, n> r(-a.value);
  for (int i = 0; i < n; ++i) r.d[i] = -a.d[i];
  return r;
}

// ---- operations on a dual and a plain number, which is a constant
template <class B, int n, class S, detail::IfPlain<S> = 0>
RACEWAY_INLINE Dual<B, n> operator+(const Dual<B, n> &a, const S &b)
{
  Dual<B, n> r = a;
  r.value = a.value + b;
  return r;
}
template <class B, int n, class S, detail::IfPlain<S> = 0>
RACEWAY_INLINE Dual<B, n> operator+(const S &a, const Dual<B, n> &b)
{
  Dual<B, n> r = b;
  r.value = a + b.value;
  return r;
}
template <class B, int n, class S, detail::IfPlain<S> = 0>
RACEWAY_INLINE Dual<B, n> operator-(const Dual<B, n> &a, const S &b)
{
  Dual<B, n> r = a;
  r.value = a.value - b;
  return r;
}
template <class B, int n, class S, detail::IfPlain<S> = 0>
RACEWAY_INLINE Dual<B, n> operator-(const S &a, const Dual<B, n> &b)
{
  Dual<B, n> r = -b;
  r.value = a - b.value;
  return r;
}
template <class B, int n, class S, detail::IfPlain<S> = 0>
RACEWAY_INLINE Dual<B, n> operator*(const Dual<B, n> &a, const S &b)
{
  Dual<B, n> r(a.value * b);
  for (int i = 0; i < n; ++i) r.d[i] = a.d[i] * b;
  return r;
}
template <class B, int n, class S, detail::IfPlain<S> = 0>
RACEWAY_INLINE Dual<B, n> operator*(const S &a, const Dual<B, n> &b)
{
  Dual<B, n> r(a * b.value);
  for (int i = 0; i < n; ++i) r.d[i] = a * b.d[i];
  return r;
}
template <class B, int n, class S, detail::IfPlain<S> = 0>
RACEWAY_INLINE Dual<B, n> operator/(const Dual<B, n> &a, const S &b)
{
  Dual<B, n> r(a.value / b);
  const B inverse = 1.0 / (B() + b);
  for (int i = 0; i < n; ++i) r.d[i] = a.d[i] * inverse;
  return r;
}
template <class B, int n, class S, detail::IfPlain<S> = 0>
RACEWAY_INLINE Dual<B, n> operator/(const S &a, const Dual<B, n> &b)
{
  Dual<B, n> r(a / b.value);
  const B slope = -r.value / b.value;
  for (int i = 0; i < n; ++i) r.d[i] = slope * b.d[i];
  return r;
}

// ---- comparisons of the values
template <class B, int n, class S> RACEWAY_INLINE auto operator<(const Dual<B, n> &a, const S &b)
{
  return a.value < held(b);
}
template <class B, int n, class S> RACEWAY_INLINE auto operator>(const Dual<B, n> &a, const S &b)
{
  return a.value > held(b);
}
template <class B, int n, class S> RACEWAY_INLINE auto operator<=(const Dual<B, n> &a, const S &b)
{
  return a.value <= held(b);
}
template <class B, int n, class S> RACEWAY_INLINE auto operator>=(const Dual<B, n> &a, const S &b)
{
  return a.value >= held(b);
}

// ---- functions
template <class B, int n> RACEWAY_INLINE Dual<B, n> square_root(const Dual<B, n> &a)
{
  Dual<B, n> r(square_root(a.value));
  const B slope = 0.5 / r.value;
  for (int i = 0; i < n; ++i) r.d[i] = slope * a.d[i];
  return r;
}
template <class B, int n> RACEWAY_INLINE Dual<B, n> exponential(const Dual<B, n> &a)
{
  Dual<B, n> r(exponential(a.value));
  for (int i = 0; i < n; ++i) r.d[i] = r.value * a.d[i];
  return r;
}
template <class B, int n> RACEWAY_INLINE Dual<B, n> logarithm(const Dual<B, n> &a)
{
  Dual<B, n> r(logarithm(a.value));
  const B slope = 1.0 / a.value;
  for (int i = 0; i < n; ++i) r.d[i] = slope * a.d[i];
  return r;
}
template <class B, int n> RACEWAY_INLINE Dual<B, n> arctangent(const Dual<B, n> &a)
{
  Dual<B, n> r(arctangent(a.value));
  const B slope = 1.0 / (1.0 + a.value * a.value);
  for (int i = 0; i < n; ++i) r.d[i] = slope * a.d[i];
  return r;
}
template <class B, int n> RACEWAY_INLINE Dual<B, n> magnitude(const Dual<B, n> &a)
{
  Dual<B, n> r(magnitude(a.value));
  for (int i = 0; i < n; ++i) r.d[i] = where(a.value < 0.0, B(-a.d[i]), a.d[i]);
  return r;
}
template <class Test, class B, int n>
RACEWAY_INLINE Dual<B, n> where(const Test &test, const Dual<B, n> &yes, const Dual<B, n> &no)
{
  Dual<B, n> r(where(test, yes.value, no.value));
  for (int i = 0; i < n; ++i) r.d[i] = where(test, yes.d[i], no.d[i]);
  return r;
}
template <class Test, class B, int n, class S, detail::IfPlain<S> = 0>
RACEWAY_INLINE Dual<B, n> where(const Test &test, const Dual<B, n> &yes, const S &no)
{
  return where(test, yes, Dual<B, n>(B() + no));
}
template <class Test, class B, int n, class S, detail::IfPlain<S> = 0>
RACEWAY_INLINE Dual<B, n> where(const Test &test, const S &yes, const Dual<B, n> &no)
{
  return where(test, Dual<B, n>(B() + yes), no);
}

}    // namespace raceway
