// SPDX-License-Identifier: GPL-2.0-or-later
// fix bearing/shaft: mounts the ring atoms of a group on one rigid shaft. It is a fix bearing/ring
// whose rings move as one body, so degrees of freedom, inertia and loads refer to the shaft. No
// atom represents the shaft; its position is defined by its first ring (core/bodies/shaft_ring.h).
// A flexible shaft also has elastic modes (core/bodies/shaft_modes.h), whose state is stored here.
#ifdef FIX_CLASS
FixStyle(bearing/shaft,FixBearingShaft)
#else
#ifndef LMP_FIX_BEARING_SHAFT_H
#define LMP_FIX_BEARING_SHAFT_H

#include "../core/bodies/shaft_bend.h"
#include "../core/settings/shaft_settings.h"
#include "fix_bearing_ring.h"

namespace LAMMPS_NS {

class FixBearingShaft : public FixBearingRing {
 public:
  FixBearingShaft(class LAMMPS *, int, char **);
  void init() override;
  void setup(int) override;
  double compute_vector(int) override;
  double compute_array(int, int) override;
  void write_restart(FILE *) override;
  void restart(char *) override;

  // Used by fix bearing/implicit. After each host step, the bending state of the shaft at the end
  // of that step is known on every rank.
  FixBearingShaft *bending() override { return shaft_.of_file ? this : nullptr; }
  const raceway::ShaftModes &modes() const { return shaft_.of_file->modes; }
  const raceway::BendState &bend() const { return bend_; }
  void set_bend(const raceway::BendState &b) { bend_ = b; }
  raceway::BendProgram bend_program() const;

  // Used by fix bearing/grains. The first function returns the current state of the rigid shaft on
  // all ranks (the bearing axis is the third component). The second sets the load that grains exert
  // at the shaft's centre (N and N m), which acts from the next step on. Must be called on all
  // ranks.
  raceway::RingAtom pose() const { return whole().shaft; }
  void set_grain_load(const raceway::Vec3 &force, const raceway::Vec3 &moment);

  bearing::tag_t shaft() const override { return tags_.front(); }
  bool constant() const override { return FixBearingRing::constant() && shaft_.unbalances.empty(); }
  double place_on_shaft(int i) const override;

 private:
  // A ring of the shaft, sent by its owner to all ranks. The bearing axis is the third component.
  struct MountedRing {
    bearing::tag_t tag;
    double at;    // m, position relative to the shaft's centre
    raceway::RingAtom now;
    raceway::Vec3 force, moment;    // total force and moment on the atom
    raceway::Vec3 contact[2];       // force and moment exerted by balls and cage
  };
  // State of the shaft and the loads at its centre.
  struct Whole {
    raceway::RingAtom shaft;
    raceway::Vec3 push, moment;    // total force and moment on the atoms of the rings
    raceway::Vec3 contact[2];      // force and moment exerted by balls and cage
    std::vector<MountedRing> rings;
  };

  void evaluate(int first, int last) override;
  double mass_of_atom() const override;
  void kick() override;
  void coast() override;
  void add_loads() override;
  void hold(double half) override;
  void note_accelerations() override;
  void make_report() override;
  void report_loads(int, double *) const override {}    // loads are reported for the shaft

  double centre() const;
  // Convert the state of a ring that is `at` metres from the shaft's centre to the state of the
  // rigid shaft, and vice versa.
  raceway::RingAtom straight(const raceway::RingAtom &ring, double at) const;
  raceway::RingAtom seat(const raceway::RingAtom &shaft, double at,
                         const raceway::Vec3 &origin) const;
  raceway::Deflection deflection(double at) const;
  // Returns the state of the shaft at its centre, where the supports act.
  raceway::RingAtom at_centre(const raceway::RingAtom &shaft) const
  {
    return shaft_.of_file ? seat(shaft, 0.0, shaft.origin) : shaft;
  }
  void load_modes(double at, const raceway::Vec3 &force, const raceway::Vec3 &moment);
  std::vector<double> forces_on_modes(const std::vector<MountedRing> &,
                                      const raceway::RingPose &) const;
  void check_stations() const;
  void check_station(const std::string &what, double at) const;
  double bending_value(int k) const;
  void check_axis() const;
  void check_places() const;
  void check_gravity() const;
  int first_ring() const;    // local index; -1 if the ring is not on this rank
  std::vector<MountedRing> rings() const;
  Whole whole() const;
  void move_rings(const raceway::RingAtom &shaft);
  void add_to_first(const raceway::RingAtom &shaft, const raceway::Vec3 &push,
                    const raceway::Vec3 &moment);

  bearing::ShaftSettings shaft_;
  raceway::BendState bend_;
  std::vector<double> places_;    // m, positions of the rings relative to the shaft's centre,
                                  // sorted by tag
  double middle_ = 0.0;           // m, mean of the rings' positions along the axis
  raceway::RingAtom between_;     // state of the shaft between kick and drift
};

}    // namespace LAMMPS_NS

#endif
#endif
