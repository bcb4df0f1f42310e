// SPDX-License-Identifier: GPL-2.0-or-later
// All contact laws, the loaded contacts of a 6208 to which they are applied, and a number type with
// a small perturbation.
#pragma once

#include "../../src-package/core/contact/contact_lanes.h"
#include "../../src-package/core/contact/part_table.h"

#include <random>
#include <sstream>

namespace raceway {

// A number, and the value it assumes after a small change in the motions. held() returns the
// unperturbed number, because a quantity that a law treats as constant in its derivative must not
// change in the difference either.
struct Shifted {
  double value = 0.0, moved = 0.0;
  Shifted() = default;
  Shifted(double a) : value(a), moved(a) {}
  Shifted(double a, double b) : value(a), moved(b) {}
  Shifted &operator+=(const Shifted &b) { return *this = {value + b.value, moved + b.moved}; }
};
namespace detail {
template <> struct ValueOf<Shifted> {
  using type = double;
};
}    // namespace detail
inline double held(const Shifted &a) { return a.value; }
inline Shifted operator+(const Shifted &a, const Shifted &b)
{
  return {a.value + b.value, a.moved + b.moved};
}
inline Shifted operator-(const Shifted &a, const Shifted &b)
{
  return {a.value - b.value, a.moved - b.moved};
}
inline Shifted operator*(const Shifted &a, const Shifted &b)
{
  return {a.value * b.value, a.moved * b.moved};
}
inline Shifted operator/(const Shifted &a, const Shifted &b)
{
  return {a.value / b.value, a.moved / b.moved};
}
inline Shifted operator-(const Shifted &a) { return {-a.value, -a.moved}; }
// uses the branch of the unperturbed number, because a law is differentiated within its branches
inline bool operator<(const Shifted &a, double b) { return a.value < b; }
inline bool operator>(const Shifted &a, double b) { return a.value > b; }
inline bool operator>(const Shifted &a, const Shifted &b) { return a.value > b.value; }
inline Shifted square_root(const Shifted &a) { return {std::sqrt(a.value), std::sqrt(a.moved)}; }
inline Shifted exponential(const Shifted &a)
{
  return {exponential(a.value), exponential(a.moved)};
}
inline Shifted logarithm(const Shifted &a) { return {logarithm(a.value), logarithm(a.moved)}; }
inline Shifted magnitude(const Shifted &a) { return a.value < 0.0 ? -a : a; }
inline Shifted where(bool test, const Shifted &yes, const Shifted &no) { return test ? yes : no; }
}    // namespace raceway

// included here because it requires the number type above
#include "any_parts.h"

using namespace raceway;

