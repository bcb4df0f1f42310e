// SPDX-License-Identifier: GPL-2.0-or-later
// Creates spheres in the host, each on the rank whose subdomain contains it. All ranks pass the
// same list.
#pragma once

#include "bearing_compat.h"

#include <cmath>
#include <limits>
#include <vector>

#if BEARING_IS_LIGGGHTS
#include "atom_vec.h"
#else
#include "library.h"    // the wheel does not contain atom_vec.h, so atoms are created through the C
                        // interface
#endif

namespace bearing {

struct NewAtom {
  tag_t tag;    // consecutive
  int type;
  double x[3], v[3], omega[3];
  double radius, mass;
};

inline void make_atoms(LAMMPS_NS::LAMMPS *lmp, const std::vector<NewAtom> &list)
{
  LAMMPS_NS::Atom *atom = lmp->atom;
  const int first = atom->nlocal;
#if BEARING_IS_LIGGGHTS
  const LAMMPS_NS::Domain &box = *lmp->domain;
  for (const NewAtom &a : list) {
    bool mine = true;
    for (int k = 0; k < 3; ++k) mine = mine && a.x[k] >= box.sublo[k] && a.x[k] < box.subhi[k];
    if (!mine) continue;
    double x[3] = {a.x[0], a.x[1], a.x[2]};
    atom->avec->create_atom(a.type, x);
    atom->tag[atom->nlocal - 1] = a.tag;
  }
#else
  std::vector<tag_t> tag;
  std::vector<int> type;
  std::vector<double> x;
  for (const NewAtom &a : list) {
    tag.push_back(a.tag);
    type.push_back(a.type);
    x.insert(x.end(), a.x, a.x + 3);
  }
  lammps_create_atoms(lmp, static_cast<int>(list.size()), tag.data(), type.data(), x.data(),
                      nullptr, nullptr, 0);
#endif
  for (int i = first; i < atom->nlocal; ++i) {
    const NewAtom &a = list[atom->tag[i] - list.front().tag];
    atom->radius[i] = a.radius;
    atom->rmass[i] = a.mass;
#if BEARING_IS_LIGGGHTS
    atom->density[i] =
        a.mass / (4.0 / 3.0 * 3.14159265358979323846 * a.radius * a.radius * a.radius);
#endif
    for (int k = 0; k < 3; ++k) {
      atom->v[i][k] = a.v[k];
      atom->omega[i][k] = a.omega[k];
    }
  }
}

// Updates the host's map from tags to atoms after this rank has created the atoms whose local
// indices start at `first`. `atoms_before` is the previous number of atoms on all ranks, and `top`
// is the current largest tag. Must be called on all ranks.
inline void map_atoms(LAMMPS_NS::LAMMPS *lmp, int first, double atoms_before, tag_t top)
{
  LAMMPS_NS::Atom &atom = *lmp->atom;
#if BEARING_IS_LIGGGHTS
  // If the map were rebuilt for every bearing, the total time would be quadratic in the number of
  // bearings. The map is therefore built for twice as many tags, and afterwards only the new atoms
  // are added. The host also has an array that is indexed by local atom. When the map is built,
  // this array has 1000 entries more than there are atoms (EXTRA in the host's atom_map.cpp), and
  // none on a rank without atoms.
  constexpr double spare = 1000.0;
  const bool array = atom.map_style == 1;
  int mine = array && atom.nghost == 0 && (first > 0 || atom.nlocal == 0), all;
  MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MIN, lmp->world);
  const double atoms = static_cast<double>(atom.natoms);
  if (all && top <= atom.map_tag_max &&
      std::floor(atoms_before / spare) == std::floor(atoms / spare)) {
    for (int i = first; i < atom.nlocal; ++i) atom.map_one(atom.tag[i], i);
    return;
  }
  // the host determines the largest tag from its atoms
  const bool twice = array && atom.nlocal > 0 && top < std::numeric_limits<tag_t>::max() / 2;
  const tag_t own = twice ? atom.tag[atom.nlocal - 1] : 0;
  if (twice) atom.tag[atom.nlocal - 1] = 2 * top;
  atom.nghost = 0;
  atom.map_init();
  if (twice) atom.tag[atom.nlocal - 1] = own;
#else
  (void)first;
  (void)atoms_before;
  (void)top;
  atom.nghost = 0;
  atom.map_init();
#endif
  atom.map_set();
}

}    // namespace bearing
