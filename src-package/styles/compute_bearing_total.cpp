// SPDX-License-Identifier: GPL-2.0-or-later
#include "compute_bearing_total.h"

#include "../core/settings/arguments.h"
#include "../ranks/gather.h"
#include "cage_losses.h"
#include "contact_context.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace raceway;
using bearing::BallFigures;
using bearing::RacewayContact;

ComputeBearingTotal::ComputeBearingTotal(BRG_COMPUTE_ARGS) :
    BRG_COMPUTE_BASE, pair_(PairBearingHertz::find(lmp, "compute bearing/total"))
{
  bearing::Arguments args(lmp, std::string("compute ") + id + " bearing/total", narg, arg,
                          BRG_COMPUTE_FIRST);
  if (args.more()) args.unknown("none, the command ends here");
  vector_flag = 1;
  size_vector = static_cast<int>(values_.size());
  extvector = 0;
  vector = values_.data();
}

void ComputeBearingTotal::init() { pair_ = PairBearingHertz::find(lmp, "compute bearing/total"); }

void ComputeBearingTotal::compute_vector()
{
  invoked_vector = update->ntimestep;
  pair_ = PairBearingHertz::find(
      lmp, "compute bearing/total");    // the pair style may have been replaced between runs
  // values are summed in the order of tags, so that the sums are bitwise identical on any number of
  // ranks; contacts between two balls, or between a ball and a cage ball, are sorted by both tags
  struct Share {
    bearing::tag_t tag, other;
    BallFigures of;
  };
  std::vector<Share> shares;
  bearing::send_velocities(lmp);
  const bearing::ContactContext context = {pair_->coefficients().axis_index(), nullptr};
  const std::vector<RacewayContact> &rows = pair_->table().raceway;
  for (size_t i = 0; i < rows.size();) {
    Share ball = {rows[i].ball, 0, {}};
    const size_t first = i;
    for (; i < rows.size() && rows[i].ball == ball.tag; ++i)
      if (rows[i].live) ball.of.contact(context.view(rows[i]));
    // the orbital speed is measured relative to the outer ring if the ball touches one, as in
    // compute bearing/ball
    const RacewayContact &c = rows[first].side() == Side::outer ? rows[first] : rows[i - 1];
    ball.of.balls = 1.0;
    ball.of.orbit = bearing::orbit_of(*atom, *pair_, c);
    shares.push_back(ball);
  }
  bearing::each_cage_loss(
      lmp, *pair_, [&](bearing::tag_t tag, bearing::tag_t other, int, double loss, double force) {
        shares.push_back({tag, other, {}});
        shares.back().of.cage(loss, force);
      });
  shares = bearing::gather_all(shares, world);
  std::sort(shares.begin(), shares.end(), [](const Share &a, const Share &b) {
    return a.tag < b.tag || (a.tag == b.tag && a.other < b.other);
  });
  figures_ = {};
  for (const Share &s : shares) figures_.add(s.of);
  for (size_t k = 0; k < values_.size(); ++k)
    values_[k] = bearing::total_figures()[k].value(figures_);
}
