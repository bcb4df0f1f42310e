// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_state.h"

#include "../core/numbers/number_list.h"
#include "fixes.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace FixConst;
using raceway::Vec3;

// Stands for a pair style that has been deleted, while the state waits for the next one.
struct NoPair : bearing::PairHooks {
  Vec3 axis() const override { return {0.0, 0.0, 1.0}; }
  void indices_changed() override {}
  void forces_known() override {}
  void after_step() override {}
  void run_done() override {}
};

FixBearingState::FixBearingState(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), pair_(dynamic_cast<bearing::PairHooks *>(lmp->force->pair))
{
  if (!pair_) BRG_ALL("fix bearing/state needs pair_style bearing/hertz or bearing/ehd before it");
  restart_peratom = restart_global = 1;
  create_attribute = 1;
  comm_forward = 5;
  nevery = 10;    // number of steps between checks of the contacts
  BRG_SET_MAXEXCHANGE(packed_size);
  grow_arrays(atom->nmax);
  hold(atom->nlocal + atom->nghost);
  atom->add_callback(0);
  atom->add_callback(1);
  for (int i = 0; i < atom->nlocal; ++i) set_arrays(i);
  BRG_ARRAYS_ARE_SET();
}

FixBearingState::~FixBearingState()
{
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
}

void FixBearingState::part_from_pair()
{
  static NoPair none;
  pair_ = &none;
}

bool FixBearingState::has_another_axis() const
{
  int other = 0;    // the axis of a ring may tilt, but not by 60 degrees
  for (int i = 0; i < atom->nlocal; ++i) other |= dot(axis(i), pair_->axis()) < 0.5;
  MPI_Allreduce(MPI_IN_PLACE, &other, 1, MPI_INT, MPI_MAX, world);
  return other;
}

// The forces of the last step are those of the contacts that are forgotten.
void FixBearingState::forget_contacts()
{
  for (PerAtom &p : per_atom_) {
    p.n_grooves = 0;
    p.saved = false;
  }
}

void FixBearingState::check_numbers() const
{
  bearing::tag_t was = 0;
  for (int i = 0; i < atom->nlocal; ++i)
    if (const bearing::tag_t tag = per_atom_[i].tag; tag != atom->tag[i]) was = std::max(was, tag);
  double last = static_cast<double>(was);
  MPI_Allreduce(MPI_IN_PLACE, &last, 1, MPI_DOUBLE, MPI_MAX, world);
  if (last > 0.0)
    BRG_ALL("pair_style bearing: atom " + std::to_string(static_cast<long>(last)) +
            " of the last run has another number now, but contacts are stored by the numbers of "
            "atoms: use 'compress no' in delete_atoms, and do not reset atom IDs between runs");
}

int FixBearingState::setmask() { return PRE_NEIGHBOR | END_OF_STEP | POST_RUN; }

void FixBearingState::pre_neighbor()
{
  hold(atom->nlocal + atom->nghost);
  pair_->indices_changed();
  axes_sent_ = -1;    // the ghosts may be different atoms now
}

// Runs after all other fixes. If this run continues the previous one, it restores the forces of the
// last step of that run.
void FixBearingState::setup(int)
{
  bearing::require_order(lmp, *modify->fix[modify->nfix - 1], *this,
                         "it restores the forces of the previous step after every other set-up");
  int continues = time_continues();
  for (int i = 0; i < atom->nlocal; ++i)
    if (!per_atom_[i].saved) continues = 0;
  MPI_Allreduce(MPI_IN_PLACE, &continues, 1, MPI_INT, MPI_MIN, world);
  for (int i = 0; i < atom->nlocal; ++i) {
    if (continues)
      for (int k = 0; k < 3; ++k) {
        atom->f[i][k] = per_atom_[i].force[k];
        atom->torque[i][k] = per_atom_[i].torque[k];
      }
    per_atom_[i].saved = false;
  }
  pair_->forces_known();
}

void FixBearingState::end_of_step()
{
  if (update->ntimestep % nevery == 0) pair_->after_step();
}

void FixBearingState::save_forces()
{
  for (int i = 0; i < atom->nlocal; ++i) {
    PerAtom &p = per_atom_[i];
    p.saved = true;
    p.tag = atom->tag[i];
    for (int k = 0; k < 3; ++k) {
      p.force[k] = atom->f[i][k];
      p.torque[k] = atom->torque[i][k];
    }
  }
}

void FixBearingState::post_run()
{
  save_forces();
  time_.run_done(*update);
  pair_->run_done();
}

double *FixBearingState::kept(int i, bearing::tag_t ring, int groove)
{
  PerAtom &p = per_atom_[i];
  for (int k = 0; k < p.n_grooves; ++k)
    if (p.kept_ring[k] == ring && p.kept_groove[k] == groove) return p.kept[k];
  if (p.n_grooves == max_grooves)
    BRG_ONE("ball " + std::to_string(atom->tag[i]) + " has met more than " +
            std::to_string(max_grooves) + " grooves");
  const int n = p.n_grooves++;
  p.kept_ring[n] = ring;
  p.kept_groove[n] = groove;
  std::fill(p.kept[n], p.kept[n] + room, 0.0);
  return p.kept[n];
}