namespace {

// Returns all sets of parts that keywords can form.
const std::vector<unsigned> &laws_of_parts()
{
  static const std::vector<unsigned> list = [] {
    const unsigned dry = initial_parts(false), elastic = Parts::in_slot("elastic"),
                   friction = Parts::in_slot("friction"), tangential = Parts::in_slot("tangential"),
                   always = dry & ~elastic;
    std::vector<unsigned> found;
    for (unsigned parts = 0; parts < 1u << Parts::size; ++parts)
      if ((parts & always) == always && parts & elastic &&
          !(parts & friction) == !(parts & tangential) && contradiction(parts).empty())
        found.push_back(parts);
    return found;
  }();
  return list;
}

struct Scene {
  RacewayPhysics p;
  BallState ball;
  RingState ring;
  double before[most_states] = {};
  double dt, follows;
  bool stage;
};

// Gives those parameters of a part that are 0 another value, so that every effect of the part is
// present and a wrong slope is detected.
template <class Part> void enliven(RacewayPhysics &p)
{
  auto &own = p.of<Part>();
  const auto *const begin = reinterpret_cast<const char *>(&own), *const end = begin + sizeof own;
  for (const auto &keyword : Part::keywords())
    for (const auto &parameter : keyword.parameters) {
      if (!parameter.number || parameter.open || parameter.least != 0.0) continue;
      double &value = parameter.number(p, own);
      const auto *const at = reinterpret_cast<const char *>(&value);
      // the parameter must belong to this part, and must be 0
      if (at < begin || at >= end || value != 0.0) continue;
      value = std::isfinite(parameter.most) ? 0.5 * parameter.most : 1.0;
    }
}

// Returns the n-th loaded contact of a 6208; its contact angle and sliding speed depend on n.
Scene scene(unsigned parts, int n)
{
  std::mt19937 random(n);
  auto between = [&](double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random);
  };
  Scene s;
  const bool inner = n % 2;
  s.p.groove = {inner ? Side::inner : Side::outer, inner ? 24e-3 : 36.6e-3, 6.552e-3, 6.3e-3};
  s.p.model.lubricant = {0.04, 22e-9};
  s.p.ring_roughness = 1e-7;
  s.p.parts = parts;
  s.p.factors = {InletShear::murch, 0.047, 0.134, 0.9};
  s.p.of<ConstantFrictionPart>().mu = 0.1;
  s.p.of<StribeckFrictionPart>().curve = {0.12, 0.05, 0.0, 0.0};
  if (n % 2) {
    s.p.of<MixedFrictionPart>().traction.stress = 5e6;
    s.p.of<MixedFrictionPart>().traction.limit = 0.047;
  }
  s.p.of<HydrodynamicRollingPart>().beta = 0.047;
  s.p.of<HydrodynamicRollingPart>().length = 3.0;
  s.p.of<MixedFrictionPart>().asperities.law = AsperityLaw::clarke;
  s.p.of<DragPart>().share = 0.1;
  s.p.of<SlipSlicesPart>().share = 0.7;
  Parts::each([&s](auto tag) { enliven<typename decltype(tag)::type>(s.p); });
  s.p.prepare(30.3e-3, 8.17e-3, 0.05);
  // lightly loaded contacts must not open
  const bool light = s.p.has<FilmInGapPart>() && n % 5 == 0;
  const double overlap = light ? between(-3e-8, 3e-8) : between(1e-6, 30e-6);
  const double distance = s.p.slack + overlap, fastest = light ? 5e-5 : 5e-3;
  const double angle = n % 3 ? between(-0.6, 0.6) : 0.0, azimuth = between(-3.0, 3.0);
  const double side = inner ? -1.0 : 1.0;
  const double r = s.p.centre_circle + side * distance * std::cos(angle);
  const Vec3 u = {std::cos(azimuth), std::sin(azimuth), 0.0}, t = {-u.y, u.x, 0.0};
  s.ring.e = {0.0, 0.0, 1.0};
  s.ball.x = u * r + s.ring.e * (distance * std::sin(angle));
  s.ball.v = u * between(-fastest, fastest) + t * between(0.3, 1.5) +
             s.ring.e * between(-fastest, fastest);
  s.ball.w = {between(-5.0, 5.0), between(-5.0, 5.0), between(-120.0, -60.0)};
  s.ring.w = {0.0, 0.0, between(0.0, 50.0)};
  double *kept = s.before;
  Parts::each([&](auto tag) {
    using Part = typename decltype(tag)::type;
    if (!s.p.has<Part>()) return;
    for (int k = 0; k < Part::states; ++k) {
      double most = 1e-7;                                                  // m, of a spring
      if (std::is_same<Part, FilmBranchPart>::value) most = 0.05;          // N
      if (std::is_same<Part, DifferentialSlipPart>::value) most = 20.0;    // N
      if (std::is_same<Part, SlipSlicesPart>::value) most = k < 2 ? 20.0 : 20e-3;    // N; m/s
      *kept++ = between(-most, most);
    }
  });
  s.dt = between(1e-6, 1e-4);
  s.follows = s.dt;
  s.stage = n % 4 > 1;
  return s;
}

}    // namespace
