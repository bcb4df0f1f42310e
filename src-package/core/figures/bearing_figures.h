// SPDX-License-Identifier: GPL-2.0-or-later
// Results for a bearing or a ring: sums and extremes over the contacts of its balls. They are used
// in records and computes. The losses in each column are defined by the parts of the law
// (loss_table.h). This file does not depend on the host.
#pragma once

#include "../contact/loss_table.h"
#include "contact_columns.h"

namespace bearing {

// Results of the contacts of one ball. The struct contains only doubles, so that it can be sent
// between ranks. Arrays of two refer to the inner and the outer raceway.
struct BallFigures {
  double balls = 0.0, contacts = 0.0, loaded[2] = {}, load[2] = {}, pressure[2] = {};
  double h_min = HUGE_VAL, lambda = HUGE_VAL;
  double orbit = 0.0;                              // rad/s
  double loss[raceway::most_loss_columns] = {};    // W
  double cage_loss = 0.0, cage_force = 0.0;        // W, N
  double capacitance[2] = {}, whole[2] = {};       // F, without and with surroundings
  // values at the most heavily loaded inner contact
  double entrainment = 0.0, asperity_share = NAN;
  double film[3] = {NAN, NAN, NAN};    // h_min, lambda, h_c

  static constexpr size_t numbers() { return sizeof(BallFigures) / sizeof(double); }
  void contact(const ContactView &);    // adds a loaded contact
  void gap(const ContactView &);        // adds only the surroundings of surfaces that do not touch
  // Adds a contact with a cage ball or another ball. The loss (W) is the part that is assigned to
  // this ball; the force is in N.
  void cage(double loss, double force);
  // Adds the results that combine both contacts of a ball: its capacitances in series, and whether
  // both of its raceways are loaded.
  void take_pairs(const BallFigures &);
};

// Sums and extremes over the balls of a bearing or ring.
struct BearingFigures {
  double balls = 0.0, contacts = 0.0, loaded_balls = 0.0, load[2] = {}, pressure[2] = {};
  double h_min = HUGE_VAL, lambda = HUGE_VAL;
  double orbit = 0.0;    // rad/s, sum over the balls
  double loss[raceway::most_loss_columns] = {};
  double cage_loss = 0.0, cage_force = 0.0;
  double capacitance = 0.0, capacitance_top = 0.0, whole = 0.0, whole_top = 0.0;
  double entrainment = NAN, asperity_share = NAN, film[3] = {NAN, NAN, NAN};

  void add(const BallFigures &);
  double cage_speed() const { return balls > 0.0 ? orbit / balls : 0.0; }    // rad/s
};

// A result that forms a column of an output.
struct Figure {
  raceway::Column is;
  double (*of)(const BearingFigures &, int);
  raceway::Needs needs = raceway::Needs::nothing;
  unsigned parts = 0;      // parts of which the law must contain at least one; 0 for any law
  bool spheres = false;    // available only if balls may touch cage balls or one another
  int loss = 0;            // second argument of `of`, a column of loss_table()
  const char *key = "";    // key of a loss in losses_W of `raceway summary`

  double value(const BearingFigures &f) const { return of(f, loss); }
  // Returns true if the result is available in a run that has the given properties, i.e. film,
  // capacitance, surroundings, contact law, and contacts between spheres.
  bool given(bool film, bool capacitance, bool surroundings, unsigned law, bool touches) const
  {
    using raceway::Needs;
    return (needs != Needs::film || film) && (needs != Needs::capacitance || capacitance) &&
           (needs != Needs::surroundings || surroundings) &&
           ((!parts && !spheres) || (spheres && touches) || (law & parts));
  }
};

const std::vector<Figure> &record_figures();    // for each bearing in a record
const std::vector<Figure> &ring_figures();      // for compute bearing/ring, after the ring's motion
const std::vector<Figure> &total_figures();     // for compute bearing/total

}    // namespace bearing
