// SPDX-License-Identifier: GPL-2.0-or-later
#include "validity_check.h"

#include "../core/settings/arguments.h"
#include "bearing_compat.h"

using namespace LAMMPS_NS;
using raceway::Validity;

namespace bearing {

void ValidityCheck::look(const ContactTable &table, const int *mask, bool film)
{
  for (const RacewayContact &c : table.raceway) {
    if (!c.live || !(c.state.compression > 0.0)) continue;
    found_.note(static_cast<double>(c.ball), c.raceway->law.at(c.state.cos_angle),
                c.raceway->model.film, c.state.compression, c.state.film_load, c.state.entrainment,
                c.state.lambda, film);
    if (!shoulders_.empty()) look_at_shoulders(c, mask[c.i_ball]);
  }
}

void ValidityCheck::look_at_shoulders(const RacewayContact &c, int mask)
{
  const raceway::Groove &g = c.raceway->groove;
  for (const OfGroup &of : shoulders_) {
    const bool inner = g.side == raceway::Side::inner;
    if (!(mask & of.groupbit) ||
        !((inner ? of.model.inner_shoulder : of.model.outer_shoulder) > 0.0))
      continue;
    const double a = c.raceway->law.at(c.state.cos_angle).a * std::sqrt(c.state.compression);
    found_.note_reach(static_cast<double>(c.ball), g, of.model.groove_depth(g), c.state.cos_angle,
                      a);
  }
}

void ValidityCheck::report(LAMMPS *lmp, bool capacitance)
{
  for (int k = 0; k < Validity::N; ++k) {
    if (k == Validity::CONDUCTS && !capacitance) continue;
    const Validity::Rule &rule = Validity::rule(k);
    double worst = 0.0, ball = 0.0;
    MPI_Allreduce(&found_.worst[k], &worst, 1, MPI_DOUBLE, rule.below ? MPI_MIN : MPI_MAX,
                  lmp->world);
    const double mine = found_.worst[k] == worst ? found_.ball[k] : 0.0;
    MPI_Allreduce(&mine, &ball, 1, MPI_DOUBLE, MPI_MAX, lmp->world);
    if (!Validity::worse(k, worst, rule.bound) || said_[k]) continue;
    said_[k] = true;
    const std::string unit = rule.unit[0] ? std::string(" ") + rule.unit : "";
    if (lmp->comm->me == 0)
      lmp->error->warning(FLERR,
                          BRG_TEXT("beyond validity: " + std::string(rule.value) + " of ball " +
                                   std::to_string(static_cast<long long>(ball)) +
                                   (rule.below ? " is down to " : " is up to ") + text(worst) +
                                   unit + "; " + rule.limit + " " + text(rule.bound) + unit));
  }
  found_ = Validity();
}

}    // namespace bearing
