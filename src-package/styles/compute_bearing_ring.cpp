// SPDX-License-Identifier: GPL-2.0-or-later
#include "compute_bearing_ring.h"

#include "../physics/capacitance.h"
#include "fix_bearing_capacitance.h"
#include "fix_bearing_state.h"
#include "pair_bearing_hertz.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace raceway;
using bearing::RacewayContact;
using bearing::RingSum;

namespace {

// What a contact says about its ring.
enum Said {
  LIVE,
  LOADED,
  LOAD,
  PRESSURE,
  H_MIN,
  LAMBDA,
  FRICTION,
  DAMPING,
  CAPACITANCE,
  ORBIT,
  ALONG,
  N_SAID = ALONG + 3
};

enum Value {
  RING,
  X,
  Y,
  Z,
  VX,
  VY,
  VZ,
  SPIN,
  ANGLE,
  FX,
  FY,
  FZ,
  MX,
  MY,
  MZ,
  TORQUE,
  CONTACTS,
  BALLS,
  MOST_LOAD,
  MOST_PRESSURE,
  LEAST_H,
  LEAST_LAMBDA,
  MEAN_ORBIT,
  FRICTION_POWER,
  DAMPING_POWER,
  SUM_CAPACITANCE,
  N_VALUE
};
const char *const names[N_VALUE] = {
    "ring",          "x",          "y",    "z",        "vx",    "vy",     "vz",    "spin",
    "angle",         "fx",         "fy",   "fz",       "mx",    "my",     "mz",    "torque",
    "contacts",      "balls",      "load", "pressure", "h_min", "lambda", "orbit", "friction_power",
    "damping_power", "capacitance"};

}    // namespace

// compute ID group bearing/ring value ...
ComputeBearingRing::ComputeBearingRing(BRG_COMPUTE_ARGS) :
    BRG_COMPUTE_BASE, pair_(PairBearingHertz::find(lmp, "compute bearing/ring"))
{
  bearing::Arguments args(lmp, std::string("compute ") + id + " bearing/ring", narg, arg,
                          BRG_COMPUTE_FIRST);
  do {
    const std::string name = args.word("a value");
    const int k = static_cast<int>(std::find(names, names + N_VALUE, name) - names);
    if (k == N_VALUE) {
      std::string known;
      for (const char *n : names) known += (known.empty() ? "" : ", ") + std::string(n);
      args.fail("unknown value '" + name + "'; known: " + known);
    }
    if ((k == LEAST_H || k == LEAST_LAMBDA || k == SUM_CAPACITANCE) && !pair_->lubricated())
      args.fail("value '" + name + "' needs a lubricant: use pair_style bearing/ehd");
    columns_.push_back(k);
  } while (args.more());
  local_flag = 1;
  size_local_rows = 0;
  // one column is a vector to the host, several are an array
  size_local_cols = columns_.size() == 1 ? 0 : static_cast<int>(columns_.size());
}

void ComputeBearingRing::init()
{
  const std::string name = std::string("compute ") + id + " bearing/ring";
  pair_ = PairBearingHertz::find(lmp, name);
  context_.capacitance.clear();
  if (std::count(columns_.begin(), columns_.end(), SUM_CAPACITANCE) == 0) return;
  context_.capacitance = bearing::capacitance_fixes(lmp);
  if (context_.capacitance.empty())
    BRG_ALL(name + ": value 'capacitance' needs a fix bearing/capacitance");
}

// By claim, which is how a contact reaches the owner of its ring.
void ComputeBearingRing::tell()
{
  said_.assign(static_cast<size_t>(pair_->ring_sum().claims()) * N_SAID, 0.0);
  const std::vector<RacewayContact> &table = pair_->table().raceway;
  for (size_t first = 0, end; first < table.size(); first = end) {
    double side[2] = {0.0, 0.0};    // capacitance on the inner and the outer raceway
    int loaded = 0;
    for (end = first; end < table.size() && table[end].ball == table[first].ball; ++end) {
      const RacewayContact &c = table[end];
      if (!c.live) continue;
      const int s = c.side() == Side::inner ? 0 : 1;
      loaded |= 1 << s;
      side[s] = context_.capacitor(c).capacitance;
    }
    for (size_t k = first; k < end; ++k) {
      const RacewayContact &c = table[k];
      double *said = &said_[static_cast<size_t>(c.claim) * N_SAID];
      // the ring's own velocity is its owner's business: that of a ghost is half a step old
      const GroovePosition g = locate(Vec3::from(atom->x[c.i_ball]) - Vec3::from(atom->x[c.i_ring]),
                                      pair_->state()->axis(c.i_ring), c.raceway->centre_circle);
      said[ORBIT] = dot(Vec3::from(atom->v[c.i_ball]), g.t) / g.r;
      (g.t * (1.0 / g.r)).to(said + ALONG);
      said[LOADED] = loaded == 3;
      said[CAPACITANCE] = series_capacitance(side[0], side[1]);
      if (!c.live) continue;
      const ContactState &s = c.state;
      said[LIVE] = 1.0;
      said[LOAD] = s.load;
      said[PRESSURE] = c.raceway->law.at(s.cos_angle).p * s.root;
      said[H_MIN] = s.h_min;
      said[LAMBDA] = s.lambda;
      said[FRICTION] = bearing::friction_power(s);
      said[DAMPING] = bearing::damping_power(s);
    }
  }
}

