// SPDX-License-Identifier: GPL-2.0-or-later
// Fills the contact table by evaluating the contact law of all raceways, four contacts of a groove
// at a time.
#pragma once

#include "../core/contact/contact_lanes.h"
#include "../core/figures/contact_table.h"
#include "bearing_compat.h"

#include <memory>

namespace LAMMPS_NS {
class FixBearingState;
}

namespace bearing {

class ContactEvaluator : protected LAMMPS_NS::Pointers {
 public:
  struct Setting {
    LAMMPS_NS::FixBearingState *state;
    const raceway::LawFacts *facts;    // properties of the contact law
    int axis;
    int implicit_bits;    // groups of the fixes that advance contact states themselves
    bool gaps;            // also evaluate the motion of surfaces that do not touch
    bool energies;
    bool profiled;    // true if at least one surface has a profile
  };

  explicit ContactEvaluator(LAMMPS_NS::LAMMPS *);
  void set_order(const ContactTable &);    // called after every search for contacts
  void evaluate(ContactTable &, const Setting &);

  // Return results for row n of the table. They are valid for live contacts only.
  const raceway::ContactForces &forces(size_t n) const { return found_[n]; }
  double energy(size_t n) const { return energies_.empty() ? 0.0 : energies_[n]; }    // stored
                                                                                      // energy, J
  // Returns the state of the ring at the groove, which may be offset from the ring's mid-plane.
  raceway::RingState groove_of(const RacewayContact &) const;

 private:
  bool advances(const RacewayContact &) const;
  raceway::BallState ball_of(const RacewayContact &) const;
  bool same_groove(const RacewayContact &a, const RacewayContact &b) const
  {
    return a.raceway == b.raceway && a.i_ring == b.i_ring && advances(a) == advances(b);
  }
  void find_near(int first, int end);
  void take(const int *rows, int count);
  bool touch_profile(int row);

  Setting set_ = {};
  RacewayContact *rows_ = nullptr;       // rows of the table
  std::vector<int> by_groove_, near_;    // rows of all grooves; rows of one groove that are near
                                         // contact
  std::vector<raceway::ContactForces> found_;
  std::vector<double> energies_;
  std::vector<raceway::FlawedPlace> flaws_;    // empty if all surfaces are smooth
  struct InLanes;
  std::shared_ptr<InLanes> in_lanes_;
};

}    // namespace bearing
