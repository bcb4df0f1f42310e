// SPDX-License-Identifier: GPL-2.0-or-later
#include "step_check.h"

#include "../core/laws/step_limit.h"
#include "../core/settings/arguments.h"
#include "bearing_compat.h"

using namespace LAMMPS_NS;
using raceway::FilmBranches;
using raceway::verlet_step_limit;

namespace bearing {

std::string StepLimit::why() const
{
  static const char *names[] = {"the contact spring at 1 um overlap", "the contact spring",
                                "the film damper", "the tangential spring and dashpot",
                                "a cage contact"};
  std::string s = names[cause];
  if (cause != unloaded)
    s += " of atom " + std::to_string(ball) + " (" + text(stiffness) + " N/m, " + text(damping) +
         " N s/m)";
  return s;
}

static void keep_smaller(StepLimit &limit, double k, double c, double m, int cause, tag_t ball,
                         const FilmBranches &film = {})
{
  const double step = verlet_step_limit(k, c, m, film);
  if (step >= limit.step) return;
  // the damper is the cause if the limit due to the spring alone would be more than twice the step
  if (cause == StepLimit::spring && verlet_step_limit(k, 0.0, m) > 2.0 * step)
    cause = StepLimit::film_damper;
  limit = StepLimit{step, cause, ball, k, c};
}

// Returns the slope (N s/m) of the smoothed friction at zero sliding, where it is steepest. The
// slope at the current sliding speed would hide an instability.
static double steepest_friction(const raceway::ContactState &c)
{
  return c.v_0 > 0.0 ? c.mu * c.normal / c.v_0 : c.ct;
}

StepLimit step_limit(LAMMPS *lmp, const ContactTable &table)
{
  StepLimit limit;
  const std::vector<RacewayContact> &rows = table.raceway;
  const double *rmass = lmp->atom->rmass;
  double unloaded = HUGE_VAL;
  for (size_t i = 0; i < rows.size();) {
    const RacewayContact &first = rows[i];
    const double m = rmass[first.i_ball];
    double k = 0.0, c = 0.0, kt = 0.0, ct = 0.0, k0 = 0.0;
    FilmBranches film;
    for (; i < rows.size() && rows[i].ball == first.ball; ++i) {
      k0 += 1.5 * rows[i].raceway->law.radial().K * 1e-3;    // factor sqrt(1 um) in m^0.5
      if (!rows[i].live) continue;
      k += rows[i].state.stiffness;
      c += rows[i].state.damping;
      film.add(rows[i].state.film_stiffness, rows[i].state.film_rate);
      kt += rows[i].state.kt;
      ct += steepest_friction(rows[i].state);
    }
    keep_smaller(limit, k, c, m, StepLimit::spring, first.ball, film);
    keep_smaller(limit, kt, ct, 2.0 / 7.0 * m, StepLimit::tangential, first.ball);
    unloaded = std::fmin(unloaded, verlet_step_limit(k0, 0.0, m));
  }
  for (const SphereContact &s : table.sphere)
    if (s.stiffness > 0.0)
      keep_smaller(limit, s.stiffness, s.damping, s.mass, StepLimit::cage, s.tag_i);
  // a ball and the cage vibrate against each other on the same spring, and several balls may press
  // on the cage
  for (const PocketRow &p : table.pocket)
    if (p.stiffness > 0.0)
      keep_smaller(limit, 2.0 * p.stiffness, 2.0 * p.damping, p.mass, StepLimit::cage, p.ball);
  if (unloaded < limit.step) limit = StepLimit{unloaded, StepLimit::unloaded, 0, 0.0, 0.0};

  // the rank with the smallest step broadcasts its limit (on a tie, the lowest of these ranks does)
  struct {
    double step;
    int rank;
  } mine = {limit.step, lmp->comm->me}, best;
  MPI_Allreduce(&mine, &best, 1, MPI_DOUBLE_INT, MPI_MINLOC, lmp->world);
  MPI_Bcast(&limit, sizeof limit, MPI_BYTE, best.rank, lmp->world);
  return limit;
}

}    // namespace bearing
