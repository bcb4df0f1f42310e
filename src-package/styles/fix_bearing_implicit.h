// SPDX-License-Identifier: GPL-2.0-or-later
// fix bearing/implicit: implicit time integration of balls, cage balls and rings
// (core/step/bearing_integrator.h).
//
// The whole host step is performed in initial_integrate, in as many substeps as the step control
// requires. The fix works on its own copy of the state and calls the contact functions itself. The
// host's subsequent force evaluation fills the contact table at the end of the step. This has four
// advantages: output is written at host steps, regardless of how the substeps vary; the contact
// table and all output based on it belong to the state that is written, not to a prediction;
// substeps and repeated substeps require no neighbour checks, calls of fixes or clearing of arrays;
// and a restart needs only positions, velocities and one step size.
#ifdef FIX_CLASS
FixStyle(bearing/implicit,FixBearingImplicit)
             FixStyle(bearing/damping,FixBearingImplicit)
                          FixStyle(bearing/vibration,FixBearingImplicit)
#else
#ifndef LMP_FIX_BEARING_IMPLICIT_H
#define LMP_FIX_BEARING_IMPLICIT_H

#include "../contacts/instants.h"
#include "../contacts/tag_set.h"
#include "../core/settings/deck_variable_table.h"
#include "bearing_compat.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bearing {
class Arguments;
}

namespace raceway {
struct BearingModel;
}

namespace LAMMPS_NS {

class FixBearingRing;
class PairBearingHertz;

class FixBearingImplicit : public Fix, public bearing::InstantSource {
 public:
  FixBearingImplicit(class LAMMPS *, int, char **);
  ~FixBearingImplicit() override;
  int setmask() override;
  void init() override;
  void setup(int) override;
  void initial_integrate(int) override;
  double compute_scalar() override;
  double compute_vector(int) override;
  // Returns the number of systems on all ranks. A system is a bearing, or all bearings on one
  // shaft; each system has its own substeps.
  double systems() const;
  struct Control {
    double tolerance, relative, cage;    // tolerance, m; tolerance relative to the largest overlap;
                                         // tolerance of cage balls, m
    bool estimate;
  };
  Control control() const;
  // Returns the sampling rate (Hz) that fix bearing/vibration requests for a record. If it is 0,
  // the record chooses the rate.
  double sampling_rate() const { return sampling_ * oversampling_; }

  // Selects coarse implicit steps, which damp all vibration, for the time while the bearing
  // settles. The last correction of such a step may be as large as `correction` (m), or the
  // tolerance if that is larger; 0 selects the steps specified in the deck. In decks that measure
  // vibration, the specified steps are always used.
  void coarse(double correction);
  bool can_be_coarse() const { return sampling_ == 0.0; }
  // Returns false if the steps specified in the deck take hardly more time than coarse steps.
  bool coarse_saves() const;
  // Must be called whenever the constants of the contact law have changed. The change takes effect
  // in the next step.
  void laws_changed() { laws_changed_ = true; }

  void want_instants(const bearing::Instants &, const std::string &command) override;
  void read_instant(int k, const bearing::InstantReader &) const override;

 private:
  // The solver, its settings and the bearings whose home is on this rank. It is defined only in the
  // sources, so that no other style depends on these types.
  struct Solver;
  struct OwnBearing;

  void read(bearing::Arguments &);
  void check_fixes();
  void add_gravity(Fix &);
  raceway::Vec3 gravity();
  void find_rings();
  void build();
  void begin_energy();
  void load(int part, const raceway::Vec3 &fall);
  void turn_instants(int part);
  void load_bends(int part);
  void store_bends();
  void advance(OwnBearing &);
  [[noreturn]] void give_up(const OwnBearing &, double h) const;

  PairBearingHertz *pair_;
  double tolerance_ = 0.0;    // m, allowed local error of a position in a substep; 0 until it is
                              // known
  bool laws_changed_ = false;
  bool energy_wanted_ = false, begun_ = false;    // begun_: stored_before_ has been set
  struct Capacitors {
    raceway::CapacitorModel model;
    bearing::TagSet balls;
  };
  std::vector<raceway::CapacitorModel> capacitors_of(const raceway::BearingModel &) const;
  bearing::Instants instants_;    // requested by all readers
  std::vector<Capacitors> capacitors_;
  double largest_ = HUGE_VAL;    // s, largest substep
  double creep_ = 0.01;
  double cage_ = 0.0;               // tolerance of cage balls, m, or 0
  double relative_ = NAN;           // relative tolerance; NAN if it is set by the pair
                                    // style
  std::optional<bool> estimate_;    // true: control by error estimates; empty if this
                                    // is set by the pair style
  double sampling_ = 0.0;           // sampling rate of the signal, Hz
  double oversampling_ = bearing::usual_number("oversampling");    // samples in the record per
                                                                   // sample of the signal
  std::vector<FixBearingRing *> rings_;    // fixes whose rings are integrated by this fix
  std::vector<Fix *> gravity_;             // gravity fixes that act on all atoms of the group
  std::vector<double> forces_;             // forces saved while gravity is evaluated
  std::unique_ptr<Solver> solver_;
  int build_ = -1;
  // totals of the bearings whose home is on this rank, since the start of the run
  double substeps_ = 0.0, corrections_ = 0.0, refused_ = 0.0, time_ = 0.0, smallest_ = HUGE_VAL;
  double worst_ = 0.0, stored_before_ = 0.0;
};

}    // namespace LAMMPS_NS

#endif
#endif
