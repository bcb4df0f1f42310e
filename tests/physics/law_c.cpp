// SPDX-License-Identifier: GPL-2.0-or-later
// Every possible contact law behind a C interface, for test_physics_laws.py: its slopes in duals
// and by differences, its values one by one and four side by side, part by part and as a whole.
#include "../../src-package/core/contact/contact_lanes.h"
#include "../../src-package/core/contact/part_table.h"
#include "../../src-package/core/interface/exports.h"
#include "../../src-package/core/numbers/instruction_set.h"

#include <random>
#include <sstream>

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

// the number type above is known to it
#include "any_parts.h"

using namespace raceway;

namespace {

// All sets of parts that keywords can make.
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

template <class T> const T *force_of(const ContactStateT<T> &c, int i)
{
  const T *forces[] = {&c.normal,   &c.friction_t, &c.friction_w,
                       &c.couple_n, &c.couple_t,   &c.couple_w};
  return forces[i];
}

// Local forces after the k-th motion has changed by `step` of its own size, held quantities as
// before.
template <class L>
void shifted_forces(const L &law, const Scene &s, const ContactState &c, int k, double step,
                    double *change, double &size)
{
  ContactStateT<Shifted> x;
  copy_state(c, x);
  Shifted *motions[] = {&x.overlap_rate, &x.sliding_t, &x.sliding_w,
                        &x.spin_n,       &x.turn_t,    &x.roll_w};
  Shifted &motion = *motions[k];
  size = step * (k == 0 ? c.overlap / s.follows : k < 3 ? 0.1 : 10.0);
  motion.moved += size;
  if (k == 0) x.overlap.moved += s.follows * size;
  Shifted after[L::room];
  law.act(s.p, s.p.law.at(c.cos_angle), LawStates<Shifted>{s.dt, s.before, after, s.stage}, x);
  for (int i = 0; i < L::motions; ++i) {
    const Shifted &f = *force_of(x, i);
    change[i] = f.moved - f.value;
  }
}

template <class L>
int slopes_of(const L &law, const Scene &s, double *dual, double *difference, double *forces)
{
  constexpr int n = L::motions;
  ContactState c;
  touch(s.p, s.ball.x, s.ring.e, c);
  approach(law, s.p, s.ball, s.ring, c);
  const ContactState start = c;
  double after[L::room];
  ContactSlopesT<double, n> slopes;
  act_with_slopes(law, s.p, LawStates<double>{s.dt, s.before, after, s.stage}, s.follows, c,
                  slopes);
  for (int i = 0; i < n; ++i) {
    forces[i] = *force_of(c, i);
    for (int k = 0; k < n; ++k) dual[n * i + k] = slopes.of[i][k];
  }
  const double step = 1e-5;
  for (int k = 0; k < n; ++k) {    // of fourth order
    double change[n], size;
    for (int i = 0; i < n; ++i) difference[n * i + k] = 0.0;
    for (int far : {-2, -1, 1, 2}) {
      shifted_forces(law, s, start, k, far * step, change, size);
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

// Number of doubles that differ in their bits, of the same struct of numbers.
template <class A> int different_numbers(const A &a, const A &b)
{
  const double *const x = reinterpret_cast<const double *>(&a),
                      *const y = reinterpret_cast<const double *>(&b);
  int different = 0;
  for (size_t k = 0; k < sizeof(A) / sizeof(double); ++k)
    different += x[k] != y[k] && !(std::isnan(x[k]) && std::isnan(y[k]));
  return different;
}

// What an evaluation finds: the contact, what it keeps, and its slopes.
template <int n> struct Found {
  ContactState c;
  double after[most_states] = {};
  ContactSlopesT<double, n> slopes = {};
};

template <class L> Found<L::motions> found_by(const L &law, const Scene &s, bool with_slopes)
{
  Found<L::motions> f;
  touch(s.p, s.ball.x, s.ring.e, f.c);
  approach(law, s.p, s.ball, s.ring, f.c);
  const LawStates<double> memory = {s.dt, s.before, f.after, s.stage};
  if (with_slopes) act_with_slopes(law, s.p, memory, s.follows, f.c, f.slopes);
  else law.act(s.p, s.p.law.at(f.c.cos_angle), memory, f.c);
  return f;
}

// The same with four contacts side by side, of which all are this one; one lane of them.
template <class L> Found<L::motions> found_in_lanes(const L &law, const Scene &s, bool with_slopes)
{
  ContactStateT<Lane> four;
  const BallStateT<Lane> ball = {spread<Lane>(s.ball.x), spread<Lane>(s.ball.v),
                                 spread<Lane>(s.ball.w)};
  const RingStateT<Lane> ring = {spread<Lane>(s.ring.x), spread<Lane>(s.ring.v),
                                 spread<Lane>(s.ring.w), spread<Lane>(s.ring.e)};
  locate(ball.x, ring.e, s.p.centre_circle, four);
  out_of_reach(s.p, four);
  find_motions<L::couples>(s.p, ball, ring, four);
  const RacewayConstantsT<Lane> k = s.p.law.at(four.cos_angle);
  if (law.decides) law.misses(s.p, k, four);
  Lane before[most_states], after[most_states] = {};
  for (int m = 0; m < most_states; ++m) before[m] = all_lanes(s.before[m]);
  const LawStates<Lane> memory = {s.dt, before, after, s.stage};
  ContactSlopesT<Lane, L::motions> slopes = {};
  if (with_slopes) act_with_slopes(law, s.p, memory, s.follows, four, slopes);
  else law.act(s.p, k, memory, four);

  const auto lane = [](const auto &from, auto &to) {
    const Lane *const a = reinterpret_cast<const Lane *>(&from);
    double *const b = reinterpret_cast<double *>(&to);
    for (size_t m = 0; m < sizeof to / sizeof *b; ++m) b[m] = a[m][lanes - 1];
  };
  Found<L::motions> f;
  lane(four, f.c);
  lane(after, f.after);
  lane(slopes, f.slopes);
  return f;
}

// Number of values that differ: doubles, lanes, duals of doubles, duals of lanes.
template <class L> int bit_differences(const L &law, const Scene &s)
{
  const auto one = found_by(law, s, false), dual = found_by(law, s, true);
  int different = different_numbers(one.c, dual.c) + different_numbers(one.after, dual.after);
#ifdef __x86_64__
#ifdef RACEWAY_ONE_TARGET
  const LawFunctions &functions = wide_law;
#else
  const LawFunctions &functions = wide_lanes() ? wide_law : narrow_law;
#endif
#else
  const LawFunctions &functions = wide_law;
#endif
  with_any_law(s.p.parts, functions, [&](const auto &any) {
    if constexpr (std::decay_t<decltype(any)>::motions == L::motions)
      different += different_numbers(one, found_in_lanes(any, s, false)) +
                   different_numbers(dual, found_in_lanes(any, s, true));
    else ++different;
  });
  return different;
}

// Number of values in which a law that is compiled as a whole differs from its parts one by one.
template <class L> int fused_differences(const Scene &s)
{
  const PartsLaw<L::motions> law = {L::parts};
  int different = L::states != law.states || L::decides != law.decides ||
                  L::couples != law_facts(L::parts).couples;
  for (const bool with_slopes : {false, true}) {
    if (with_slopes && L::explicit_step) break;
    const auto parts = found_by(law, s, with_slopes);
    different += different_numbers(parts, found_by(L(), s, with_slopes));
    different += different_numbers(parts, found_in_lanes(L(), s, with_slopes));
    different += L::loss(parts.c) != law.loss(parts.c);
  }
  return different;
}

// Of four contacts of one raceway, the last of which may be open, at once and one by one: number of
// values that differ in their bits.
int lane_differences(unsigned parts, int n)
{
  const bool decides = law_facts(parts).decides;
  const int each = 2, open = 3;    // every other scene is on the other raceway
  Scene s[lanes];
  ContactLanes four;
  ContactState states[2][lanes];
  ContactForces forces[2][lanes];
  double kept[2][lanes][most_states], x[lanes][3], v[lanes][3], w[lanes][3];
  for (int i = 0; i < lanes; ++i) {
    s[i] = scene(parts, n + each * i);
    if (decides && i == open) {    // within reach, and no film is as thick
      const double away = n % 2 ? 50e-6 : -50e-6;
      s[i].ball.x = s[i].ball.x + s[i].ball.x * (away / norm(s[i].ball.x));
    }
    s[i].ball.x.to(x[i]);
    s[i].ball.v.to(v[i]);
    s[i].ball.w.to(w[i]);
    four.ball[i] = {x[i], v[i], w[i]};
  }
  const RacewayPhysics &p = s[0].p;
  const RingState &ring = s[0].ring;
  four.groove = ring;
  four.dt = s[0].dt;
  int different = 0;
  for (const int by_parts : {0, 1}) {
    for (int i = 0; i < lanes; ++i) {
      std::copy(s[i].before, s[i].before + most_states, kept[by_parts][i]);
      four.kept[i] = kept[by_parts][i];
      four.state[i] = &states[by_parts][i];
      four.force[i] = &forces[by_parts][i];
    }
    find_places(p, four);
    for (int i = 0; i < lanes; ++i) {
      ContactState c;
      different += !four.live[i] || !touch(p, s[i].ball.x, ring.e, c);
    }
    four.all = {};
    if (by_parts) act_by_parts(p, four);
    else act_in_lanes(p, four);
    with_parts(parts, [&](const auto &law) {
      for (int i = 0; i < lanes; ++i) {
        ContactState c;
        const bool near = touch(p, s[i].ball.x, ring.e, c);
        const bool live = near && !approach(law, p, s[i].ball, ring, c);
        different += !near || live != four.live[i] || live != !(decides && i == open);
        different += c.overlap != states[by_parts][i].overlap;
        if (!live) continue;
        double after[most_states];
        law.act(p, p.law.at(c.cos_angle), LawStates<double>{four.dt, s[i].before, after}, c);
        const ContactForces f = assemble<std::decay_t<decltype(law)>::couples>(p, ring.e, c);
        different += different_numbers(f, forces[by_parts][i]);
        different += different_numbers(c, states[by_parts][i]);
        for (int k = 0; k < law.states; ++k) different += after[k] != kept[by_parts][i][k];
      }
    });
  }
  return different;
}

}    // namespace

EXPORT(int, laws, ()) { return static_cast<int>(laws_of_parts().size()); }
EXPORT(const char *, law_name, (int law))
{
  static std::string text;
  text = law_text(laws_of_parts()[law]);
  return text.c_str();
}
EXPORT(int, law_explicit, (int law)) { return law_facts(laws_of_parts()[law]).explicit_step; }

// n x n slopes by duals and by differences, n forces; returns n
EXPORT(int, law_slopes,
       (int law, int sample, double dual[36], double difference[36], double forces[6]))
{
  const Scene s = scene(laws_of_parts()[law], sample);
  int n = 0;
  with_parts(s.p.parts, [&](const auto &law) { n = slopes_of(law, s, dual, difference, forces); });
  return n;
}

// Of a law that implicit steps can take.
EXPORT(int, law_bits, (int law, int sample))
{
  const Scene s = scene(laws_of_parts()[law], sample);
  int different = 0;
  with_parts(s.p.parts, [&](const auto &law) { different = bit_differences(law, s); });
  return different;
}

EXPORT(int, law_lanes, (int law, int sample))
{
  return lane_differences(laws_of_parts()[law], sample);
}

// -1: the law is not compiled as a whole
EXPORT(int, law_fused, (int law, int sample))
{
  const Scene s = scene(laws_of_parts()[law], sample);
  int different = -1;
  const auto compare = [&](auto fused) { different = fused_differences<decltype(fused)>(s); };
  with_law(s.p.parts, DryLaws(), compare) || with_law(s.p.parts, PaperLaws(), compare) ||
      with_law(s.p.parts, FilmLaws(), compare) || with_law(s.p.parts, FullLaws(), compare);
  return different;
}

// Why keywords cannot make this set of parts, named one after the other; "" if they can.
EXPORT(const char *, law_contradiction, (const char *names))
{
  static std::string text;
  std::istringstream words(names);
  unsigned parts = 0;
  for (std::string name; words >> name;)
    for (size_t k = 0; k < part_table().size(); ++k)
      if (part_table()[k].name == name) parts |= 1u << k;
  text = contradiction(parts);
  return text.c_str();
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