// Of the n-th ring of this rank.
void ComputeBearingRing::ring_values(int n, double *of) const
{
  const RingSum &rings = pair_->ring_sum();
  const int i = rings.ring(n);
  const FixBearingState::RingMotion &ring = pair_->state()->ring(i);
  of[RING] = static_cast<double>(atom->tag[i]);
  (Vec3::from(atom->x[i]) - ring.origin).to(of + X);
  Vec3::from(atom->v[i]).to(of + VX);
  of[SPIN] = dot(Vec3::from(atom->omega[i]), ring.axis);
  of[ANGLE] = ring.angle;
  rings.force(n).to(of + FX);
  rings.torque(n).to(of + MX);
  of[TORQUE] = dot(rings.torque(n), ring.axis);
}

void ComputeBearingRing::compute_local()
{
  invoked_local = update->ntimestep;
  pair_ = PairBearingHertz::find(
      lmp, "compute bearing/ring");    // it may have been replaced between runs
  tell();
  const RingSum &rings = pair_->ring_sum();
  std::vector<double> of(static_cast<size_t>(rings.rings()) * N_VALUE, 0.0),
      balls(rings.rings(), 0.0);
  for (int n = 0; n < rings.rings(); ++n) ring_values(n, &of[static_cast<size_t>(n) * N_VALUE]);
  pair_->ring_sum().collect(N_SAID, said_, [&](int n, RingSum::Source source, const double *said) {
    if (source != RingSum::ball) return;
    double *v = &of[static_cast<size_t>(n) * N_VALUE];
    balls[n] += 1.0;
    v[MEAN_ORBIT] +=
        said[ORBIT] - dot(Vec3::from(atom->v[rings.ring(n)]), Vec3::from(said + ALONG));
    v[BALLS] += said[LOADED];
    v[SUM_CAPACITANCE] += said[CAPACITANCE];
    if (said[LIVE] == 0.0) return;
    v[MOST_LOAD] = std::max(v[MOST_LOAD], said[LOAD]);
    v[MOST_PRESSURE] = std::max(v[MOST_PRESSURE], said[PRESSURE]);
    v[LEAST_H] = v[CONTACTS] == 0.0 ? said[H_MIN] : std::min(v[LEAST_H], said[H_MIN]);
    v[LEAST_LAMBDA] = v[CONTACTS] == 0.0 ? said[LAMBDA] : std::min(v[LEAST_LAMBDA], said[LAMBDA]);
    v[CONTACTS] += 1.0;
    v[FRICTION_POWER] += said[FRICTION];
    v[DAMPING_POWER] += said[DAMPING];
  });

  values_.clear();
  for (int n = 0; n < rings.rings(); ++n) {
    if (!(atom->mask[rings.ring(n)] & groupbit)) continue;
    double *v = &of[static_cast<size_t>(n) * N_VALUE];
    if (balls[n] > 0.0) v[MEAN_ORBIT] /= balls[n];
    for (int k : columns_) values_.push_back(v[k]);
  }
  rows_.resize(values_.size() / columns_.size());
  for (size_t r = 0; r < rows_.size(); ++r) rows_[r] = &values_[r * columns_.size()];
  size_local_rows = static_cast<int>(rows_.size());
  vector_local = values_.data();
  array_local = rows_.data();
}

double ComputeBearingRing::memory_usage()
{
  return (said_.capacity() + values_.capacity()) * sizeof(double) +
         rows_.capacity() * sizeof(double *);
}
