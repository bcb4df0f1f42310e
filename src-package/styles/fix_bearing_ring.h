// SPDX-License-Identifier: GPL-2.0-or-later
// fix bearing/ring: moves the ring atoms of a group; every degree of freedom free, fixed or driven.
#ifdef FIX_CLASS
FixStyle(bearing/ring,FixBearingRing)
#else
#ifndef LMP_FIX_BEARING_RING_H
#define LMP_FIX_BEARING_RING_H

#include "../deck/driven_value.h"
#include "../implicit/ring_program.h"
#include "bearing_compat.h"
#include "fix_bearing_state.h"

namespace LAMMPS_NS {

class PairBearingHertz;

class FixBearingRing : public Fix {
 public:
  FixBearingRing(class LAMMPS *, int, char **);
  ~FixBearingRing() override;
  int setmask() override;
  void init() override;
  void setup(int) override;
  void initial_integrate(int) override;
  void post_force(int) override;
  void final_integrate() override;
  double compute_vector(int) override;
  double compute_array(int, int) override;
  void write_restart(FILE *) override;
  void restart(char *) override;

  // For fix bearing/implicit, which moves the rings of its group itself.
  enum Mode { fixed, free, speed, position };    // as raceway::Freedom
  enum {
    SPIN_DOF = 5,
    N_DOF = 6
  };    // x, y, z, tilt about the first and second axis across, spin about the axis
  bool moves(int i) const { return atom->mask[i] & groupbit; }
  bool tilts() const { return mode_[3] != fixed || mode_[4] != fixed; }
  void begin_step();
  // What an atom-style variable gives a ring for itself: the number of a degree of freedom, FORCE +
  // or MOMENT + a lab axis.
  enum { FORCE = N_DOF, MOMENT = FORCE + 3, N_VALUE = MOMENT + 3 };
  struct OwnValue {
    int which;
    double value;
  };
  std::vector<OwnValue> own_values(int i) const;
  // of this step for a ring with these values, in names with the bearing axis third
  raceway::RingProgram program(const std::vector<OwnValue> &) const;

  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  double memory_usage() override;

  enum Report {    // columns of f_ID[...], from 1
    DX,
    DY,
    DZ,
    VX,
    VY,
    VZ,
    TILT1,
    TILT2,
    SPIN,
    ANGLE,
    FX,
    FY,
    FZ,
    MX,
    MY,
    MZ,
    FRICTION_TORQUE,
    N_REPORT
  };

 private:
  struct Values {
    double of[N_VALUE] = {};
  };    // speeds, or positions at the end of the step; loads without the ramp
  void parse(int, char **);
  void read_freedom(class bearing::Arguments &, const std::string &name, int dof);
  void find_own_values();
  void evaluate(int first, int last);
  double ramp(double time) const;
  Values values(int i) const;
  void turn(FixBearingState::RingMotion &, raceway::Vec3 &w, const double *target) const;
  void kick();
  void tilt_of(const raceway::Vec3 &e, double *tilt) const;
  void gather_reports();

  PairBearingHertz *pair_;
  FixBearingState *state_ = nullptr;
  int mode_[N_DOF] = {};
  bearing::DrivenValue value_[N_VALUE];
  double mass_ = 0.0;
  raceway::RingInertia inertia_;
  double ramp_time_ = 0.0, time_ = 0.0;
  int across_[2], along_;           // lab axes across and along the bearing axis
  Values now_, before_;             // of all rings; in the step before
  std::vector<int> own_;            // which values each ring has for itself
  std::vector<Values> per_ring_;    // these, by local atom
  bool called_back_ = false;        // the host moves per_ring_ with the atoms
  bool by_another_ = false;         // a fix bearing/implicit integrates these rings
  std::vector<int> tags_;           // of the rings, rising
  std::vector<raceway::Vec3> contact_force_,
      contact_moment_;    // per local atom of the group, last step
  std::vector<double> report_;
  bigint reported_ = -1;
};

}    // namespace LAMMPS_NS

#endif
#endif
