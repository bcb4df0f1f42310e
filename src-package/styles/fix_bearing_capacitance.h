// SPDX-License-Identifier: GPL-2.0-or-later
// fix bearing/capacitance: electrical capacitance of every raceway contact, of every ball (series)
// and of the bearing (sum), sampled every N steps, or at several instants within every step of fix
// bearing/implicit; nothing is computed in between.
#ifdef FIX_CLASS
FixStyle(bearing/capacitance,FixBearingCapacitance)
#else
#ifndef LMP_FIX_BEARING_CAPACITANCE_H
#define LMP_FIX_BEARING_CAPACITANCE_H

#include "../contacts/contact_table.h"
#include "../contacts/instants.h"
#include "../deck/text_file.h"
#include "../physics/capacitance.h"

namespace LAMMPS_NS {

class FixBearingImplicit;
class PairBearingHertz;

class FixBearingCapacitance : public Fix {
 public:
  FixBearingCapacitance(class LAMMPS *, int, char **);
  ~FixBearingCapacitance() override;
  int setmask() override;
  void init() override;
  void setup(int) override;
  void end_of_step() override;
  double compute_scalar() override;
  double compute_vector(int) override;
  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  double memory_usage() override;

  // Its balls, sorted; all ranks.
  std::vector<bearing::tag_t> find_members() const;
  // At `number` instants of a step.
  bearing::Instants instants(int number) const { return {number, permittivity_, shortest_film_}; }
  bool covers(int i) const { return atom->mask[i] & groupbit; }
  double permittivity() const { return permittivity_; }    // relative, at ambient pressure
  raceway::FilmCapacitorT<double> capacitor(const bearing::RacewayContact &) const;

 private:
  // Of all balls of the group at one instant of a step.
  struct Total {
    double sum, largest, active;
  };
  struct Row {
    int instant;    // of within_
    bearing::tag_t ball;
    raceway::Side side;
    double load, h_c, capacitance;    // N, m, F
  };

  void find_integrators();
  void add_instants();
  void sample(bool between);
  void sum_up();
  Total add_up(const Row *first, const Row *end) const;
  void write(const Row *first, const Row *end, int instant);

  PairBearingHertz *pair_ = nullptr;
  double permittivity_ = 0.0, background_ = 0.0;
  double shortest_film_ = 1e-9;    // m; below it a capacitor of this model would be a short circuit
  double **per_ball_ = nullptr;    // inner, outer, series
  int within_ = 1;                 // instants a step, the last one its end
  std::vector<FixBearingImplicit *> integrators_;    // that know what happens between steps
  std::vector<bearing::tag_t>
      members_;              // balls of the group, sorted; known where integrators_ are
  std::vector<Row> mine_;    // of this step, kept for its memory
  bearing::TextFile totals_, contacts_;
  bool between_ = false, summed_ = true;            // what mine_ holds; the numbers below are of it
  Total total_ = {};                                // at the end of the step
  bigint written_ = -1;                             // step of the last row in the files
  double mean_ = 0.0, least_ = 0.0, most_ = 0.0;    // of the sum, over the instants of the step
};

}    // namespace LAMMPS_NS

#endif
#endif
