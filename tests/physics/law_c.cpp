// SPDX-License-Identifier: GPL-2.0-or-later
// Every compiled contact law behind a C interface, for test_physics_laws.py: its slopes in duals
// and by differences, its values one by one and four side by side.
#include "../../src-package/core/exports.h"
#include "../../src-package/implicit/contact_lanes.h"
#include "../../src-package/implicit/instruction_set.h"
#include "../../src-package/physics/contact_slopes.h"
#include "../../src-package/physics/part_table.h"

#include <random>

namespace raceway {

// A number and the same number after a small change of the motions. held() keeps the first: what a
// law holds in its derivative does not change in the difference either.
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
// the branch that the number itself takes: a law is differentiated within its branches
inline bool operator<(const Shifted &a, double b) { return a.value < b; }
inline bool operator>(const Shifted &a, double b) { return a.value > b; }
inline Shifted square_root(const Shifted &a) { return {std::sqrt(a.value), std::sqrt(a.moved)}; }
inline Shifted exponential(const Shifted &a)
{
  return {exponential(a.value), exponential(a.moved)};
}
inline Shifted logarithm(const Shifted &a) { return {logarithm(a.value), logarithm(a.moved)}; }
inline Shifted magnitude(const Shifted &a) { return a.value < 0.0 ? -a : a; }
inline Shifted where(bool test, const Shifted &yes, const Shifted &no) { return test ? yes : no; }
}    // namespace raceway

using namespace raceway;

namespace {

struct Scene {
  RacewayPhysics p;
  BallState ball;
  RingState ring;
  double before[most_states > 0 ? most_states : 1];
  double dt, follows;
  bool stage;
};

// No effect of a part hides behind a number that is 0: a wrong slope of it would show nothing.
template <class Part> void enliven(RacewayPhysics &p)
{
  auto &own = p.of<Part>();
  const auto *const begin = reinterpret_cast<const char *>(&own), *const end = begin + sizeof own;
  for (const auto &keyword : Part::keywords())
    for (const auto &parameter : keyword.parameters) {
      if (!parameter.number || parameter.open || parameter.least != 0.0) continue;
      double &value = parameter.number(p, own);
      const auto *const at = reinterpret_cast<const char *>(&value);
      if (at < begin || at >= end || value != 0.0) continue;    // not the part's own, or live
      value = std::isfinite(parameter.most) ? 0.5 * parameter.most : 1.0;
    }
}

// A loaded contact of a 6208 under some angle, with some sliding, the n-th of its kind.
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
  s.p.of<DragPart>().share = 0.1;
  s.p.of<SlipSlicesPart>().share = 0.7;
  Parts::each([&s](auto tag) { enliven<typename decltype(tag)::type>(s.p); });
  s.p.prepare(30.3e-3, 8.17e-3, 0.05);
  // a contact that hardly has load must not part
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
  // m of a spring, N of differential slip, N of the film's branch, which comes first
  const bool slides = s.p.has<DifferentialSlipPart>() || s.p.has<SlipSlicesPart>();
  const double most = slides ? 20.0 : 1e-7;
  for (double &b : s.before) b = between(-most, most);
  if (s.p.has<SlipSlicesPart>())    // m/s, the last two
    for (int k = 2; k < most_states; ++k) s.before[k] *= 1e-3;
  if (s.p.has<FilmBranchPart>()) s.before[0] = between(-0.05, 0.05);
  s.dt = between(1e-6, 1e-4);
  s.follows = s.dt;
  s.stage = n % 4 > 1;
  return s;
}

template <class T> void take_motions(const ContactState &c, ContactStateT<T> &x)
{
  static_cast<GroovePosition &>(x) = c;
  x.cos_angle = c.cos_angle;
  x.entrainment = c.entrainment;
  x.h_edge = c.h_edge;
  x.ln_speed = c.ln_speed;
  x.film_factor = c.film_factor;
  x.overlap = c.overlap;
  x.overlap_rate = c.overlap_rate;
  x.sliding_t = c.sliding_t;
  x.sliding_w = c.sliding_w;
  x.spin_n = c.spin_n;
  x.turn_t = c.turn_t;
  x.roll_w = c.roll_w;
}

template <class T> const T *force_of(const ContactStateT<T> &c, int i)
{
  const T *forces[] = {&c.normal,   &c.friction_t, &c.friction_w,
                       &c.couple_n, &c.couple_t,   &c.couple_w};
  return forces[i];
}

