// SPDX-License-Identifier: GPL-2.0-or-later
// Exchanges the state of flexible shafts between their fixes and the bearings whose home is on this
// rank.
#include "../ranks/gather.h"
#include "fix_bearing_implicit_solver.h"
#include "fix_bearing_shaft.h"

using namespace LAMMPS_NS;
using raceway::BearingModel;

// Loads the state from the fixes into the bearings.
void FixBearingImplicit::load_bends(int p)
{
  int shaft = 0;
  for (const BearingModel::Shaft &s : solver_->bearings.model(p).shafts) {
    if (const FixBearingShaft *bends = rings_[s.mover]->bending()) {
      solver_->own[p].integrator->set_bend(shaft, bends->bend_program());
      solver_->own[p].integrator->load_bend(shaft, bends->bend());
    }
    ++shaft;
  }
}

// Stores the state of the bearings in the fixes on all ranks.
void FixBearingImplicit::store_bends()
{
  for (int k = 0; k < static_cast<int>(rings_.size()); ++k) {
    FixBearingShaft *bends = rings_[k]->bending();
    if (!bends) continue;
    raceway::BendState state;
    for (int p = 0; p < solver_->bearings.size(); ++p) {
      int shaft = 0;
      for (const BearingModel::Shaft &s : solver_->bearings.model(p).shafts) {
        if (s.mover == k) state = solver_->own[p].integrator->stored_bend(shaft);
        ++shaft;
      }
    }
    bends->set_bend(
        {bearing::gather_all(state.place, world), bearing::gather_all(state.rate, world)});
  }
}
