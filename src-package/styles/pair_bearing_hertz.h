// SPDX-License-Identifier: GPL-2.0-or-later
// pair_style bearing/hertz: dry elliptical Hertz contact of balls in the grooves of rings,
// friction, and frictionless sphere contacts of the cage. Owns the contact table. bearing/ehd adds
// the film.
#ifdef PAIR_CLASS
PairStyle(bearing/hertz,PairBearingHertz)
#else
#ifndef LMP_PAIR_BEARING_HERTZ_H
#define LMP_PAIR_BEARING_HERTZ_H

#include "../contacts/validity_check.h"
#include "../core/contact/contact_lanes.h"
#include "../core/figures/contact_table.h"
#include "../ranks/ring_sum.h"
#include "bearing_compat.h"
#include "fix_bearing_state.h"
#include "simulated_time.h"

#include <map>
#include <memory>
#include <set>

namespace bearing {
class Arguments;
}
namespace raceway {
}

namespace LAMMPS_NS {

class PairBearingHertz : public Pair, public bearing::PairHooks {
 public:
  PairBearingHertz(class LAMMPS *);
  ~PairBearingHertz() override;
  void compute(int, int) override;
  void settings(int, char **) override;
  void coeff(int, char **) override;
  void init_style() override;
  double init_one(int, int) override;
  void write_restart(FILE *) override;
  void read_restart BRG_READ_RESTART_SIG override;
  double memory_usage() override;

  // For fixes, computes and commands of this package.
  const bearing::ContactTable &table() const { return table_; }
  bearing::RingSum &ring_sum() { return ring_sum_; }
  FixBearingState *state() const { return state_; }
  bool lubricated() const { return with_film_; }
  bool spheres() const { return !spheres_.empty(); }    // balls touch cage balls or one another
  int axis_index() const { return axis_; }              // 0 x, 1 y, 2 z
  raceway::Vec3 axis() const override;
  // Called when a bearing with these balls and cage balls was created: they need a pair_coeff ...
  // sphere.
  void expect_sphere(int ball_type, int cage_type);
  bool is_ring_type(int type) const { return type < (int)ring_type_.size() && ring_type_[type]; }
  bool is_ball_type(int type) const { return type < (int)ball_type_.size() && ball_type_[type]; }
  // Groove of a ring for a ball, by number; null if none.
  const raceway::RacewayPhysics *raceway(int ball_type, int ring_type, int groove = 0) const;
  // True if some ring has two grooves for a ball.
  bool many_grooves() const;
  // Radius of the circle half-way between the raceways of a ball on that ring, m; 0 if the type is
  // not a ring.
  double pitch_radius(int ring_type) const;
  // parts of the contact law (core/contact/contact.h), one law for all raceways
  unsigned law() const { return law_; }
  bool smooth_friction(
      double creep);    // raceways with a tangential spring take this creep instead: true
  int table_build() const
  {
    return builds_;
  }    // counts how often local indices in the table changed
  bigint table_fill() const { return fills_; }    // counts how often it was filled

  void indices_changed() override;
  void forces_known() override;
  void after_step() override;
  void run_done() override;

  // Called by fix bearing/capacitance in every init(), for the balls of a group.
  void add_capacitor(int groupbit, const raceway::CapacitorModel &);

  // Profiles of the raceways, by ring: set anew in every init of the fixes.
  void add_profile(bearing::tag_t ring, const raceway::RacewayPhysics &,
                   const raceway::ProfileShape &);
  const raceway::RacewayProfile *profile(bearing::tag_t ring,
                                         const raceway::RacewayPhysics *) const;
  // Profiles of balls, by ball.
  void add_profile(bearing::tag_t ball, const raceway::RacewayPhysics &,
                   const raceway::BallShape &);
  const raceway::BallProfile *ball_profile(bearing::tag_t ball,
                                           const raceway::RacewayPhysics *) const;
  bool balls_turn() const { return !ball_profiles_.empty(); }    // their orientation matters
  // True for an atom of a fix bearing/implicit, which advances its state.
  bool is_implicit(int i) const { return atom->mask[i] & implicit_bits_; }
  // Raceways of a ring type, and those of a ball type.
  std::vector<const raceway::RacewayPhysics *> raceways_of(int ring_type) const;
  std::vector<const raceway::RacewayPhysics *> raceways_under(int ball_type) const;