// Local forces after the k-th motion has changed by `step` of its own size, held quantities as
// before.
template <class L>
void shifted_forces(const Scene &s, const ContactState &c, int k, double step, double *change,
                    double &size)
{
  ContactStateT<Shifted> x;
  take_motions(c, x);
  Shifted *motions[] = {&x.overlap_rate, &x.sliding_t, &x.sliding_w,
                        &x.spin_n,       &x.turn_t,    &x.roll_w};
  Shifted &motion = *motions[k];
  size = step * (k == 0 ? c.overlap / s.follows : k < 3 ? 0.1 : 10.0);
  motion.moved += size;
  if (k == 0) x.overlap.moved += s.follows * size;
  Shifted after[L::states > 0 ? L::states : 1];
  L::act(s.p, s.p.law.at(c.cos_angle), LawStates<Shifted>{s.dt, s.before, after, s.stage}, x);
  for (int i = 0; i < L::motions; ++i) {
    const Shifted &f = *force_of(x, i);
    change[i] = f.moved - f.value;
  }
}

template <class L> int slopes_of(const Scene &s, double *dual, double *difference, double *forces)
{
  constexpr int n = L::motions;
  ContactState c;
  touch(s.p, s.ball.x, s.ring.e, c);
  approach<L>(s.p, s.ball, s.ring, c);
  const ContactState start = c;
  double after[L::states > 0 ? L::states : 1];
  ContactSlopesT<double, n> slopes;
  act_with_slopes<L>(s.p, LawStates<double>{s.dt, s.before, after, s.stage}, s.follows, c, slopes);
  for (int i = 0; i < n; ++i) {
    forces[i] = *force_of(c, i);
    for (int k = 0; k < n; ++k) dual[n * i + k] = slopes.of[i][k];
  }
  const double step = 1e-5;
  for (int k = 0; k < n; ++k) {    // of fourth order
    double change[n], size;
    for (int i = 0; i < n; ++i) difference[n * i + k] = 0.0;
    for (int far : {-2, -1, 1, 2}) {
      shifted_forces<L>(s, start, k, far * step, change, size);
      const double weight = (far == 1 || far == -1 ? 8.0 : -1.0) / 12.0 * far / size;
      for (int i = 0; i < n; ++i) difference[n * i + k] += weight * (far > 0 ? 1 : -1) * change[i];
    }
  }
  return n;
}

template <class T> RACEWAY_INLINE Vec3T<T> spread(const Vec3 &v)
{
  return {T() + v.x, T() + v.y, T() + v.z};
}

// Number of values that differ in their bits: doubles, lanes, duals of doubles, duals of lanes.
template <class L> int bit_differences(const Scene &s)
{
  ContactState one;
  touch(s.p, s.ball.x, s.ring.e, one);
  double after[L::states > 0 ? L::states : 1];
  act<L>(s.p, s.ball, s.ring, LawStates<double>{s.dt, s.before, after, s.stage}, one);

  ContactState dual = one;
  double after_dual[L::states > 0 ? L::states : 1];
  ContactSlopesT<double, L::motions> slopes;
  act_with_slopes<L>(s.p, LawStates<double>{s.dt, s.before, after_dual, s.stage}, s.follows, dual,
                     slopes);

  int different = 0;
  for (bool with_slopes : {false, true}) {
    ContactStateT<Lane> four;
    const BallStateT<Lane> ball = {spread<Lane>(s.ball.x), spread<Lane>(s.ball.v),
                                   spread<Lane>(s.ball.w)};
    const RingStateT<Lane> ring = {spread<Lane>(s.ring.x), spread<Lane>(s.ring.v),
                                   spread<Lane>(s.ring.w), spread<Lane>(s.ring.e)};
    locate(ball.x, ring.e, s.p.centre_circle, four);
    four.overlap = four.s - s.p.slack;
    Lane before[L::states > 0 ? L::states : 1], later[L::states > 0 ? L::states : 1];
    for (int k = 0; k < L::states; ++k) before[k] = all_lanes(s.before[k]);
    const LawStates<Lane> states = {s.dt, before, later, s.stage};
    if (with_slopes) {
      ContactSlopesT<Lane, L::motions> lane_slopes;
      approach<L>(s.p, ball, ring, four);
      act_with_slopes<L>(s.p, states, s.follows, four, lane_slopes);
    } else {
      act<L>(s.p, ball, ring, states, four);
    }
    for (int i = 0; i < L::motions; ++i)
      for (int lane = 0; lane < lanes; ++lane)
        different += (*force_of(four, i))[lane] != *force_of(one, i);
    for (int k = 0; k < L::states; ++k) different += later[k][0] != after[k];
  }
  for (int i = 0; i < L::motions; ++i) different += *force_of(dual, i) != *force_of(one, i);
  for (int k = 0; k < L::states; ++k) different += after_dual[k] != after[k];
  return different;
}

