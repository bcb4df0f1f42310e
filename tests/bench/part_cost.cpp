// SPDX-License-Identifier: GPL-2.0-or-later
// Measures the time of the contact laws alone, part by part, for part_cost.py. The program prints
// one line per law, "NAME BASE explicit implicit", where the times are in ns per contact.
// "explicit" is an evaluation in doubles; "implicit" is an evaluation with derivatives, for four
// contacts at a time.
#include "../../src-package/core/contact/contact.h"
#include "../../src-package/core/contact/contact_slopes.h"

#include <chrono>
#include <cstdio>
#include <random>
#include <vector>

using namespace raceway;

namespace {

constexpr int contacts = 4096;    // few enough for all states to fit into the cache of one core

struct Scene {
  RacewayPhysics p;
  std::vector<BallState> ball;
  RingState ring;
};

struct Film {
  bool all_regimes = false;
  InletShear shear = InletShear::murch;
};

// Return contacts of a 6208 at 477.5 rpm with loads up to 2.4 kN that roll with a little slip.
Scene scene(unsigned parts, const Film &film)
{
  Scene s;
  s.p.groove = {Side::inner, 24e-3, 6.552e-3, 6.3e-3};
  s.p.model.lubricant = {0.04, 22e-9};
  s.p.ring_roughness = 1e-7;
  s.p.parts = parts;
  s.p.factors = {film.shear, 0.047, 0.134, 1.0};
  s.p.of<FilmInGapPart>().all_regimes = film.all_regimes;
  s.p.of<ConstantFrictionPart>().mu = 0.1;
  s.p.of<StribeckFrictionPart>().curve = {0.12, 0.05, 0.0, 0.0};
  s.p.of<HydrodynamicRollingPart>().beta = 0.047;
  s.p.of<DragPart>().share = 0.1;
  s.p.prepare(30.3e-3, 8.17e-3, 0.05);
  s.ring = {{0, 0, 0}, {0, 0, 0}, {0, 0, 50.0}, {0, 0, 1}};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> overlap(1e-6, 17e-6), slip(-1e-3, 1e-3);
  for (int k = 0; k < contacts; ++k) {
    const double r = s.p.centre_circle - s.p.slack - overlap(random);
    s.ball.push_back({{r, 0, 0}, {slip(random), 0.6 + slip(random), slip(random)}, {0, 0, -95.0}});
  }
  return s;
}

double seconds()
{
  using namespace std::chrono;
  return duration<double>(steady_clock::now().time_since_epoch()).count();
}

template <class L> double explicit_pass(const Scene &s, double *states)
{
  double sum = 0.0;
  for (int k = 0; k < contacts; ++k) {
    ContactState c;
    if (!touch(s.p, s.ball[k].x, s.ring.e, c)) continue;
    double after[L::states > 0 ? L::states : 1];
    double *before = states + k * L::states;
    find_motions<L::couples>(s.p, s.ball[k], s.ring, c);
    if (L::decides) L::misses(s.p, s.p.law.at(c.cos_angle), c);
    L::act(s.p, s.p.law.at(c.cos_angle), LawStates<double>{1e-6, before, after}, c);
    const ContactForces f = assemble<L::couples>(s.p, s.ring.e, c);
    for (int m = 0; m < L::states; ++m) before[m] = after[m];
    sum += dot(f.force, {1, 1, 1}) + dot(f.ball_torque, {1, 1, 1}) + dot(f.ring_torque, {1, 1, 1});
  }
  return sum;
}

template <class L> RACEWAY_INLINE double implicit_sum(const Scene &s, Lane *states)
{
  double total = 0.0;
  for (int k = 0; k < contacts; k += lanes) {
    BallStateT<Lane> ball;
    for (int i = 0; i < lanes; ++i) {
      const BallState &b = s.ball[k + i];
      ball.x.x[i] = b.x.x;
      ball.v.x[i] = b.v.x;
      ball.v.y[i] = b.v.y;
      ball.v.z[i] = b.v.z;
      ball.w.z[i] = b.w.z;
      ball.x.y[i] = ball.x.z[i] = ball.w.x[i] = ball.w.y[i] = 0.0;
    }
    const Lane none = {};
    const RingStateT<Lane> ring = {{none, none, none},
                                   {none, none, none},
                                   {none, none, all_lanes(s.ring.w.z)},
                                   {none, none, all_lanes(1.0)}};
    ContactStateT<Lane> c;
    locate(ball.x, ring.e, s.p.centre_circle, c);
    out_of_reach(s.p, c);
    find_motions<L::couples>(s.p, ball, ring, c);
    if (L::decides) L::misses(s.p, s.p.law.at(c.cos_angle), c);
    Lane after[L::states > 0 ? L::states : 1];
    Lane *before = states + k / lanes * L::states;
    ContactSlopesT<Lane, L::motions> slopes;
    act_with_slopes(L(), s.p, LawStates<Lane>{1e-4, before, after, true}, 1e-4, c, slopes);
    for (int m = 0; m < L::states; ++m) before[m] = after[m];
    const ContactForcesT<Lane> f = assemble<L::couples>(s.p, ring.e, c);
    Lane used = f.force.x + f.force.y + f.force.z + f.ball_torque.x + f.ball_torque.y +
                f.ball_torque.z + f.ring_torque.x + f.ring_torque.y + f.ring_torque.z;
    for (const auto &row : slopes.of)
      for (const Lane &slope : row) used += slope;
    total += sum(used);
  }
  return total;
}

template <class L> struct Implicit {
  RACEWAY_LANES static double pass(const Scene &s, Lane *states)
  {
    return implicit_sum<L>(s, states);
  }
};

// A plain Lane may be aligned to only 16 bytes when it is an element of a vector (lane.h).
struct alignas(sizeof(Lane)) State {
  Lane of;
};

double kept = 0.0;    // prevents the compiler from removing unused results

template <class L> void report(const char *name, int base, const Film &film = {})
{
  const Scene s = scene(L::parts, film);
  std::vector<double> one(contacts * (L::states + 1));
  std::vector<State> four(contacts / lanes * (L::states + 1));
  double least[2] = {HUGE_VAL, HUGE_VAL};
  // other work on the machine affects the minimum least
  for (int round = 0; round < 40; ++round) {
    const double t0 = seconds();
    kept += explicit_pass<L>(s, one.data());
    const double t1 = seconds();
    kept += Implicit<L>::pass(s, &four[0].of);
    const double t2 = seconds();
    least[0] = std::fmin(least[0], t1 - t0);
    least[1] = std::fmin(least[1], t2 - t1);
  }
  printf("%s|%d|%.2f|%.2f\n", name, base, least[0] / contacts * 1e9, least[1] / contacts * 1e9);
}

template <class... P>
using GapLaw =
    Law<FilmInGapPart, HysteresisPart, FilmThicknessPart, FilmDamperPart, NormalForcePart, P...>;
template <class... P> using Slip = FullLaw<MixedFrictionPart, DifferentialSlipPart, P...>;

}    // namespace

