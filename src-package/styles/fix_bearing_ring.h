// SPDX-License-Identifier: GPL-2.0-or-later
// fix bearing/ring: moves the ring atoms of a group; every degree of freedom is free, fixed or
// driven.
#ifdef FIX_CLASS
FixStyle(bearing/ring,FixBearingRing)
#else
#ifndef LMP_FIX_BEARING_RING_H
#define LMP_FIX_BEARING_RING_H

#include "../core/settings/ring_settings.h"
#include "../deck/column_list.h"
#include "bearing_compat.h"

#include <map>

namespace LAMMPS_NS {

class FixBearingShaft;
class FixBearingState;
class PairBearingHertz;

class FixBearingRing : public Fix, public bearing::ColumnList {
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
  std::vector<Item> columns() const override;
  void write_restart(FILE *) override;
  void restart(char *) override;

  // True if the fix moves atom i; fix bearing/implicit itself moves the rings of its group.
  bool moves(int i) const
  {
    return (atom->mask[i] & groupbit) && (only_type_ == 0 || atom->type[i] == only_type_);
  }
  bool tilts() const { return settings_.program.tilts(); }
  // True if the spin is free, or imposed and not always 0.
  bool turns() const
  {
    constexpr int spin = raceway::RingProgram::SPIN;
    return settings_.program.mode[spin] == raceway::Freedom::free ||
           (settings_.program.mode[spin] == raceway::Freedom::speed &&
            settings_.value[spin].constant_value() != 0.0);
  }
  bool moves_axially() const { return settings_.program.mode[2] != raceway::Freedom::fixed; }
  // Imposed spin at the present time by local atom index, rad/s; NAN for other atoms, or if no spin
  // is imposed.
  std::vector<double> imposed_spin();
  const bearing::StatedLoads &stated_loads() const { return settings_.stated; }
  // True if the imposed loads and motions are constant after the ramp and do not depend on the
  // ring's angle.
  bool constant() const;
  double ramp() const { return settings_.program.ramp; }    // s, ramp time of the loads
  // Tag of the first ring if all rings of the fix are on one shaft, otherwise 0; then the position
  // of a ring on the shaft (m).
  virtual bearing::tag_t shaft() const { return 0; }
  virtual double place_on_shaft(int) const { return 0.0; }
  // This fix if it is a flexible shaft, otherwise null.
  virtual FixBearingShaft *bending() { return nullptr; }
  // Tag of the ring to which the supports connect; 0: ground.
  bearing::tag_t holder() const { return holder_; }
  void begin_step();
  // Stores accelerations that follow from the forces of all fixes at the start of a run.
  // Collective.
  void note_setup();
  // Force balance of the fix's first ring along its free directions (N): the load on the ring, and
  // the part of the load that contacts do not carry.
  struct Balance {
    raceway::Vec3 load, left;
  };
  Balance balance();
  // Values of ring i that come from atom-style variables.
  std::vector<raceway::RingValue> own_values(int i) const;
  // Driven motion and loads in this step of a ring with these values.
  raceway::RingProgram program(const std::vector<raceway::RingValue> &own) const;

  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  double memory_usage() override;

 protected:
  using RingProgram = raceway::RingProgram;
  // Speeds, or positions at the end of the step; loads before the ramp is applied. The numbering is
  // that of RingProgram; components have the bearing axis third.
  struct Values {
    double of[RingProgram::N_VALUE] = {};
    raceway::Vec3 leverage;         // N m, moment of the shaft's loads along it
    std::vector<double> bending;    // N, loads on the modes of a shaft, before the ramp
  };
  // Force (N) and moment (N m) of balls and cage on a ring, in the lab frame.
  struct ContactLoad {
    bearing::tag_t ring;
    raceway::Vec3 force, moment;
  };
  enum class Words { unread };
  FixBearingRing(class LAMMPS *, int, char **, Words);    // for classes that read the settings
  bearing::RingBody usual_body() const;
  void settings_are_read();    // to be called after reading the settings
  void find_rings();
  void refuse_another_mover();
  void find_own_values();
  virtual void evaluate(int first, int last);
  Values values(int i) const;
  RingProgram at_end(const Values &) const;
  RingProgram at_end(int i) const { return at_end(values(i)); }
  virtual double mass_of_atom() const { return settings_.program.mass; }
  raceway::Vec3 load_of(const RingProgram &, int i) const;    // N, bearing axis third
  raceway::RingAtom read(int i) const;
  void write(int i, const raceway::RingAtom &);
  // Forces of the supports on a ring (RingProgram::SPIN values, N and N m), for given other forces.
  static void support_of(const RingProgram &, const raceway::RingAtom &, const raceway::Vec3 &push,
                         const raceway::Vec3 &moment, double half, double *on);
  virtual void kick();
  virtual void coast();
  virtual void add_loads();
  virtual void hold(double half);
  void find_holder();
  void hold_between(double half);
  void add_support(bearing::tag_t ring, const double *on);
  virtual void note_accelerations();
  void check_jumps();
  virtual void make_report();
  virtual void report_loads(int i, double *row) const;
  double reported(int row, int k);

  PairBearingHertz *pair_;
  int only_type_ = 0;    // type of the atoms in the group that it moves, 0: all
  FixBearingState *state_ = nullptr;
  raceway::LabAxes axes_;
  bearing::RingSettings settings_;
  double time_ = 0.0;
  // Imposed positions (m or rad) and spin speed (rad/s), for check_jumps(); NaN: not imposed in the
  // previous step
  struct Imposed {
    double at[RingProgram::N_DOF] = {NAN, NAN, NAN, NAN, NAN, NAN};
    double moved[RingProgram::N_DOF] = {},
           before[RingProgram::N_DOF] = {};    // changes in the last two steps
  } imposed_;
  // count of numbers in a restart file
  static constexpr size_t numbers_kept = 1 + sizeof(Imposed) / sizeof(double);
  Values now_, before_;                 // values of all rings in this and the previous step
  std::vector<int> own_;                // indices of the values given for each ring
  std::vector<Values> per_ring_;        // the values at these indices, by local atom
  bool called_back_ = false;            // the host moves per_ring_ with the atoms
  bool by_another_ = false;             // a fix bearing/implicit integrates these rings
  std::vector<bearing::tag_t> tags_;    // tags of the rings, ascending
  bearing::tag_t holder_ = 0;
  FixBearingRing *holder_moves_by_ = nullptr;
  // N, bearing axis third: forces on this fix's rings from supports between two rings, in this step
  std::map<bearing::tag_t, raceway::Vec3> between_;
  std::vector<ContactLoad> contacts_;    // on owned rings of the group, by tag, in the last step
  std::vector<double> report_;
  bigint reported_ = -1;
  bool noted_ = true;    // the accelerations follow from the forces in atom->f
};

}    // namespace LAMMPS_NS

#endif
#endif
