// SPDX-License-Identifier: GPL-2.0-or-later
// Spheres for the host: each is made by the rank in whose part of the box it lies. All ranks give
// the same list.
#ifndef BEARING_NEW_ATOMS_H
#define BEARING_NEW_ATOMS_H

#include "bearing_compat.h"

#include <vector>

#if BEARING_IS_LIGGGHTS
#include "atom_vec.h"
#else
#include "library.h"    // the wheel has no atom_vec.h; the C interface makes atoms as well
#endif

namespace bearing {

struct NewAtom {
  tag_t tag;    // rising by one
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

}    // namespace bearing

#endif
