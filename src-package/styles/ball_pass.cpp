// SPDX-License-Identifier: GPL-2.0-or-later
#include "ball_pass.h"

#include "../core/settings/arguments.h"
#include "../ranks/gather.h"
#include "fix_bearing_ring.h"
#include "fixes.h"
#include "named_bearing.h"
#include "pair_bearing_hertz.h"

#include <algorithm>
#include <map>

using namespace LAMMPS_NS;
using raceway::Groove;
using raceway::RacewayPhysics;
using raceway::Side;
using raceway::Vec3;

namespace bearing {

namespace {

struct Body {
  double tag, type, radius;
  double spin;    // rad/s, imposed by a fix or kept by a ring without a fix; otherwise NAN
  Vec3 x;
};

// Returns the balls and rings of all ranks, sorted by tag.
std::vector<Body> bodies_of(LAMMPS *lmp, const PairCoefficients &coefficients)
{
  const Atom &atom = *lmp->atom;
  const raceway::LabAxes axes{coefficients.axis_index()};
  std::vector<Body> mine;
  std::vector<int> local;
  for (int i = 0; i < atom.nlocal; ++i)
    if (coefficients.is_ball(atom.type[i]) || coefficients.is_ring(atom.type[i])) {
      local.push_back(i);
      mine.push_back({double(atom.tag[i]), double(atom.type[i]), atom.radius[i], NAN,
                      axes.third(Vec3::from(atom.x[i]))});
    }
  for (size_t k = 0; k < mine.size(); ++k)
    if (const int i = local[k]; coefficients.is_ring(atom.type[i])) {
      const double kept = axes.third(Vec3::from(atom.omega[i])).z;
      if (kept != 0.0) mine[k].spin = kept;
    }
  for (FixBearingRing *f : fixes_of<FixBearingRing>(lmp)) {
    const std::vector<double> spin = f->imposed_spin();
    for (size_t k = 0; k < mine.size(); ++k)
      if (f->moves(local[k])) mine[k].spin = spin[local[k]];
  }
  std::vector<Body> all = gather_all(mine, lmp->world);
  std::sort(all.begin(), all.end(), [](const Body &a, const Body &b) { return a.tag < b.tag; });
  return all;
}

// The groove of a ring whose surface is nearest to a ball.
struct Place {
  const RacewayPhysics *raceway = nullptr;
  double gap = HUGE_VAL, cosine = 1.0;    // gap, m; cosine of the contact angle
};

Place place(const PairCoefficients &coefficients, const Body &ball, const Body &ring)
{
  Place best;
  const Vec3 d = ball.x - ring.x;
  const double r = std::hypot(d.x, d.y);
  for (int n = 0;; ++n) {
    const RacewayPhysics *p =
        coefficients.raceway(static_cast<int>(ball.type), static_cast<int>(ring.type), n);
    if (!p) return best;
    const Groove &g = p->groove;
    const double across = r - g.centre_circle(), along = d.z - g.offset,
                 s = std::hypot(across, along), gap = g.groove_radius - ball.radius - s;
    if (std::fabs(gap) < std::fabs(best.gap)) best = {p, gap, std::fabs(across) / s};
  }
}

// A row of balls between an inner and an outer ring.
struct Row {
  const Body *ring[2] = {};
  const RacewayPhysics *raceway[2] = {};
  double balls = 0.0, ball_radius = 0.0, cosine = 1.0;

  // Returns the duration of a ball pass, s. It is not finite if the balls do not move. A ring with
  // an unknown spin is assumed to be at rest.
  double pass(double angle) const
  {
    const double pitch = written(
                     0.5 * (raceway[0]->groove.raceway_radius + raceway[1]->groove.raceway_radius)),
                 c = std::isnan(angle) ? cosine : std::cos(angle * M_PI / 180.0),
                 share = 1 - 0.5 * (2.0 * ball_radius) * c / pitch,
                 inner = std::isnan(ring[0]->spin) ? 0.0 : ring[0]->spin,
                 outer = std::isnan(ring[1]->spin) ? 0.0 : ring[1]->spin;
    if (outer == 0.0) return 2 * M_PI / (balls * 0.5 * std::fabs(inner) * share);
    return 2 * M_PI / (balls * 0.5 * std::fabs(inner * share + outer * (2.0 - share)));
  }
};

// Assigns each ball to the nearest inner ring and the nearest outer ring.
std::vector<Row> rows_of(LAMMPS *lmp, const PairCoefficients &coefficients,
                         const std::vector<Body> &bodies)
{
  std::map<std::pair<double, double>, Row> rows;
  for (const Body &ball : bodies) {
    if (!coefficients.is_ball(static_cast<int>(ball.type))) continue;
    Row row;
    Place best[2];
    for (const Body &ring : bodies) {
      if (!coefficients.is_ring(static_cast<int>(ring.type))) continue;
      const Place p = place(coefficients, ball, ring);
      if (!p.raceway) continue;
      const int side = p.raceway->groove.side == Side::inner ? 0 : 1;
      if (std::fabs(p.gap) > ball.radius || std::fabs(p.gap) >= std::fabs(best[side].gap)) continue;
      best[side] = p;
      row.ring[side] = &ring;
      row.raceway[side] = p.raceway;
    }
    if (!row.ring[0] || !row.ring[1]) continue;
    row.ball_radius = ball.radius;
    const NamedBearing *b = bearing_of_type(lmp, static_cast<int>(ball.type));
    row.cosine = b && b->in_use ? std::cos(b->contact_angle() * M_PI / 180.0) : best[0].cosine;
    Row &in = rows.emplace(std::make_pair(row.ring[0]->tag, row.ring[1]->tag), row).first->second;
    in.balls += 1.0;
  }
  std::vector<Row> list;
  for (const auto &row : rows) list.push_back(row.second);
  return list;
}

}    // namespace

std::vector<BallRow> ball_rows(LAMMPS *lmp, const std::string &command, double angle)
{
  const PairCoefficients &coefficients = PairBearingHertz::find(lmp, command)->coefficients();
  const std::vector<Body> bodies = bodies_of(lmp, coefficients);
  std::vector<BallRow> all;
  for (const Row &row : rows_of(lmp, coefficients, bodies))
    all.push_back({row.balls, row.pass(angle)});
  return all;
}

double ball_pass_time(LAMMPS *lmp, const std::string &command, double angle)
{
  const PairCoefficients &coefficients = PairBearingHertz::find(lmp, command)->coefficients();
  const std::vector<Body> bodies = bodies_of(lmp, coefficients);
  const std::vector<Row> rows = rows_of(lmp, coefficients, bodies);
  if (rows.empty()) BRG_ALL_OF(lmp, command + ": there is no bearing with balls between two rings");
  double longest = 0.0;
  for (const Row &row : rows) {
    if (std::isnan(row.ring[0]->spin) && std::isnan(row.ring[1]->spin))
      BRG_ALL_OF(lmp, command + ": no fix bearing/ring imposes the spin of ring " +
                          std::to_string(static_cast<long>(row.ring[0]->tag)) + " or " +
                          std::to_string(static_cast<long>(row.ring[1]->tag)) +
                          ", which determines its ball pass");
    const double pass = row.pass(angle);
    if (std::isfinite(pass)) longest = std::max(longest, pass);
  }
  if (longest == 0.0) BRG_ALL_OF(lmp, command + ": no ring turns, so balls do not pass");
  return written(longest);
}

}    // namespace bearing
