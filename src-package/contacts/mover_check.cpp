// SPDX-License-Identifier: GPL-2.0-or-later
#include "mover_check.h"

using namespace LAMMPS_NS;

namespace bearing {

// Integrators of the host for points, such as nve or nve/limit.
static bool of_points(const std::string &style)
{
  const std::string start = style.substr(0, 3);
  return (start == "nve" || start == "nvt" || start == "npt" || start == "nph") &&
         style.find("sphere") == std::string::npos;
}

// Frozen atoms are meant to stay.
static bool moves(const Fix &f) { return f.time_integrate || strcmp(f.style, "freeze") == 0; }

static bool turns(const Fix &f) { return moves(f) && !of_points(f.style); }

static bool touches(const Fix &f) { return strcmp(f.style, "bearing/grains") == 0; }

// Returns the atoms of the given types that are in the group of no fix for which `serves` is true.
static Lacking lacking(LAMMPS *lmp, const std::function<bool(int)> &type, bool serves(const Fix &))
{
  const Atom &atom = *lmp->atom;
  int served = 0;
  for (int k = 0; k < lmp->modify->nfix; ++k)
    if (serves(*lmp->modify->fix[k])) served |= lmp->modify->fix[k]->groupbit;
  long count = 0;
  double first = HUGE_VAL;
  for (int i = 0; i < atom.nlocal; ++i)
    if (type(atom.type[i]) && !(atom.mask[i] & served)) {
      ++count;
      first = std::min(first, static_cast<double>(atom.tag[i]));
    }
  MPI_Allreduce(MPI_IN_PLACE, &count, 1, MPI_LONG, MPI_SUM, lmp->world);
  MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_DOUBLE, MPI_MIN, lmp->world);
  return {count, first};
}

Lacking unmoved(LAMMPS *lmp, const std::function<bool(int)> &type)
{
  return lacking(lmp, type, moves);
}

void MoverCheck::look(LAMMPS *lmp, const PairCoefficients &types, int implicit)
{
  for (int k = 0; k < lmp->modify->nfix; ++k) {
    const Fix &f = *lmp->modify->fix[k];
    if (!f.time_integrate || strncmp(f.style, "bearing/", 8) == 0) continue;
    for (int i = 0; i < lmp->atom->nlocal; ++i)
      if ((lmp->atom->mask[i] & f.groupbit) && !(lmp->atom->mask[i] & implicit) &&
          types.is_ring(lmp->atom->type[i]))
        lmp->error->one(FLERR, BRG_TEXT("fix " + std::string(f.id) + " " + f.style +
                                        " moves ring atom " + std::to_string(lmp->atom->tag[i]) +
                                        ": only fix bearing/ring, bearing/shaft and "
                                        "bearing/implicit move rings"));
  }
  const auto ball = [&](int t) { return types.is_ball(t); };
  const auto grain = [&](int t) { return types.is_grain(t); };
  const auto body = [&](int t) { return types.is_named(t) && !types.is_ring(t); };
  const std::string nve = "their group needs fix nve/sphere",
                    any = "their group needs fix bearing/implicit, bearing/verlet or nve/sphere";
  const Lacking bodies = unmoved(lmp, body), grains = unmoved(lmp, grain);
  warn(lmp, 0, bodies, "moves balls or cage balls", any);
  warn(lmp, 1, grains, "moves grains", nve);
  if (bodies.count == 0) warn(lmp, 2, lacking(lmp, ball, turns), "turns balls", any);
  if (grains.count == 0) warn(lmp, 3, lacking(lmp, grain, turns), "turns grains", nve);
  warn(lmp, 4, lacking(lmp, grain, touches), "computes the contacts of grains",
       "their group needs fix bearing/grains");
}

void MoverCheck::warn(LAMMPS *lmp, int which, const Lacking &of, const std::string &what,
                      const std::string &need)
{
  if (of.count > 0 && of.count != warned_[which] && lmp->comm->me == 0)
    lmp->error->warning(FLERR,
                        BRG_TEXT("pair_style bearing: no fix " + what + " (" +
                                 std::to_string(of.count) + " atoms, the first is " +
                                 std::to_string(static_cast<long>(of.first)) + "): " + need));
  warned_[which] = of.count;
}

}    // namespace bearing
