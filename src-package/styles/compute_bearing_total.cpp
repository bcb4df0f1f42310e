// SPDX-License-Identifier: GPL-2.0-or-later
#include "compute_bearing_total.h"

#include "arguments.h"
#include "contact_attribute.h"
#include "pair_bearing_hertz.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace raceway;
using bearing::RacewayContact;

ComputeBearingTotal::ComputeBearingTotal(BRG_COMPUTE_ARGS) :
    BRG_COMPUTE_BASE, pair_(PairBearingHertz::find(lmp, "compute bearing/total"))
{
  bearing::Arguments args(lmp, std::string("compute ") + id + " bearing/total", narg, arg, BRG_COMPUTE_FIRST);
  if (args.more()) args.unknown("none, the command ends here");
  vector_flag = 1;
  size_vector = N_COLUMN;
  extvector = 0;
  vector = values_;
}

void ComputeBearingTotal::init() { pair_ = PairBearingHertz::find(lmp, "compute bearing/total"); }

void ComputeBearingTotal::compute_vector()
{
  invoked_vector = update->ntimestep;
  // largest values; the smallest as the largest negative
  double most[7] = {0.0, 0.0, 0.0, -HUGE_VAL, -HUGE_VAL, 0.0, 0.0};
  double sum[6] = {};    // live, balls loaded on both sides, balls, orbit, friction and damping power
  const std::vector<RacewayContact> &rows = pair_->table().raceway;
  for (size_t i = 0; i < rows.size();) {
    const bearing::tag_t ball = rows[i].ball;
    int sides = 0;
    const size_t first = i;
    for (; i < rows.size() && rows[i].ball == ball; ++i) {
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
      sum[0] += 1.0;
      sum[4] += s.friction_t * s.sliding_t + s.friction_w * s.sliding_w;
      sum[5] += (s.normal - s.load) * s.overlap_rate;
    }
    sum[1] += sides == 3;
    sum[2] += 1.0;
    // the orbit is seen from the outer ring where there is one, as in compute bearing/ball
    const RacewayContact &c = rows[first].side() == Side::outer ? rows[first] : rows[i - 1];
    sum[3] += bearing::orbit(*atom, *pair_, c);
  }
  for (const bearing::SphereContact &s : pair_->table().sphere) most[5] = std::max(most[5], s.force);
  MPI_Allreduce(MPI_IN_PLACE, most, 7, MPI_DOUBLE, MPI_MAX, world);
  MPI_Allreduce(MPI_IN_PLACE, sum, 6, MPI_DOUBLE, MPI_SUM, world);
  const bool film = pair_->lubricated() && std::isfinite(most[3]);
  values_[LIVE] = sum[0];
  values_[LOADED_BALLS] = sum[1];
  values_[INNER_LOAD] = most[0];
  values_[OUTER_LOAD] = most[1];
  values_[PRESSURE] = most[2];
  values_[H_MIN] = film ? -most[3] : 0.0;
  values_[LAMBDA] = film ? -most[4] : 0.0;
  values_[ORBIT] = sum[2] > 0.0 ? sum[3] / sum[2] : 0.0;
  values_[FRICTION_POWER] = sum[4];
  values_[DAMPING_POWER] = sum[5];
  values_[CAGE_FORCE] = most[5];
}
