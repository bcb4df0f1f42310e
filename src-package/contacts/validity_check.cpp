// SPDX-License-Identifier: GPL-2.0-or-later
#include "validity_check.h"

#include "../deck/arguments.h"

using namespace LAMMPS_NS;
using raceway::Validity;

namespace bearing {

void ValidityCheck::look(const ContactTable &table, bool film)
{
  for (const RacewayContact &c : table.raceway)
    if (c.live && c.state.overlap > 0.0)
      found_.note(static_cast<double>(c.ball), c.raceway->law.at(c.state.cos_angle),
                  c.state.overlap, c.state.load, c.state.entrainment, c.state.lambda, film);
}

void ValidityCheck::report(LAMMPS *lmp)
{
  for (int k = 0; k < Validity::N; ++k) {
    const Validity::Rule &rule = Validity::rule(k);
    double worst = 0.0, ball = 0.0;
    MPI_Allreduce(&found_.worst[k], &worst, 1, MPI_DOUBLE, MPI_MAX, lmp->world);
    const double mine = found_.worst[k] == worst ? found_.ball[k] : 0.0;
    MPI_Allreduce(&mine, &ball, 1, MPI_DOUBLE, MPI_MAX, lmp->world);
    if (!(worst > rule.most) || said_[k]) continue;
    said_[k] = true;
    if (lmp->comm->me == 0)
      lmp->error->warning(FLERR,
                          BRG_TEXT("beyond validity: " + std::string(rule.value) + " of ball " +
                                   std::to_string(static_cast<long long>(ball)) + " is up to " +
                                   text(worst) + rule.unit + "; " + rule.limit + " " +
                                   text(rule.most) + rule.unit));
  }
  found_ = Validity();
}

}    // namespace bearing
