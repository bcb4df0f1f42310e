// SPDX-License-Identifier: GPL-2.0-or-later
#include "find_record_layout.h"

#include "../ranks/gather.h"
#include "../ranks/home_bearings.h"
#include "fix_bearing_cage.h"
#include "fix_bearing_cage_ring.h"
#include "fix_bearing_capacitance.h"
#include "fix_bearing_state.h"
#include "fixes.h"
#include "pair_bearing_hertz.h"

#include <algorithm>
#include <map>
#include <tuple>

using namespace LAMMPS_NS;
using raceway::BearingModel;
using raceway::RacewayPhysics;
using raceway::Side;

namespace bearing {

namespace {

// Data of a bearing that its home rank sends to all ranks.
struct Piece {
  enum Kind { kind, ball, cage, ring } what;
  double bearing, tag;    // number that identifies the bearing; tag of the atom
  int raceway;
  double of[of_kind::N];    // data of the bearing; for a ring: its origin, pocket play, guide and
                            // phase
};

bool before(const Piece &a, const Piece &b)
{
  return std::make_tuple(a.what, a.bearing, a.tag) < std::make_tuple(b.what, b.bearing, b.tag);
}

// Returns the relative permittivity of the oil at each ball, from the first fix bearing/capacitance
// whose group contains the ball.
std::map<double, double> permittivities(LAMMPS *lmp)
{
  std::vector<double> mine, space;    // `mine` contains alternately the tag of a ball and a
                                      // permittivity
  for (const FixBearingCapacitance *f : capacitances_of(lmp))
    for (int i = 0; i < lmp->atom->nlocal; ++i)
      if (f->covers(i)) {
        mine.push_back(static_cast<double>(lmp->atom->tag[i]));
        mine.push_back(f->model().permittivity);
      }
  const std::vector<double> &all = gather_all(mine, space, lmp->world);
  std::map<double, double> of;
  for (size_t k = 0; k < all.size(); k += 2) of.emplace(all[k], all[k + 1]);
  return of;
}

// The inner and the outer raceway of a bearing; null if missing.
struct Raceways {
  const RacewayPhysics *of[2] = {};
};

void describe(const BearingModel &m, const Raceways &both, double permittivity, double *of)
{
  std::fill(of, of + of_kind::N, NAN);
  const RacewayPhysics *inner = both.of[0], *outer = both.of[1], *any = inner ? inner : outer;
  of[of_kind::BALLS] = of[of_kind::CAGE_BALLS] = 0.0;
  for (const BearingModel::Body &b : m.bodies) {
    of[b.spins ? of_kind::BALLS : of_kind::CAGE_BALLS] += 1.0;
    if (b.spins) of[of_kind::BALL_MASS] = b.mass;
    else of[of_kind::CAGE_BALL_DIAMETER] = 2.0 * b.radius;
  }
  of[of_kind::BALL_DIAMETER] = 2.0 * any->groove.ball_radius;
  if (inner) {
    of[of_kind::INNER_RADIUS] = inner->groove.raceway_radius;
    of[of_kind::INNER_GROOVE] = inner->groove.groove_radius;
    if (inner->groove.offset != 0.0) of[of_kind::INNER_ARCH] = std::fabs(inner->groove.offset);
  }
  if (outer) {
    of[of_kind::OUTER_RADIUS] = outer->groove.raceway_radius;
    of[of_kind::OUTER_GROOVE] = outer->groove.groove_radius;
    if (outer->groove.offset != 0.0) of[of_kind::OUTER_ARCH] = std::fabs(outer->groove.offset);
  }
  // the clearance is rounded to a picometre, so that rounding errors of the radii do not appear as
  // clearance
  if (inner && outer)
    of[of_kind::CLEARANCE] =
        std::round(2e12 * (outer->groove.middle_radius() - inner->groove.middle_radius() -
                           of[of_kind::BALL_DIAMETER])) /
            1e12 +
        0.0;
  of[of_kind::BALL_YOUNG] = any->material.ball_young;
  of[of_kind::BALL_POISSON] = any->material.ball_poisson;
  of[of_kind::RING_YOUNG] = any->material.ring_young;
  of[of_kind::RING_POISSON] = any->material.ring_poisson;
  if (any->model.lubricant.viscosity > 0.0) {
    of[of_kind::VISCOSITY] = any->model.lubricant.viscosity;
    of[of_kind::PRESSURE_VISCOSITY] = any->model.lubricant.pressure_viscosity;
    of[of_kind::PERMITTIVITY] = permittivity;
    of[of_kind::RING_ROUGHNESS] = any->ring_roughness;
    of[of_kind::BALL_ROUGHNESS] = any->ball_roughness;
  }
}

}    // namespace

BearingSources sources_of(LAMMPS *lmp, PairBearingHertz &pair)
{
  BearingSources sources;
  sources.table = &pair.table();
  sources.axes.along = pair.coefficients().axis_index();
  for (const FixBearingCage *c : fixes_of<FixBearingCage>(lmp))
    sources.cages.push_back(&c->rails());
  for (const FixBearingCageRing *c : fixes_of<FixBearingCageRing>(lmp))
    sources.cage_rings.push_back(&c->pockets());
  sources.is_ring = [&pair](int type) { return pair.coefficients().is_ring(type); };
  sources.is_ball = [&pair](int type) { return pair.coefficients().is_ball(type); };
  sources.raceway = [&pair](int ball, int ring, int groove) {
    return pair.coefficients().raceway(ball, ring, groove);
  };
  sources.motion = [&pair](int i) -> RingMotion & { return pair.state()->ring(i); };
  return sources;
}

RecordLayout find_record_layout(LAMMPS *lmp, PairBearingHertz &pair, int groupbit,
                                const std::string &command)
{
  HomeBearings bearings(lmp, command);
  bearings.build(sources_of(lmp, pair), groupbit);
  bearings.gather();
  const raceway::LabAxes axes = {pair.coefficients().axis_index()};
  const std::map<double, double> permittivity = permittivities(lmp);
  std::vector<Piece> mine;
  for (int p = 0; p < bearings.size(); ++p) {
    const BearingModel &m = bearings.model(p);
    const double name = static_cast<double>(m.name());
    Raceways both;
    std::vector<int> side(m.rings.size(), 0);
    for (const BearingModel::Groove &g : m.grooves) {
      const int s = g.physics->groove.side == Side::inner ? 0 : 1;
      if (!both.of[s]) both.of[s] = g.physics;
      side[g.ring] = s;
    }
    for (const BearingModel::Cage &c : m.cages) side[c.ring] = RecordLayout::cage_ring;
    if (m.grooves.empty()) continue;
    Piece piece = {Piece::kind, name, 0.0, 0, {}};
    const auto eps = permittivity.find(static_cast<double>(m.bodies.front().tag));
    describe(m, both, eps == permittivity.end() ? NAN : eps->second, piece.of);
    mine.push_back(piece);
    for (const BearingModel::Body &b : m.bodies)
      mine.push_back({b.spins ? Piece::ball : Piece::cage, name, double(b.tag), 0, {}});
    for (size_t r = 0; r < m.rings.size(); ++r) {
      Piece ring = {Piece::ring, name, double(m.rings[r].tag), side[r], {}};
      axes.lab(bearings.rings(p)[r].origin).to(ring.of);
      ring.of[3] = ring.of[4] = ring.of[5] = NAN;
      for (const BearingModel::Cage &c : m.cages)
        if (c.ring == static_cast<int>(r)) {
          ring.of[3] = 2.0 * c.of->along;
          ring.of[4] = c.of->guide;
          ring.of[5] = c.of->phase;
        }
      mine.push_back(ring);
    }
  }
  std::vector<Piece> all = gather_all(mine, lmp->world);
  std::sort(all.begin(), all.end(), before);

  RecordLayout layout;
  layout.grooves = pair.coefficients().many_grooves() ? 2 : 1;
  std::map<double, int> number;
  for (const Piece &p : all) {
    switch (p.what) {
      case Piece::kind:
        number.emplace(p.bearing, static_cast<int>(layout.bearings.size()));
        layout.bearings.emplace_back();
        std::copy(p.of, p.of + of_kind::N, layout.bearings.back().of);
        break;
      case Piece::ball: layout.balls.push_back({p.tag, number[p.bearing]}); break;
      case Piece::cage: layout.cage.push_back({p.tag, number[p.bearing]}); break;
      case Piece::ring:
        layout.rings.push_back({p.tag,
                                number[p.bearing],
                                p.raceway,
                                {p.of[0], p.of[1], p.of[2]},
                                p.of[3],
                                p.of[4],
                                p.of[5]});
        break;
    }
  }
  return layout;
}

std::vector<int> ball_types(LAMMPS *lmp, const RecordLayout &layout)
{
  std::vector<int> own(layout.bearings.size(), 0), all(own.size());
  for (const RecordLayout::RecordBody &ball : layout.balls) {
    const int i = lmp->atom->map(static_cast<tag_t>(ball.tag));
    if (i >= 0 && i < lmp->atom->nlocal) own[ball.bearing] = lmp->atom->type[i];
  }
  MPI_Allreduce(own.data(), all.data(), static_cast<int>(own.size()), MPI_INT, MPI_MAX, lmp->world);
  return all;
}

}    // namespace bearing
