// SPDX-License-Identifier: GPL-2.0-or-later
#include "compute_bearing_total.h"

#include "../deck/arguments.h"
#include "../physics/contact.h"
#include "../ranks/gather.h"
#include "contact_context.h"
#include "pair_bearing_hertz.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace raceway;
using bearing::RacewayContact;

ComputeBearingTotal::ComputeBearingTotal(BRG_COMPUTE_ARGS) :
    BRG_COMPUTE_BASE, pair_(PairBearingHertz::find(lmp, "compute bearing/total"))
{
  bearing::Arguments args(lmp, std::string("compute ") + id + " bearing/total", narg, arg,
                          BRG_COMPUTE_FIRST);
  if (args.more()) args.unknown("none, the command ends here");
  vector_flag = 1;
  size_vector = bearing::of_total::N;
  extvector = 0;
  vector = values_;
}

void ComputeBearingTotal::init() { pair_ = PairBearingHertz::find(lmp, "compute bearing/total"); }

void ComputeBearingTotal::compute_vector()
{
  invoked_vector = update->ntimestep;
  pair_ = PairBearingHertz::find(
      lmp, "compute bearing/total");    // it may have been replaced between runs
  // largest values; the smallest as the largest negative
  double most[7] = {0.0, 0.0, 0.0, -HUGE_VAL, -HUGE_VAL, 0.0, 0.0};
  // counts are exact in any order; real sums are made over all balls by tag, for the same bits on
  // any ranks
  double count[3] = {};    // live contacts, balls loaded on both sides, balls
  struct Ball {
    bearing::tag_t tag;
    double orbit, friction, damping;
  };
  std::vector<Ball> balls;
  const std::vector<RacewayContact> &rows = pair_->table().raceway;
  for (size_t i = 0; i < rows.size();) {
    Ball ball = {rows[i].ball, 0.0, 0.0, 0.0};
    int sides = 0;
    const size_t first = i;
    for (; i < rows.size() && rows[i].ball == ball.tag; ++i) {
      const RacewayContact &c = rows[i];
      if (!c.live) continue;
      const ContactState &s = c.state;
      sides |= c.side() == Side::inner ? 1 : 2;
      double &load = most[c.side() == Side::inner ? 0 : 1];
      load = std::max(load, s.load);
      most[2] = std::max(most[2], c.raceway->law.at(s.cos_angle).p * s.root);
      if (pair_->lubricated()) {
        most[3] = std::max(most[3], -s.h_min);
        most[4] = std::max(most[4], -s.lambda);
      }
      count[0] += 1.0;
      ball.friction += friction_power(s);
      ball.damping += damping_power(s);
    }
    count[1] += sides == 3;
    count[2] += 1.0;
    // the orbit is seen from the outer ring where there is one, as in compute bearing/ball
    const RacewayContact &c = rows[first].side() == Side::outer ? rows[first] : rows[i - 1];
    ball.orbit = bearing::orbit_of(*atom, *pair_, c);
    balls.push_back(ball);
  }
  for (const bearing::SphereContact &s : pair_->table().sphere)
    most[5] = std::max(most[5], s.force);
  MPI_Allreduce(MPI_IN_PLACE, most, 7, MPI_DOUBLE, MPI_MAX, world);
  MPI_Allreduce(MPI_IN_PLACE, count, 3, MPI_DOUBLE, MPI_SUM, world);
  balls = bearing::gather_all(balls, world);
  std::sort(balls.begin(), balls.end(), [](const Ball &a, const Ball &b) { return a.tag < b.tag; });
  Ball sum = {0, 0.0, 0.0, 0.0};
  for (const Ball &b : balls) {
    sum.orbit += b.orbit;
    sum.friction += b.friction;
    sum.damping += b.damping;
  }
  namespace of_total = bearing::of_total;
  const bool film = pair_->lubricated() && std::isfinite(most[3]);
  values_[of_total::CONTACTS] = count[0];
  values_[of_total::LOADED_BALLS] = count[1];
  values_[of_total::LOAD_INNER] = most[0];
  values_[of_total::LOAD_OUTER] = most[1];
  values_[of_total::PRESSURE] = most[2];
  values_[of_total::H_MIN] = film ? -most[3] : 0.0;
  values_[of_total::LAMBDA] = film ? -most[4] : 0.0;
  values_[of_total::CAGE_SPEED] = count[2] > 0.0 ? sum.orbit / count[2] : 0.0;
  values_[of_total::FRICTION_POWER] = sum.friction;
  values_[of_total::DAMPING_POWER] = sum.damping;
  values_[of_total::CAGE_FORCE] = most[5];
}
