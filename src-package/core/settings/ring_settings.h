// SPDX-License-Identifier: GPL-2.0-or-later
// Motion of a ring as specified in a deck: degrees of freedom, inertia, loads and supports.
#pragma once

#include "../bodies/ring_program.h"
#include "../numbers/lab_axes.h"
#include "deck_variable_table.h"
#include "driven_value.h"

#include <cmath>

namespace bearing {

// Loads of a radial bearing as specified by the words `load` and `axial`, for a record.
struct StatedLoads {
  bool stated = false;
  double load = 0.0, azimuth = 0.0, axial = 0.0;    // in N, rad and N
  double moment[2] = {0.0, 0.0};                    // N m, constant moments
  double unbalance = 0.0;                           // kg m
  double speed = NAN;                               // rad/s; NAN unless it is imposed and constant
};

struct RingSettings {
  raceway::RingProgram program;    // common program of all rings, without targets and loads
  DrivenValue value[raceway::RingProgram::N_VALUE];
  StatedLoads stated;
  std::string holder;    // group of the ring to which the other ends of the supports are attached,
                         // or empty
};

// Mass and inertia of a ring, which are used if the words do not specify them; 0 if unknown.
struct RingBody {
  double mass = 0.0;
  raceway::RingInertia inertia;
};

// Reads the inertia about and across the axis.
raceway::RingInertia read_inertia(Arguments &);

// Reads the settings keyword by keyword.
class RingWords {
 public:
  // If `each` is true, values may differ between rings.
  RingWords(Arguments &args, const raceway::LabAxes &axes, RingSettings &to, bool each);
  // Reads a keyword and its values. Returns false if the next word is not a keyword.
  bool take();
  // Sets and checks the values that depend on several words. Must be called after all words have
  // been read.
  void finish(const RingBody &usual);

 private:
  using RingProgram = raceway::RingProgram;
  void read_freedom(const std::string &name, int dof);
  bool take_freedom();
  void read_vector(int first, const std::string &what);
  void read_support();
  bool take_load();
  bool take_housing();
  void apply_load();
  void apply_housing();
  void check() const;
  const char *name_of(int dof) const;    // returns the name of a displacement or a tilt

  Arguments &args_;
  raceway::LabAxes axes_;
  RingSettings &to_;
  bool each_;
  int number_[3];    // indices of the axes of the lab frame, of which the third is the bearing axis
  // free_loaded_: `free loaded` was given, which frees the degrees of freedom that carry a load
  bool free_loaded_ = false, loads_ = false, springs_ = false;
  double load_ = 0.0, azimuth_ = usual_number("load_azimuth"), axial_ = 0.0;    // N, rad, N
  double housing_mass_ = usual_number("housing_mass");                          // kg
  double housing_frequency_ = usual_number("housing_frequency");                // Hz
  double housing_damping_ = usual_number("housing_damping");
};

}    // namespace bearing
