// SPDX-License-Identifier: GPL-2.0-or-later
// fix bearing/heat: temperatures of inner ring, balls, outer ring, housing and flowing oil of a
// named bearing, heated by the losses of its contacts. Films, clearance and friction follow the
// temperatures (docs/heat).
//
// Temperatures change slowly and balls move fast, so temperatures jump (core/laws/heat_jumps.h):
// during one ball pass a ramp takes the clearance to its value at the new temperatures, during the
// next ball pass the losses are averaged, and then the temperatures jump again. All ranks have the
// same state.
#ifdef FIX_CLASS
FixStyle(bearing/heat,FixBearingHeat)
#else
#ifndef LMP_FIX_BEARING_HEAT_H
#define LMP_FIX_BEARING_HEAT_H

#include "../contacts/law_follower.h"
#include "../core/figures/fix_columns.h"
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
  // True if temperatures no longer change: they are steady, the requested time is over, or heat is
  // off.
  bool still() const { return idle_ || now_.stage == STAY; }
  bool idle() const { return idle_; }
  // Present temperatures (C) of the contacts, as in core/figures/fix_columns.h from INNER to OIL.
  std::array<double, 5> temperatures() const;
  bool covers_type(int ball_type) const;
  double ambient() const { return network_.ambient; }    // C, at which the clearance is given

 private:
  enum Stage { WAIT, RAMP, WATCH, LAST, STAY };
  static constexpr int parts = 3;    // strains of inner ring, balls, outer ring
  // Contains doubles only, for restart files.
  struct State {
    raceway::HeatState heat;
    raceway::HeatPass sum;    // sum of values times time over the present ball pass
    double begun = 0.0, stage = WAIT;
    double since = 0.0;                         // s, in this stage
    double run = 0.0;                           // s, in total
    double summed = 0.0;                        // s, time in `sum`
    double oil = 0.0;                           // C, oil temperature of the present law
    double begin[raceway::heat_nodes] = {};     // C, at the start
    double from[parts] = {}, to[parts] = {};    // C, start and end of the present ramp of clearance
    double jump = 0.0;                          // s, length of the last jump
    double rows = 0.0;                          // number of rows in the file
  };
  using Row = std::array<double, bearing::of_fix_heat::N>;

  void read(bearing::Arguments &);
  void find_bearing();
  void find_network();
  void find_oil_flow();
  double oil_datum(const char *name) const;
  double convection() const;
  double outlet() const;
  void check_oil();
  void apply_oil();
  void grow(double share);
  double value(int column) const;
  double clearance() const;
  raceway::HeatPass losses();
  void enter(Stage);
  void end_pass();
  void write_row(const Row &);
  void say(double power) const;

  class PairBearing *pair_ = nullptr;
  const bearing::NamedBearing *bearing_ = nullptr;
  bool idle_ = false, dry_ = false;
  double cooling_ = 0.0, start_ = NAN;
  double oil_flow_ = 0.0, oil_inlet_ = NAN;    // m^3/s, C
  raceway::HeatNetwork network_;
  raceway::HeatControl control_;
  double bearings_ = 1.0;    // number of bearings that share the temperatures
  double pass_ = 0.0;        // s, duration of a ball pass
  double ramp_ = 0.0;        // s, end of the load ramp
  int stride_ = 1;           // steps between samples
  bigint last_step_ = -1;    // last step that has begun
  bool apply_ = false, rewrite_ = false;
  State now_;
  std::vector<Row> rows_;    // rows of the file
  std::string file_name_;
  bearing::TextFile file_;
};

}    // namespace LAMMPS_NS

#endif
#endif