  // Words of pair_style and of every pair_coeff.
  const std::vector<std::vector<std::string>> &said() const { return said_; }

  // The pair style of the run; error naming `asked_by` if it is not one of this package.
  static PairBearingHertz *find(class LAMMPS *, const std::string &asked_by);

 protected:
  bool with_film_ = false;

 private:
  struct Sphere {
    double E1, nu1, E2, nu2, factor;
  };
  using TypePair = std::pair<int, int>;
  struct GrooveName {
    int ball, ring, number;    // types; of the grooves of that ring
    bool operator<(const GrooveName &o) const
    {
      return ball != o.ball ? ball < o.ball : ring != o.ring ? ring < o.ring : number < o.number;
    }
  };

  void allocate();
  void read_sphere(bearing::Arguments &, int i, int j);
  void prepare_raceways();
  void put_state_last();
  void check_rings();
  void check_ghosts();
  void check_cages();
  bigint count_atoms() const;
  void check_atoms() const;
  void rebuild_contacts();
  void add_grooves(int i_ball, int i_ring);
  void add_raceway_contacts();
  void raceway_forces();
  bool advances(const bearing::RacewayContact &) const;
  raceway::BallState ball_of(const bearing::RacewayContact &) const;
  raceway::RingState groove_of(const bearing::RacewayContact &) const;
  bool same_groove(const bearing::RacewayContact &a, const bearing::RacewayContact &b) const
  {
    return a.raceway == b.raceway && a.i_ring == b.i_ring && advances(a) == advances(b);
  }
  void find_near(int first, int end);
  void take(const int *rows, int count);
  void add_forces(const bearing::RacewayContact &, const raceway::ContactForces &, double energy);
  void tally(const bearing::RacewayContact &, const raceway::ContactForces &, double energy);
  void sphere_forces(bool tally);
  void check_step();
  double orbit_of(const bearing::RacewayContact &) const;
  bool touch_profile(int row);
  bool smooth() const { return profiles_.empty() && ball_profiles_.empty(); }
  [[noreturn]] void lost(const bearing::RacewayContact &);

  bearing::SimulatedTime time_;
  raceway::RacewayPhysics defaults_;
  int axis_ = 2;
  double overlap_limit_ = 0.05;
  std::map<GrooveName, raceway::RacewayPhysics> raceways_;
  std::map<TypePair, Sphere> spheres_;    // (smaller type, larger type)
  std::set<TypePair> cages_;              // made, (smaller type, larger type)
  std::vector<char> ring_type_, ball_type_;
  std::vector<double> type_radius_;
  unsigned law_ = 0;
  raceway::LawFacts facts_;    // of the contact law
  int implicit_bits_ = 0;      // groups of fixes that advance contact states themselves

  // the words of every command so far: what a restart file keeps and replays
  std::vector<std::vector<std::string>> said_;

  std::map<std::pair<bearing::tag_t, const raceway::RacewayPhysics *>, raceway::RacewayProfile>
      profiles_;
  std::map<std::pair<bearing::tag_t, const raceway::RacewayPhysics *>, raceway::BallProfile>
      ball_profiles_;

  bearing::ContactTable table_;
  std::vector<int> by_groove_, near_;            // places in the table: all, some of one groove
  std::vector<raceway::ContactForces> found_;    // by row of the table
  std::vector<double> energies_;                 // J, stored in contacts
  std::vector<raceway::FlawedPlace> flaws_;      // empty if all surfaces are smooth
  struct InLanes;
  std::shared_ptr<InLanes> in_lanes_;
  bearing::RingSum ring_sum_;
  FixBearingState *state_ = nullptr;
  bearing::ValidityCheck validity_;
  bigint atoms_ = 0;    // number with types named by pair_coeff, at the start of the run
  bool rebuild_ = true;
  int builds_ = 0;
  bigint fills_ = 0;
  bool capacitors_ = false;    // there is a fix bearing/capacitance
  bool gaps_ = false;          // one needs the surroundings of contacts
  bool warned_ = false;        // warned of a too long step
};

}    // namespace LAMMPS_NS

#endif
#endif
