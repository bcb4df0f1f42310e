// SPDX-License-Identifier: GPL-2.0-or-later
// pair_style bearing/hertz: dry elliptical Hertz contacts with friction between balls and the
// grooves of rings, and frictionless contacts between spheres for the cage. It owns the contact
// table. The film is added by bearing/ehd.
#ifdef PAIR_CLASS
PairStyle(bearing/hertz,PairBearingHertz)
#else
#ifndef LMP_PAIR_BEARING_HERTZ_H
#define LMP_PAIR_BEARING_HERTZ_H

#include "../contacts/law_follower.h"
#include "../contacts/mover_check.h"
#include "../contacts/surface_profiles.h"
#include "../contacts/validity_check.h"
#include "../core/settings/pair_coefficients.h"
#include "../ranks/kept_commands.h"
#include "../ranks/ring_sum.h"
#include "contact_evaluator.h"
#include "fix_bearing_state.h"

#include <set>

namespace LAMMPS_NS {

class PairBearingHertz : public Pair, public bearing::PairHooks {
 public:
  explicit PairBearingHertz(class LAMMPS *, bool with_film = false);
  ~PairBearingHertz() override;
  void compute(int, int) override;
  void settings(int, char **) override;
  void coeff(int, char **) override;
  void init_style() override;
  double init_one(int, int) override;
  void write_restart(FILE *) override;
  void read_restart BRG_READ_RESTART_SIG override;
  double memory_usage() override;

  // Used by the fixes, computes and commands of this package.
  const bearing::PairCoefficients &coefficients() const { return coefficients_; }
  bearing::PairCoefficients &coefficients() { return coefficients_; }
  bearing::SurfaceProfiles &profiles() { return profiles_; }    // set by fixes in every init()
  const bearing::ContactTable &table() const { return table_; }
  // Pairs of grains that may touch, as local indices for fix bearing/grains. They are valid until
  // the table is built again.
  const std::vector<std::pair<int, int>> &grains() const { return grains_; }
  std::vector<bearing::PocketRow> &pocket_rows() { return table_.pocket; }
  bearing::RingSum &ring_sum() { return ring_sum_; }
  FixBearingState *state() const { return state_; }
  raceway::Vec3 axis() const override { return coefficients_.axis(); }
  // Called after a bearing with the given types of balls and cage balls has been created, because
  // these types need a pair_coeff ... sphere.
  void expect_sphere(int ball_type, int cage_type);
  int table_build() const { return builds_; }     // number of times that local indices have changed
  bigint table_fill() const { return fills_; }    // number of times that the table has been filled

  void indices_changed() override;
  void forces_known() override;
  void after_step() override;
  void run_done() override;

  // Called by fixes that change the contact law, in every init(), and by integrators before each
  // step.
  void add_follower(bearing::LawFollower *one) { followers_.push_back(one); }
  void begin_step()
  {
    for (bearing::LawFollower *one : followers_) one->begin_step();
  }

  // Called by fix bearing/capacitance in every init(), for the balls of a group.
  void add_capacitor(int groupbit, const raceway::CapacitorModel &);

  // Returns true if the atom is in the group of a fix bearing/implicit, which then advances its
  // contact states.
  bool is_implicit(int i) const { return atom->mask[i] & implicit_bits_; }
  // Defaults of fix bearing/implicit: the tolerance relative to the largest overlap, the ratio of
  // the tolerance of cage balls to that of other bodies, and whether the step is controlled by
  // error estimates. A film in the gap hardly damps the vibrations of a shock, which then amplify
  // the larger errors that a relative tolerance allows (docs/notes/integrator).
  virtual double relative_tolerance() const
  {
    return coefficients_.facts().film_in_gap ? 0.0 : 2e-4;
  }
  virtual double cage_tolerance_share() const { return 1.0; }
  virtual bool estimates_errors() const { return true; }
  // Data of the bearing and the oil for a ball type, if the pair style knows them: the relative
  // permittivity, and the shoulder diameter (m) of the inner or outer ring. Unknown values are 0.
  virtual double permittivity(int) const { return 0.0; }
  virtual double shoulder(int, raceway::Side) const { return 0.0; }
  // Returns true if dry contacts have been selected by a word in the deck. In this case, the deck
  // may still contain fixes for films.
  virtual bool dry_by_choice() const { return false; }
  // Returns the words of the pair_style command and of all pair_coeff commands in the deck.
  const bearing::Commands &commands() const { return commands_; }

  // Returns the pair style of the run. Stops with an error that names `asked_by` if it is not a
  // style of this package.
  static PairBearingHertz *find(class LAMMPS *, const std::string &asked_by);

 protected:
  // Selects contacts with a film or dry contacts. Must be called before settings and coefficients.
  void set_film(bool film) { coefficients_ = bearing::PairCoefficients(film); }
  // Moves the last command to the position of command k, provided that there is a command k.
  void move_last_command(size_t k);

 private:
  void allocate();
  bearing::TypeSizes type_sizes() const;
  void put_state_last();
  void check_ghosts();
  void check_types(const std::vector<int> &count);
  void check_rails();
  void hold_rings();
  bigint count_atoms() const;
  void check_atoms() const;
  void rebuild_contacts();
  void add_grooves(int i_ball, int i_ring);
  void add_raceway_contacts();
  void add_forces(const bearing::RacewayContact &, const raceway::ContactForces &, double energy);
  void tally(const bearing::RacewayContact &, const raceway::ContactForces &, double energy);
  void sphere_forces(bool tally);
  void check_step();
  [[noreturn]] void lost(const bearing::RacewayContact &);
  [[noreturn]] void far_side(const bearing::RacewayContact &);

  bearing::PairCoefficients coefficients_;
  bearing::SurfaceProfiles profiles_;
  bearing::Commands commands_;                  // commands read so far, which are repeated after a
                                                // restart
  std::set<std::pair<int, int>> cage_types_;    // types of created bearings, smaller type first
  std::vector<bearing::LawFollower *> followers_;
  std::set<int> silent_types_;    // types without pair_coeff for which a warning was printed
  bearing::MoverCheck movers_;
  bigint without_rails_ = 0;    // number of cage balls without rails
  int implicit_bits_ = 0;       // groups of the fixes that advance contact states themselves
  bearing::ContactTable table_;
  std::vector<std::pair<int, int>> grains_;
  bearing::ContactEvaluator evaluator_;
  bearing::RingSum ring_sum_;
  FixBearingState *state_ = nullptr;
  bool new_style_ = false;    // true if pair_style has been given since the last run
  bearing::ValidityCheck validity_;
  bigint atoms_ = 0;    // atoms at the start of the run whose types have a pair_coeff
  bool rebuild_ = true;
  int builds_ = 0;
  bigint fills_ = 0;
  bool capacitors_ = false;    // true if there is a fix bearing/capacitance
  bool gaps_ = false;          // true if a fix bearing/capacitance needs surroundings
  bool warned_ = false;        // true if the warning that the step is too large has been printed
};

}    // namespace LAMMPS_NS

#endif
#endif