// Of four contacts of one raceway, the last of which may be open, at once and one by one: number of
// values that differ in their bits.
template <class L> int lane_differences(unsigned parts, int n)
{
  const int each = 2, open = 3;    // every other scene is on the other raceway
  Scene s[lanes];
  ContactLanes four;
  ContactState states[lanes];
  ContactForces forces[lanes];
  double kept[lanes][most_states], x[lanes][3], v[lanes][3], w[lanes][3];
  for (int i = 0; i < lanes; ++i) {
    s[i] = scene(parts, n + each * i);
    if (L::decides && i == open) {    // within reach, and no film is as thick
      const double away = n % 2 ? 50e-6 : -50e-6;
      s[i].ball.x = s[i].ball.x + s[i].ball.x * (away / norm(s[i].ball.x));
    }
    s[i].ball.x.to(x[i]);
    s[i].ball.v.to(v[i]);
    s[i].ball.w.to(w[i]);
    std::copy(s[i].before, s[i].before + most_states, kept[i]);
    four.ball[i] = {x[i], v[i], w[i]};
    four.kept[i] = kept[i];
    four.state[i] = &states[i];
    four.force[i] = &forces[i];
  }
  const RacewayPhysics &p = s[0].p;
  const RingState &ring = s[0].ring;
  four.groove = ring;
  four.dt = s[0].dt;
  int different = 0;
  find_places(p, four);
  for (int i = 0; i < lanes; ++i) {
    ContactState c;
    different += !four.live[i] || !touch(p, s[i].ball.x, ring.e, c);
  }
  act_in_lanes(p, four);
  for (int i = 0; i < lanes; ++i) {
    ContactState c;
    const bool near = touch(p, s[i].ball.x, ring.e, c);
    const bool live = near && !approach<L>(p, s[i].ball, ring, c);
    different += !near || live != four.live[i] || live != !(L::decides && i == open);
    different += c.overlap != states[i].overlap;
    if (!live) continue;
    double after[most_states];
    L::act(p, p.law.at(c.cos_angle), LawStates<double>{four.dt, s[i].before, after}, c);
    const ContactForces f = assemble<L::couples>(p, ring.e, c);
    const Vec3 *one[] = {&f.force, &f.ball_torque, &f.ring_torque};
    const Vec3 *all[] = {&forces[i].force, &forces[i].ball_torque, &forces[i].ring_torque};
    for (int k = 0; k < 3; ++k)
      different += (one[k]->x != all[k]->x) + (one[k]->y != all[k]->y) + (one[k]->z != all[k]->z);
    for (int k = 0; k < L::states; ++k) different += after[k] != kept[i][k];
    different += c.load != states[i].load || c.mu != states[i].mu;
  }
  return different;
}

}    // namespace

EXPORT(int, laws, ()) { return static_cast<int>(compiled_laws().size()); }
EXPORT(const char *, law_name, (int law))
{
  static std::string text;
  text = law_text(compiled_laws()[law]);
  return text.c_str();
}
EXPORT(int, law_explicit, (int law))
{
  int is = 0;
  with_law(compiled_laws()[law], [&](auto l) { is = decltype(l)::explicit_step; });
  return is;
}

// n x n slopes by duals and by differences, n forces; returns n
EXPORT(int, law_slopes,
       (int law, int sample, double dual[36], double difference[36], double forces[6]))
{
  const unsigned parts = compiled_laws()[law];
  int n = 0;
  with_law(parts, [&](auto l) {
    using L = decltype(l);
    if constexpr (!L::explicit_step)
      n = slopes_of<L>(scene(parts, sample), dual, difference, forces);
  });
  return n;
}

EXPORT(int, law_bits, (int law, int sample))
{
  const unsigned parts = compiled_laws()[law];
  int different = -1;
  with_law(parts, [&](auto l) {
    using L = decltype(l);
    if constexpr (!L::explicit_step) different = bit_differences<L>(scene(parts, sample));
  });
  return different;
}

// -1: not one of the laws that explicit steps take in lanes
EXPORT(int, law_lanes, (int law, int sample))
{
  const unsigned parts = compiled_laws()[law];
  int different = -1;
  with_law(parts, [&](auto l) { different = lane_differences<decltype(l)>(parts, sample); });
  return different;
}

// Of the processor, and of the code for contacts.
EXPORT(int, has_avx2, ())
{
#ifdef __x86_64__
  return __builtin_cpu_supports("avx2") != 0;
#else
  return 1;    // there is one compilation, which counts as that
#endif
}
EXPORT(int, takes_avx2, ()) { return wide_lanes(); }
