// SPDX-License-Identifier: GPL-2.0-or-later
// fix bearing/heat: computes the temperatures of the inner ring, the balls, the outer ring, the
// housing and the flowing oil of a named bearing that is heated by the losses in its contacts.
// Films, clearance and friction change with the temperatures (docs/heat).
//
// Because temperatures change slowly and balls move fast, the temperatures jump
// (core/laws/heat_jumps.h): a ramp over one ball pass changes the clearance to its value at the new
// temperatures, the losses are averaged over the next ball pass, or over several ball passes if
// loads or speeds vary, and then the temperatures jump again. The state is the same on all ranks.
#ifdef FIX_CLASS
FixStyle(bearing/heat,FixBearingHeat)
#else
#ifndef LMP_FIX_BEARING_HEAT_H
#define LMP_FIX_BEARING_HEAT_H

#include "../contacts/law_follower.h"
#include "../core/figures/fix_columns.h"
#include "../core/laws/heat.h"
#include "../core/laws/heat_jumps.h"
#include "../deck/text_file.h"
#include "bearing_compat.h"

#include <array>
#include <vector>

namespace bearing {
struct NamedBearing;
}

namespace LAMMPS_NS {

class FixBearingHeat : public Fix, public bearing::LawFollower {
 public:
  FixBearingHeat(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void setup(int) override;
  void initial_integrate(int) override { begin_step(); }
  void end_of_step() override;
  double compute_scalar() override;
  double compute_vector(int) override;
  void write_restart(FILE *) override;
  void restart(char *) override;

  void begin_step() override;
  // Returns true if the temperatures no longer change, because they are steady, the requested time
  // is over, or heating is switched off.
  bool still() const { return idle_ || now_.stage == STAY; }
  bool idle() const { return idle_; }
  // Lets the temperatures change again until they are steady, because loads or speeds may have
  // changed. If `warm_time` is given, no time is left.
  void go_on();
  // Current temperatures (C) of the contacts, from INNER to OIL as in core/figures/fix_columns.h.
  std::array<double, 5> temperatures() const;
  bool covers_type(int ball_type) const;
  double ambient() const { return network_.ambient; }    // ambient temperature, C, at which the
                                                         // bearing has the given clearance
  double ball_expansion() const { return ball_.expansion * raceway::steel_expansion; }    // 1/K

 private:
  enum Stage { WAIT, RAMP, WATCH, LAST, STAY, READY };
  static constexpr int parts = 3;    // inner ring, balls and outer ring, whose strains are tracked
  // Contains only doubles, so that it can be written to restart files.
  struct State {
    raceway::HeatState heat;
    raceway::HeatPass sum;    // time integrals of the values since the current ball pass began
    double begun = 0.0, stage = WAIT;
    double pass = 0.0;                          // s, duration of a ball pass; 0: not yet known
    double since = 0.0;                         // s, time since this stage began
    double run = 0.0;                           // s, total time
    double summed = 0.0;                        // s, time covered by `sum`
    double passes = 0.0;                        // number of ball passes averaged so far
    double oil = 0.0;                           // C, oil temperature used in the current contact
                                                // law
    double begin[raceway::heat_nodes] = {};     // C, temperatures at the start
    double from[parts] = {}, to[parts] = {};    // C, at the start and end of the clearance ramp
    double jump = 0.0;                          // s, length of the last jump
    double rows = 0.0;                          // number of rows in the file
  };
  using Row = std::array<double, bearing::of_fix_heat::N>;

  void find_bearing();
  void find_network();
  void find_oil_flow();
  double oil_datum(const char *name) const;
  double convection() const;
  double outlet() const;
  void check_oil();
  void apply_oil();
  void grow(double share);
  double share_at(double since) const;
  bool passed(double since, double passes = 1.0) const;
  bool averaged();
  double value(int column) const;
  double clearance() const;
  raceway::HeatPass losses();
  void enter(Stage);
  raceway::HeatPass mean_pass() const;
  void check_paths() const;
  void jump_if_all_are_ready();
  static void jump_together(const std::vector<FixBearingHeat *> &);
  void jump(const raceway::HeatControl &);
  void write_row(const Row &);
  void say(double power) const;

  class PairBearing *pair_ = nullptr;
  const bearing::NamedBearing *bearing_ = nullptr;
  bool idle_ = false, dry_ = false;
  double cooling_ = 0.0, start_ = NAN;
  double oil_flow_ = 0.0, oil_inlet_ = NAN;    // m^3/s and C
  raceway::HeatNetwork network_;
  raceway::BallHeat ball_;
  raceway::HeatControl control_;
  double bearings_ = 1.0;    // number of bearings that have these temperatures
  double ramp_ = 0.0;        // s, end of the load ramp
  bool varies_ = false;      // true if loads or speeds change or turn with a ring
  int stride_ = 1;           // number of steps between samples
  bigint last_step_ = -1;    // last step that has been started
  double ahead_ = 0.0;       // s, time step within a step, which now_.since does not yet include
  bool apply_ = false, rewrite_ = false;
  bool warned_ = false;    // true if the losses have been reported to scatter
  State now_;
  std::vector<raceway::HeatPass> passes_;     // mean values of the ball passes averaged so far
  std::vector<FixBearingHeat *> together_;    // all bearings that are heated, including this one
  std::vector<Row> rows_;                     // rows of the file
  std::string file_name_;
  bearing::TextFile file_;
};

}    // namespace LAMMPS_NS

#endif
#endif
