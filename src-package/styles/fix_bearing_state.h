// SPDX-License-Identifier: GPL-2.0-or-later
// Internal fix of the bearing pair styles. From step to step and in restart files, it stores the
// state of balls and rings, except for position and velocity, on any number of ranks. It is created
// by the pair style, so users do not have to define it.
//
//   ball  contact state, by ring and groove; orientation, if a profile needs it
//   ring  axis, spin angle, origin, imposed tilt
//   all   force and torque at the end of a run
//   run   simulated time
//
// The first half kick of the next run, or of a continued run, uses these forces, which are bitwise
// identical to those of the previous step, instead of forces at full-step velocities.
#ifdef FIX_CLASS
FixStyle(bearing/state,FixBearingState)
#else
#ifndef LMP_FIX_BEARING_STATE_H
#define LMP_FIX_BEARING_STATE_H

#include "../contacts/ring_motion.h"
#include "../core/numbers/quaternion.h"
#include "../core/raceway/raceway_physics.h"
#include "bearing_compat.h"
#include "simulated_time.h"

#include <utility>
#include <vector>

namespace bearing {

// Hooks of the pair style that can only be called from a fix. They are called by fix bearing/state.
class PairHooks {
 public:
  virtual raceway::Vec3 axis() const = 0;    // axis of the bearings at the start
  virtual void indices_changed() = 0;        // called after a neighbour build
  virtual void forces_known() = 0;           // called at the end of the set-up of a run
  virtual void after_step() = 0;             // called every tenth step
  virtual void run_done() = 0;

 protected:
  ~PairHooks() = default;
};

}    // namespace bearing

namespace LAMMPS_NS {

class FixBearingState : public Fix {
 public:
  struct PerAtom;
  static constexpr const char *fixed_id = "BEARING_STATE";
  static constexpr int max_grooves = 4;    // largest number of grooves per ball that have a contact
                                           // state
  static constexpr int room = raceway::most_states;

  using RingMotion = bearing::RingMotion;

  FixBearingState(class LAMMPS *, int, char **);
  ~FixBearingState() override;
  int setmask() override;
  void setup_pre_neighbor() override { pre_neighbor(); }
  void pre_neighbor() override;
  void setup(int) override;
  void end_of_step() override;
  void post_run() override;

  const raceway::Vec3 &axis(int i) const { return per_atom_[i].ring.axis; }
  double angle(int i) const { return per_atom_[i].ring.angle; }    // rad, also for ghosts
  RingMotion &ring(int i) { return per_atom_[i].ring; }
  // Rotation from the body axes of a ball to axes of which the third is the bearing axis.
  raceway::Quaternion &turn(int i) { return per_atom_[i].turn; }
  // Returns the contact state of a ball in a groove. The state of a new contact starts at 0.
  double *kept(int i_ball, bearing::tag_t ring, int groove);
  void forward_axes();    // sends the axes, angles and owners of rings to ghosts, once per step
  int owner(int i) const
  {
    return i < atom->nlocal ? comm->me : per_atom_[i].owner;
  }    // rank; for ghosts, as of the last forward_axes()
  // The pair style moves these contents to a new fix, which is the last one again.
  struct Contents {
    std::vector<PerAtom> per_atom;
    bearing::SimulatedTime time;
  };
  Contents release() { return {std::move(per_atom_), time_}; }
  void take(Contents &&of)
  {
    per_atom_ = std::move(of.per_atom);
    time_ = of.time;
  }
  void continue_time() const { time_.go_on(*update); }
  // Returns true if this run begins at the time at which the last one ended.
  bool time_continues() const { return time_.goes_on(*update); }
  // Called by the pair style when it takes over the state, and by its destructor. A pair style that
  // replaces another one takes over the motion of the bodies; its contacts start anew.
  void serve(bearing::PairHooks &pair) { pair_ = &pair; }
  void part_from_pair();
  // Returns true if bearings have been created about another axis than that of the pair style.
  bool has_another_axis() const;
  void forget_contacts();
  // Causes the next run to begin with the forces of its set-up instead of those of the last step.
  void forget_forces()
  {
    for (PerAtom &p : per_atom_) p.saved = false;
  }
  // Stops with an error if atoms have other numbers than in the last run, because contacts, pockets
  // and columns of output are stored by number.
  void check_numbers() const;
  // Called in the set-up of a run. Afterwards, the axes and angles of rings are assumed to be
  // constant unless a fix calls follow_axes().
  void keep_axes() { axes_turn_ = false; }
  void follow_axes() { axes_turn_ = true; }
  void ghost_reach(double cut)
  {
    if (cut > reach_) reach_ = cut;
  }

  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;
  int BRG_PACK_FORWARD(int, int *, double *, int, int *) override;
  void BRG_UNPACK_FORWARD(int, int, double *) override;
#if BEARING_IS_LIGGGHTS
  double extend_cut_ghost() override;
#endif
  double memory_usage() override;

  struct PerAtom {
    int n_grooves = 0;
    bearing::tag_t kept_ring[max_grooves] = {};
    int kept_groove[max_grooves] = {};
    double kept[max_grooves][room] = {};
    RingMotion ring;
    raceway::Quaternion turn;
    bool saved = false;    // true if force and torque are those at the end of the last run
    double force[3] = {}, torque[3] = {};
    bearing::tag_t tag = 0;    // number of the atom at the end of the last run; 0: it is new
    int owner = 0;             // rank that owns the atom if it is a ghost
  };

 private:
  static constexpr int packed_size = 2 + (2 + room) * max_grooves + 10 + 4 + 8;

  template <class List> static void keep(List &, PerAtom &);
  void save_forces();
  void hold(int atoms);    // makes room for the states of as many atoms

  std::vector<PerAtom> per_atom_;
  bearing::SimulatedTime time_;
  bearing::PairHooks *pair_;
  double reach_ = 0.0;
  bigint axes_sent_ = -1;    // step in which the axes were last sent
  bool axes_turn_ = true;    // true if a ring may tilt in this run or its angle is needed
};

}    // namespace LAMMPS_NS

#endif
#endif
