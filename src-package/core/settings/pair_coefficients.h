// SPDX-License-Identifier: GPL-2.0-or-later
// Settings of pair_style and pair_coeff: the raceway of each ring type for each ball type, the
// materials of spheres in contact, and the contact law.
#pragma once

#include "../laws/grain_law.h"
#include "../raceway/raceway_physics.h"
#include "arguments.h"

#include <map>
#include <set>

namespace bearing {

// Sizes of the atoms of each type on all ranks.
struct TypeSizes {
  std::vector<double> smallest, largest, mass;    // m, smallest and largest radii; kg, largest mass
  std::vector<int> count;
};

// Reads one keyword that describes contacts between grains. Returns false if the next word is not
// such a keyword.
bool take_grain_keyword(Arguments &, raceway::GrainLaw &);

// Returns a message if the balls (Groove::ball_radius) do not fit into the groove, otherwise "".
std::string wrong_groove(const raceway::Groove &);

class PairCoefficients {
 public:
  struct Spheres {    // materials of two types; factor by which the stiffness is multiplied
    double E1, nu1, E2, nu2, factor;
    double stiffness(double R1, double R2) const;    // N/m^1.5
  };

  explicit PairCoefficients(bool with_film);

  // pair_style bearing/hertz [axis x|y|z] [overlap_limit F] [raceway keywords]
  void read_style(Arguments &);
  // pair_coeff BALL RING inner|outer R r_c [gothic_arch G] [keywords]
  // or pair_coeff I J sphere E1 nu1 E2 nu2 [printed], or pair_coeff BALL CAGE cage,
  // or pair_coeff I J grain stiffness K restitution E friction MU
  void read_coeff(Arguments &, int types);
  // Derives the constants of the raceways. Returns a message about an error in raceways or atoms,
  // or "" if there is none.
  std::string prepare(const TypeSizes &);
  // Does the same for coefficients that have been read again during a run.
  std::string prepare_again();
  // Sets the thermal strains of the balls of a type and of their raceways (Raceway::grow).
  void grow(int ball_type, double inner_ring, double balls, double outer_ring);

  bool lubricated() const { return with_film_; }
  int axis_index() const { return axis_; }    // 0 x, 1 y, 2 z
  raceway::Vec3 axis() const
  {
    return {axis_ == 0 ? 1.0 : 0.0, axis_ == 1 ? 1.0 : 0.0, axis_ == 2 ? 1.0 : 0.0};
  }
  bool is_ring(int type) const { return type < (int)ring_type_.size() && ring_type_[type]; }
  bool is_ball(int type) const { return type < (int)ball_type_.size() && ball_type_[type]; }
  bool is_cage(int type) const { return type < (int)cage_type_.size() && cage_type_[type]; }
  bool is_named(int type) const;    // whether the type occurs in a pair_coeff of a bearing
  bool is_grain(int type) const { return grain_type_.count(type) > 0; }
  // Returns the sides on which a ball type has a raceway: 1 for inner, 2 for outer, or their sum.
  int sides_of(int ball_type) const;
  bool any_raceway() const { return !raceways_.empty(); }
  // Returns the groove with the given index in a ring type for a ball type, or null if there is
  // none.
  const raceway::RacewayPhysics *raceway(int ball_type, int ring_type, int groove = 0) const;
  // Return the raceways of a ring type and of a ball type.
  std::vector<const raceway::RacewayPhysics *> raceways_of(int ring_type) const;
  std::vector<const raceway::RacewayPhysics *> raceways_under(int ball_type) const;
  bool many_grooves() const;    // whether at least one ring has two grooves for a ball
  // Returns the radius (m) of the circle midway between the two raceways of the balls on this ring,
  // or 0 if the type is not a ring.
  double pitch_radius(int ring_type) const;
  bool any_spheres() const { return !spheres_.empty(); }    // balls touch cage balls or one another
  const Spheres *spheres(int type_1, int type_2) const;     // null if there are none
  const raceway::GrainLaw *grains(int type_1, int type_2) const;    // null if there are none
  // Parts of the contact law (core/contact/contact.h), which is the same for all raceways.
  unsigned law() const { return law_; }
  const raceway::LawFacts &facts() const { return facts_; }
  // Replaces tangential springs by Coulomb's law with this creep. Returns true if any raceway has a
  // spring.
  bool smooth_friction(double creep);
  // Returns the distance (m) between the centres below which atoms of two types are neighbours, or
  // 0 if the types do not interact.
  double cutoff(int type_1, int type_2) const;
  double reach() const;    // largest distance between the centres of a ball and its ring, m

 private:
  struct GrooveName {
    int ball, ring, number;    // types, and index of the groove
    bool operator<(const GrooveName &o) const
    {
      return ball != o.ball ? ball < o.ball : ring != o.ring ? ring < o.ring : number < o.number;
    }
  };
  void read_spheres(Arguments &, int i, int j);
  void read_cage(Arguments &, int ball, int cage, int types);
  bool is_there(const GrooveName &) const;
  void read_grains(Arguments &, int i, int j);
  std::string wrong_size(const GrooveName &, const raceway::RacewayPhysics &) const;
  std::string wrong_rings() const;
  void set_law(unsigned parts);

  bool with_film_;
  raceway::RacewayPhysics defaults_;
  int axis_ = 2;
  double overlap_limit_ = 0.05;
  std::map<GrooveName, raceway::RacewayPhysics> raceways_;
  std::map<std::pair<int, int>, Spheres> spheres_;             // smaller type first
  std::map<std::pair<int, int>, raceway::GrainLaw> grains_;    // smaller type first
  std::set<int> grain_type_;
  std::vector<char> ring_type_, ball_type_;    // a one-piece cage counts as a ring
  std::vector<char> cage_type_;
  TypeSizes sizes_;
  double creep_ = 0.0;    // argument of the last smooth_friction(), or 0
  unsigned law_ = 0;
  raceway::LawFacts facts_;
};

}    // namespace bearing
