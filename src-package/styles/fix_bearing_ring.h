// SPDX-License-Identifier: GPL-2.0-or-later
// fix bearing/ring: moves the ring atoms of a group. Every degree of freedom is free, fixed or
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
#include <set>

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

  // Returns true if this fix moves atom i. The rings in the group of a fix bearing/implicit are
  // moved by the latter.
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
  // Returns the currently imposed spin (rad/s), indexed by local atom. It is NAN for other atoms
  // and if no spin is imposed.
  std::vector<double> imposed_spin();
  // Returns the imposed spin (rad/s), or NAN if it is free, differs between rings or changes.
  double constant_spin() const;
  const bearing::StatedLoads &stated_loads() const { return settings_.stated; }
  // Returns true if the imposed loads and motions are constant after the ramp and do not depend on
  // the ring's angle.
  virtual bool constant() const;
  double ramp() const { return settings_.program.ramp; }    // s, ramp time of the loads
  void shorten_ramp(double most) { settings_.program.ramp = std::min(ramp(), most); }
  // Returns the tag of the first ring if all rings of the fix are on one shaft, and 0 otherwise;
  // the second function returns the position (m) of a ring along the shaft.
  virtual bearing::tag_t shaft() const { return 0; }
  virtual double place_on_shaft(int) const { return 0.0; }
  // Returns this fix if it is a flexible shaft, and null otherwise.
  virtual FixBearingShaft *bending() { return nullptr; }
  // Returns the tag of the ring to which the supports connect, or 0 if they connect to the ground.
  bearing::tag_t holder() const { return holder_; }
  void begin_step();
  // Stores the accelerations that follow from the forces of all fixes at the start of a run.
  // Must be called on all ranks.
  void note_setup();
  // Force balance (N) of the first ring of the fix along its free directions: the load on the ring,
  // and the part of the load that is not carried by contacts.
  struct Balance {
    raceway::Vec3 load, left;
  };
  Balance balance();
  // Returns the values for ring i that come from atom-style variables.
  std::vector<raceway::RingValue> own_values(int i) const;
  // Returns the driven motion and the loads in this step for a ring that has the given values.
  raceway::RingProgram program(const std::vector<raceway::RingValue> &own) const;

  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  double memory_usage() override;

 protected:
  using RingProgram = raceway::RingProgram;
  // Speeds, or positions at the end of the step, and loads before the ramp is applied. They are
  // numbered as in RingProgram; the bearing axis is the third component.
  struct Values {
    double of[RingProgram::N_VALUE] = {};
    raceway::Vec3 leverage;         // N m, moment of the loads along the shaft
    std::vector<double> bending;    // N, loads on the modes of a shaft, before the ramp is applied
  };
  // Force (N) and moment (N m) of balls and cage on a ring, in the lab frame.
  struct ContactLoad {
    bearing::tag_t ring;
    raceway::Vec3 force, moment;
  };
  enum class Words { unread };
  FixBearingRing(class LAMMPS *, int, char **, Words);    // for derived classes with more settings
  bearing::RingBody usual_body() const;
  void settings_are_read();    // must be called after the settings have been read
  void warn_if_idle(int dof, double load, const char *force = "force");
  void warn_of_idle_loads();
  void find_rings();
  void refuse_another_mover();
  void find_own_values();
  virtual void evaluate(int first, int last);
  Values values(int i) const;
  RingProgram at_end(const Values &) const;
  RingProgram at_end(int i) const { return at_end(values(i)); }
  virtual double mass_of_atom() const { return settings_.program.mass; }
  raceway::Vec3 load_of(const RingProgram &, int i) const;    // force, N; the bearing axis is the
                                                              // third component
  raceway::RingAtom read(int i) const;
  void write(int i, const raceway::RingAtom &);
  // Computes the forces of the supports on a ring (RingProgram::SPIN values, N and N m) if the
  // given forces act on it in addition.
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
  int only_type_ = 0;    // atom type in the group that this fix moves; 0 for all types
  FixBearingState *state_ = nullptr;
  raceway::LabAxes axes_;
  bearing::RingSettings settings_;
  double time_ = 0.0;
  // Imposed positions (m or rad) and spin speed (rad/s) for check_jumps(); NaN if they were not
  // imposed in the previous step.
  struct Imposed {
    double at[RingProgram::N_DOF] = {NAN, NAN, NAN, NAN, NAN, NAN};
    double moved[RingProgram::N_DOF] = {},
           before[RingProgram::N_DOF] = {};    // imposed values and their changes in the last two
                                               // steps
  } imposed_;
  Values now_, before_;                 // values of all rings in this step and the previous one
  std::vector<int> own_;                // indices of the values that are specified separately for
                                        // each ring
  std::vector<Values> per_ring_;        // values with these indices, indexed by local atom
  bool called_back_ = false;            // true if the host moves per_ring_ along with the atoms
  bool by_another_ = false;             // true if a fix bearing/implicit integrates these rings
  std::vector<bearing::tag_t> tags_;    // tags of the rings in ascending order
  bearing::tag_t holder_ = 0;
  FixBearingRing *holder_moves_by_ = nullptr;
  // Forces (N) that supports between two rings exert on the rings of this fix in this step. The
  // bearing axis is the third component.
  std::map<bearing::tag_t, raceway::Vec3> between_;
  std::vector<ContactLoad> contacts_;    // loads on owned rings in the last step, sorted by tag
  std::vector<double> report_;
  bigint reported_ = -1;
  std::set<std::string> idle_;    // loads without effect of which a warning has been printed
  bool noted_ = true;             // true if the accelerations follow from the forces in atom->f
};

}    // namespace LAMMPS_NS

#endif
#endif
