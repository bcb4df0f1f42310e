// SPDX-License-Identifier: GPL-2.0-or-later
// fix bearing/ring: moves the ring atoms of a group; every degree of freedom free, fixed or driven.
#ifdef FIX_CLASS
FixStyle(bearing/ring,FixBearingRing)
#else
#ifndef LMP_FIX_BEARING_RING_H
#define LMP_FIX_BEARING_RING_H

#include "../implicit/ring_program.h"
#include "bearing_compat.h"
#include "driven_value.h"
#include "fix_bearing_state.h"

namespace LAMMPS_NS {

class PairBearingHertz;

class FixBearingRing : public Fix {
 public:
  FixBearingRing(class LAMMPS *, int, char **);
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
  enum { SPIN_DOF = 5, N_DOF = 6 };    // x, y, z, tilt about the first and second axis across, spin about the axis
  bool moves(int i) const { return atom->mask[i] & groupbit; }
  bool tilts() const { return dof_[3].mode != fixed || dof_[4].mode != fixed; }
  void begin_step();
  raceway::RingProgram program() const;    // of this step, in names with the bearing axis third

  enum Report {    // columns of f_ID[...], from 1
    DX, DY, DZ, VX, VY, VZ, TILT1, TILT2, SPIN, ANGLE, FX, FY, FZ, MX, MY, MZ, FRICTION_TORQUE, N_REPORT
  };

 private:
  struct Freedom {
    int mode = fixed;
    bearing::DrivenValue value;
  };
  void parse(int, char **);
  void read_freedom(class bearing::Arguments &, const std::string &name, Freedom &);
  void update_driven();
  double ramp(double time) const;
  void update_loads();
  void turn(FixBearingState::RingMotion &, raceway::Vec3 &w) const;
  void kick();
  void tilt_of(const raceway::Vec3 &e, double *tilt) const;
  void gather_reports();

  PairBearingHertz *pair_;
  FixBearingState *state_ = nullptr;
  Freedom dof_[N_DOF];
  double mass_ = 0.0;
  raceway::RingInertia inertia_;
  bearing::DrivenValue force_[3], moment_[3];
  double ramp_time_ = 0.0, time_ = 0.0;
  int across_[2], along_;               // lab axes across and along the bearing axis
  double target_[N_DOF] = {};           // driven value of this step: speed, or position at its end
  double before_[N_DOF] = {};           // that of the step before
  double load_[N_DOF] = {}, load_before_[N_DOF] = {};    // force and moment without the ramp, likewise
  bool by_another_ = false;             // a fix bearing/implicit integrates these rings
  std::vector<int> tags_;               // of the rings, rising
  std::vector<raceway::Vec3> contact_force_, contact_moment_;    // per local atom of the group, last step
  std::vector<double> report_;
  bigint reported_ = -1;
};

}    // namespace LAMMPS_NS

#endif
#endif
