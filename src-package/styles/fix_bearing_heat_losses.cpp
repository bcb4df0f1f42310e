// SPDX-License-Identifier: GPL-2.0-or-later
// Computes the losses and conductances of the contacts in a bearing for fix bearing/heat.
#include "../core/contact/loss_table.h"
#include "../core/laws/heat.h"
#include "../ranks/gather.h"
#include "cage_losses.h"
#include "fix_bearing_heat.h"
#include "named_bearing.h"
#include "pair_bearing.h"

#include <algorithm>
#include <tuple>

using namespace LAMMPS_NS;
using raceway::HeatPass;

// The losses in contacts between the balls and the cage heat the balls. Sums are evaluated in the
// order of tags, so that they are bitwise identical on any number of ranks.
HeatPass FixBearingHeat::losses()
{
  struct Share {
    bearing::tag_t first, second;
    double place;    // index of the groove of a contact; -1 for a contact with a cage
    HeatPass of;
  };
  std::vector<Share> shares;
  for (const bearing::RacewayContact &c : pair_->table().raceway) {
    if (!c.live || atom->type[c.i_ball] != bearing_->balls) continue;
    const raceway::LossPowers powers = raceway::loss_powers(c.state);
    double power = 0.0;
    for (const double one : powers.of) power += one;
    const double drag = c.state.drag_power;
    power -= drag;
    const raceway::RacewayConstants k = c.raceway->law.at(c.state.cos_angle);
    const double conductance = raceway::contact_conductance(k.a * c.state.root, k.b * c.state.root,
                                                            c.state.entrainment, ball_);
    const bool inner = c.side() == raceway::Side::inner;
    HeatPass of;
    raceway::add_losses(of.heat, {inner ? power : 0.0, inner ? 0.0 : power, 0.0, drag},
                        ball_.share(), network_.oil.flows());
    (inner ? of.inner : of.outer) = conductance;
    shares.push_back({c.ball, c.ring, double(c.groove()), of});
  }
  bearing::each_cage_loss(
      lmp, *pair_, [&](bearing::tag_t first, bearing::tag_t second, int i, double loss, double) {
        const int type = atom->type[i];
        if (type == bearing_->balls || type == bearing_->cage)
          shares.push_back({first, second, -1.0, {{0.0, loss}}});
      });
  shares = bearing::gather_all(shares, world);
  std::sort(shares.begin(), shares.end(), [](const Share &a, const Share &b) {
    return std::tie(a.first, a.second, a.place) < std::tie(b.first, b.second, b.place);
  });
  HeatPass sum, each;
  for (const Share &s : shares) sum.add(s.of);
  each.add(sum, 1.0 / bearings_);
  return each;
}