// Called by the rails and then by the pair style; only the first call in a step sends data. If no
// fix rotates the axes of rings, they are sent only after the ghosts have changed.
void FixBearingState::forward_axes()
{
  if (comm->nprocs == 1 || axes_sent_ == update->ntimestep || (axes_sent_ >= 0 && !axes_turn_))
    return;
  axes_sent_ = update->ntimestep;
  BRG_FORWARD_FIX(this);
}

// Hosts reserve memory for thousands of atoms, of which a bearing has a few dozen. Memory that is
// not used is not touched.
void FixBearingState::grow_arrays(int n) { per_atom_.reserve(n); }

void FixBearingState::hold(int n)
{
  if (static_cast<size_t>(n) > per_atom_.size()) per_atom_.resize(n);
}

void FixBearingState::copy_arrays(int i, int j, int)
{
  hold(std::max(i, j) + 1);
  per_atom_[j] = per_atom_[i];
}

void FixBearingState::set_arrays(int i)
{
  hold(i + 1);
  per_atom_[i] = PerAtom();
  per_atom_[i].ring.axis = pair_->axis();
  per_atom_[i].ring.origin = Vec3::from(atom->x[i]);
}

template <class List> void FixBearingState::keep(List &list, PerAtom &p)
{
  list(p.n_grooves);
  for (int k = 0; k < max_grooves; ++k) list(p.kept_ring[k], p.kept_groove[k], p.kept[k]);
  list(p.ring.axis, p.ring.origin, p.ring.angle, p.ring.tilt, p.ring.step, p.turn, p.saved, p.force,
       p.torque, p.tag);
}

int FixBearingState::pack_exchange(int i, double *buf)
{
  bearing::NumberWriter list;
  keep(list, per_atom_[i]);
  return list.copy_to(buf);
}

int FixBearingState::unpack_exchange(int i, double *buf)
{
  hold(i + 1);
  bearing::NumberReader list(buf);
  keep(list, per_atom_[i]);
  return list.count();
}

void FixBearingState::write_restart(FILE *fp)
{
  bearing::NumberWriter list;
  list(bearing::SimulatedTime::of(*update));
  if (comm->me == 0) list.write(fp);
}

void FixBearingState::restart(char *buf)
{
  bearing::SimulatedTime::State time;
  bearing::NumberReader{buf}(time);
  time_.read(*update, time);
}

int FixBearingState::pack_restart(int i, double *buf)
{
  // during a run the forces of this step are still available; between runs they have been saved
  if (update->whichflag != 0 && i == 0) save_forces();
  const int m = 1 + pack_exchange(i, buf + 1);
  buf[0] = m;
  return m;
}

void FixBearingState::unpack_restart(int i, int nth)
{
  double **extra = atom->extra;
  int m = 0;
  for (int k = 0; k < nth; ++k) m += static_cast<int>(extra[i][m]);
  const int size = static_cast<int>(extra[i][m]);
  const int read = 1 + unpack_exchange(i, &extra[i][m + 1]);
  if (size != read)
    BRG_ONE("the restart file has " + std::to_string(size) + " numbers of atom " +
            std::to_string(atom->tag[i]) + ", but this program reads " + std::to_string(read) +
            ": it was written by a version with different contact laws");
}

int FixBearingState::size_restart(int) { return packed_size; }
int FixBearingState::maxsize_restart() { return packed_size; }

int FixBearingState::BRG_PACK_FORWARD(int n, int *list, double *buf, int, int *)
{
  for (int k = 0; k < n; ++k) {
    per_atom_[list[k]].ring.axis.to(buf + 5 * k);
    buf[5 * k + 3] = owner(list[k]);
    buf[5 * k + 4] = per_atom_[list[k]].ring.angle;
  }
  return BRG_COMM_RETURN(5 * n, 5);
}

void FixBearingState::BRG_UNPACK_FORWARD(int n, int first, double *buf)
{
  hold(first + n);
  for (int k = 0; k < n; ++k) {
    per_atom_[first + k].ring.axis = Vec3::from(buf + 5 * k);
    per_atom_[first + k].owner = static_cast<int>(buf[5 * k + 3]);
    per_atom_[first + k].ring.angle = buf[5 * k + 4];
  }
}

#if BEARING_IS_LIGGGHTS
// LIGGGHTS sends ghosts only from a slab of half this width (plus skin/2). The factor 2 makes the
// slab wide enough to include the centres of the rings.
double FixBearingState::extend_cut_ghost() { return 2.0 * reach_; }
#endif

double FixBearingState::memory_usage() { return per_atom_.capacity() * sizeof(PerAtom); }
