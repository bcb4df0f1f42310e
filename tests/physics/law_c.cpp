// SPDX-License-Identifier: GPL-2.0-or-later
// Exports every possible contact law to test_physics_laws.py: slopes from duals and from
// differences, values for contacts evaluated one by one and four at a time, and values for laws
// evaluated part by part and as a whole.
#include "../../src-package/core/interface/exports.h"
#include "../../src-package/core/numbers/instruction_set.h"

#include "law_scenes.h"

#include <sstream>

namespace {

template <class T> const T *force_of(const ContactStateT<T> &c, int i)
{
  const T *forces[] = {&c.normal,   &c.friction_t, &c.friction_w,
                       &c.couple_n, &c.couple_t,   &c.couple_w};
  return forces[i];
}

// Computes how the local forces change when the k-th motion changes by `step` times its natural
// size. Quantities that the law treats as constant do not change.
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
  for (int k = 0; k < n; ++k) {    // fourth-order differences
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

// Returns how many values are not bitwise identical in two structs that consist only of doubles.
template <class A> int different_numbers(const A &a, const A &b)
{
  const double *const x = reinterpret_cast<const double *>(&a),
                      *const y = reinterpret_cast<const double *>(&b);
  int different = 0;
  for (size_t k = 0; k < sizeof(A) / sizeof(double); ++k)
    different += x[k] != y[k] && !(std::isnan(x[k]) && std::isnan(y[k]));
  return different;
}

// The result of an evaluation: the contact, its states and its slopes.
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

// Evaluates four identical contacts at once, and returns the result from one lane.
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

// Returns how many values differ between evaluations with doubles, lanes, duals of doubles and
// duals of lanes.
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

// Returns how many values differ between a law compiled as a whole and the same law evaluated part
// by part.
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

// Returns how many values are not bitwise identical between four contacts on one raceway that are
// evaluated at once and one by one; the last contact may be open.
int lane_differences(unsigned parts, int n)
{
  const bool decides = law_facts(parts).decides;
  const int each = 2, open = 3;    // every second scene is on the other raceway
  Scene s[lanes];
  ContactLanes four;
  ContactState states[2][lanes];
  ContactForces forces[2][lanes];
  double kept[2][lanes][most_states], x[lanes][3], v[lanes][3], w[lanes][3];
  for (int i = 0; i < lanes; ++i) {
    s[i] = scene(parts, n + each * i);
    if (decides && i == open) {    // still within reach, because no film is this thick
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

// Computes n forces, and n x n slopes both from duals and from differences; returns n.
EXPORT(int, law_slopes,
       (int law, int sample, double dual[36], double difference[36], double forces[6]))
{
  const Scene s = scene(laws_of_parts()[law], sample);
  int n = 0;
  with_parts(s.p.parts, [&](const auto &law) { n = slopes_of(law, s, dual, difference, forces); });
  return n;
}

// Returns how many values are not bitwise identical for a law that implicit steps can use.
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

// Returns -1 if the law is not among those that are compiled as a whole.
EXPORT(int, law_fused, (int law, int sample))
{
  const Scene s = scene(laws_of_parts()[law], sample);
  int different = -1;
  const auto compare = [&](auto fused) { different = fused_differences<decltype(fused)>(s); };
  with_law(s.p.parts, DryLaws(), compare) || with_law(s.p.parts, PaperLaws(), compare) ||
      with_law(s.p.parts, FilmLaws(), compare) || with_law(s.p.parts, FullLaws(), compare);
  return different;
}

// Returns the reason why keywords cannot form this set of parts, or "" if they can. `names`
// contains the names of the parts one after another.
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

// Returns whether the processor has AVX2, and whether contacts are evaluated with it.
EXPORT(int, has_avx2, ())
{
#ifdef __x86_64__
  return __builtin_cpu_supports("avx2") != 0;
#else
  return 1;    // a single compilation counts as code without AVX2
#endif
}
EXPORT(int, takes_avx2, ()) { return wide_lanes(); }