int main()
{
  report<DryLaw<>>("Hertz, hysteretic damping", -1);
  report<LubricatedLaw<>>("film thickness, film damper according to eq 5", 0);
  report<GapLaw<>>("film in the gap instead of Hertz alone", 1);
  report<FullLaw<>>("film branch instead of the film damper", 2);
  report<FullLaw<ConstantFrictionPart, SmoothedFrictionPart>>("smoothed friction", 3);
  report<FullLaw<StribeckFrictionPart, SmoothedFrictionPart>>("Stribeck's coefficient", 4);
  report<FullLaw<MixedFrictionPart, SmoothedFrictionPart>>("mixed coefficient", 4);
  report<Slip<>>("differential slip instead of smoothed friction", 6);
  report<Slip<HydrodynamicRollingPart>>("hydrodynamic rolling", 7);
  report<Slip<HydrodynamicRollingPart, RollingHysteresisPart>>("hysteresis in rolling", 8);
  report<Slip<HydrodynamicRollingPart, RollingHysteresisPart, SpinPart>>("spin", 9);
  report<Slip<HydrodynamicRollingPart, RollingHysteresisPart, SpinPart, DragPart>>("drag", 10);
  report<FullLaw<MixedFrictionPart, SlipSlicesPart, HydrodynamicRollingPart, RollingHysteresisPart,
                 DragPart>>("slip and spin in slices instead of closed-form laws", 11);
  report<FullLaw<>>("film of all regimes instead of the power law", 3, {true});
  report<FullLaw<>>("inlet shear after Gupta instead of Murch and Wilson", 3,
                    {false, InletShear::gupta});
  fprintf(stderr, "%g\n", kept);
}
