// SPDX-License-Identifier: GPL-2.0-or-later
// fix bearing/capacitance: electrical capacitance of every raceway contact, of every ball (whose
// contacts are in series) and of the bearing (the sum over its balls). The capacitance is sampled
// every N steps, or at several instants within every step of fix bearing/implicit; nothing is
// computed between samples.
#ifdef FIX_CLASS
FixStyle(bearing/capacitance,FixBearingCapacitance)
#else
#ifndef LMP_FIX_BEARING_CAPACITANCE_H
#define LMP_FIX_BEARING_CAPACITANCE_H

#include "../contacts/instants.h"
#include "../contacts/tag_set.h"
#include "../core/electric/film_figures.h"
#include "../core/figures/capacitor_table.h"
#include "../deck/text_file.h"
#include "bearing_compat.h"
#include "run_phase.h"

#include <set>

namespace bearing {
class Arguments;
}

namespace LAMMPS_NS {

class PairBearingHertz;

class FixBearingCapacitance : public Fix, public bearing::WaitsForRun {
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

  // Tags of the balls in the fix's group, on all ranks.
  std::vector<bearing::tag_t> find_members() const;
  // Returns a request for `number` instants per step. Must be called on all ranks.
  bearing::Instants instants(int number) const
  {
    return {number, model_, ask_.any(), find_members()};
  }
  bool covers(int i) const { return atom->mask[i] & groupbit; }
  const raceway::CapacitorModel &model() const { return model_; }
  std::string said() const { return said_; }    // words of the command after N
  bool idle() const { return idle_; }           // true if the contacts in the deck are dry
  // Returns the capacitor of a contact in the table of the pair style. For an open contact this is
  // the capacitor of its surroundings, or 0.
  raceway::FilmCapacitorT<double> capacitor(const bearing::RacewayContact &);

 private:
  void begin(const bearing::Sampling &) override;
  struct Sum {    // sums over all balls of the group at one instant of a step, F
    double all, largest;
  };
  struct Total {
    Sum plates, whole;
    double active;
    double hertz_area;    // m^2
    raceway::FilmFigures figures;
  };
  struct Spread {    // range of a sum over the instants of a step, F
    double mean, least, most;
    void add(double value, bool first);
  };
  struct Row {
    int instant;    // number of the instant, from 1 to within_
    bearing::tag_t ball;
    raceway::Side side;
    int groove;
    bool live;
    double load;    // load, N
    raceway::FilmCapacitorT<double> of;
    double area, roughness;    // m^2 and m, computed only if the outputs need them
  };

  void read_options(bearing::Arguments &);
  std::vector<int> ball_types() const;
  void take_usual_data();
  void check_shoulders();
  Row row_of(int instant, bearing::tag_t ball, const raceway::RacewayPhysics &, bool live,
             double load, const raceway::ContactState &,
             const raceway::FilmCapacitorT<double> &) const;
  void find_integrators();
  void add_instants();
  void sample(bool between);
  void sum_up();
  Total add_up(const Row *first, const Row *end);
  void write(const Row *first, const Row *end, int instant);

  PairBearingHertz *pair_ = nullptr;
  raceway::CapacitorModel given_, model_;    // given_: 0 for data that are not in the command
  std::string said_, said_given_, totals_name_, contacts_name_;
  bool idle_ = false;
  std::set<std::string> insulating_;    // bearings of whose ceramic balls a warning has been given
  double background_ = 0.0;
  raceway::FilmQuestions ask_;
  bearing::CapacitorTable table_;    // capacitors including their surroundings
  int planned_ = -1;                 // counts of how often the contact table has been built and
                                     // filled
  bigint filled_ = -1;
  double **per_ball_ = nullptr;    // capacitances of the inner contact, the outer contact and both
                                   // in series; the same including surroundings
  int within_ = 1;                 // number of instants per step; the last is at its end
  std::vector<bearing::InstantSource *> integrators_;    // sources of the instants within steps
  bearing::TagSet members_;    // balls of the group, filled only if there are integrators_
  std::vector<Row> mine_;      // balls of this rank in this step; reused buffer
  bearing::TextFile totals_, contacts_;
  bool grooves_ = false;                       // list the grooves separately in the second file
  bool between_ = false, summed_ = true;       // mine_ contains instants within the step; the sums
                                               // below are up to date
  Total total_ = {};                           // values at the end of the step
  std::vector<raceway::SampledBall> balls_;    // balls at one instant; reused buffer
  bigint written_ = -1;                        // step of the last row in the files
  Spread plates_ = {}, whole_ = {};            // ranges of the sum over the instants
};

}    // namespace LAMMPS_NS

namespace bearing {
// Returns the active fixes bearing/capacitance of a run.
std::vector<LAMMPS_NS::FixBearingCapacitance *> capacitances_of(LAMMPS_NS::LAMMPS *);
}    // namespace bearing

#endif
#endif
