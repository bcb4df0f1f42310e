// SPDX-License-Identifier: GPL-2.0-or-later
// fix bearing/circuit: computes the voltage, discharges and energy balance of a bearing in an outer
// circuit. The circuit is sampled every N steps or at several instants within every step. The films
// are provided by a fix bearing/capacitance. Every rank solves the whole circuit, so the results do
// not depend on the number of ranks.
#ifdef FIX_CLASS
FixStyle(bearing/circuit,FixBearingCircuit)
#else
#ifndef LMP_FIX_BEARING_CIRCUIT_H
#define LMP_FIX_BEARING_CIRCUIT_H

#include "../contacts/instants.h"
#include "../core/electric/circuit.h"
#include "../core/electric/film_capacitor.h"
#include "../core/settings/circuit_settings.h"
#include "../deck/text_file.h"
#include "bearing_compat.h"

namespace bearing {
struct RacewayContact;
}

namespace LAMMPS_NS {

class FixBearingCapacitance;
class PairBearingHertz;

class FixBearingCircuit : public Fix {
 public:
  FixBearingCircuit(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void setup(int) override;
  void end_of_step() override;
  double compute_scalar() override;
  double compute_vector(int) override;
  void write_restart(FILE *) override;
  void restart(char *) override;

 private:
  // A sampled film.
  struct Film {
    double capacitance = 0.0;                                       // F
    double thickness = std::numeric_limits<double>::quiet_NaN();    // m
    double rough = 0.0;    // m, reduction of the film thickness by the roughness of the surfaces
    double metal = 0.0;    // S, conductance of the asperities in contact
    double area = 0.0;     // m^2, area of the contact patch; set only if the arc model needs it

    // Adds another film between the same ball and ring; breakdown occurs in the film that is
    // locally thinner.
    void add(const Film &beside);
  };
  struct BallFilms {
    double tag = 0.0, azimuth = 0.0;    // azimuth in rad
    Film film[2];                       // inner, outer
  };
  // Film of a contact, as sent to all ranks.
  struct Row {
    bearing::tag_t ball, ring;
    int side;
    double azimuth;
    Film film;
  };

  void find_integrators();
  std::vector<BallFilms> find_balls();
  void check_group() const;
  std::vector<BallFilms> balls_at(int instant);
  std::vector<BallFilms> balls_of(const std::vector<bearing::tag_t> &tags,
                                  std::vector<Row> mine) const;
  Film film_of(const raceway::RacewayPhysics &, bool live, const raceway::ContactState &,
               const raceway::FilmCapacitorT<double> &) const;
  bool needs_states() const { return settings_.metal > 0.0 || settings_.arc > 0.0; }
  // Returns the time (s) from the first sample to the instant that lies `back` steps before the end
  // of `step`.
  double time_of(bigint step, double back = 0.0) const
  {
    return (static_cast<double>(step - first_step_) - back) * dt_;
  }
  template <class List> void keep(List &);
  void sample();
  void advance(const std::vector<BallFilms> &to, double time);
  raceway::BearingFilms films(const std::vector<BallFilms> &) const;
  static std::vector<BallFilms> between(const std::vector<BallFilms> &,
                                        const std::vector<BallFilms> &, double share);
  raceway::CircuitPoint point(const std::vector<BallFilms> &, double time) const;
  void require_films(const std::vector<BallFilms> &, double time) const;
  void tell(const raceway::FilmFailure &, const std::vector<BallFilms> &at, double time);

  std::string cap_id_;
  bearing::CircuitSettings settings_;
  PairBearingHertz *pair_ = nullptr;
  FixBearingCapacitance *cap_ = nullptr;
  std::vector<bearing::InstantSource *> integrators_;    // sources of the instants within steps
  bearing::TextFile events_;
  bool begun_ = false, restored_ = false;
  bigint first_step_ = 0, last_step_ = -1;    // steps of the first and the last sample
  double last_time_ = 0.0;                    // s, time of the last sample
  double dt_ = 0.0;                           // s, length of the steps between them
  std::vector<BallFilms> balls_;              // state at the last sample, sorted by tag
  raceway::CircuitState state_;
};

}    // namespace LAMMPS_NS

#endif
#endif
