// SPDX-License-Identifier: GPL-2.0-or-later
// A raceway with the law of its contacts, for those who need not know the parts of the law: only
// contact.h and what evaluates a law include the parts.
#ifndef RACEWAY_RACEWAY_PHYSICS_H
#define RACEWAY_RACEWAY_PHYSICS_H

#include "contact_state.h"
#include "raceway.h"

#include <memory>

namespace raceway {

// Most numbers that a contact keeps from step to step; contact.h asserts that the parts need no
// more.
constexpr int most_states = 8;

// What a set of parts is, one bit a part in the order of `Parts` (contact.h).
struct LawFacts {
  int states = 0;                // numbers that a contact keeps from step to step
  bool couples = false;          // depends on relative rotations, and has couples and a drag
  bool decides = false;          // contacts begin where a part of it says
  bool explicit_step = false;    // an implicit step cannot take it
  bool film = false, film_in_gap = false, asperities = false, tangential_spring = false;
};
LawFacts law_facts(unsigned parts);

// Parts that a pair style begins with, dry or lubricated.
unsigned initial_parts(bool lubricated);

struct PartNumbers;    // the parameters of all parts

// Everything about one raceway that does not change during a run.
struct RacewayPhysics : Raceway {
  unsigned parts;

  RacewayPhysics();
  RacewayPhysics(const RacewayPhysics &);
  RacewayPhysics(RacewayPhysics &&) noexcept;
  RacewayPhysics &operator=(const RacewayPhysics &);
  RacewayPhysics &operator=(RacewayPhysics &&) noexcept;
  ~RacewayPhysics();

  // pitch_radius (m) sets gamma; ball_mass (kg) the dashpot; overlap_limit is a fraction of R_b.
  void prepare(double pitch_radius, double mass, double overlap_limit);

  LawFacts facts() const { return law_facts(parts); }
  // Share of the film that adds to the overlap, and whether its thickness is that of all regimes,
  // where contacts have their film in the gap.
  double gap_share() const;
  bool gap_film_of_all_regimes() const;
  // In place of the tangential spring; `creep` is the slide-roll ratio that smooths Coulomb's law.
  void smooth_friction(double creep);

  // Of one part; contact.h defines these.
  template <class Part> const typename Part::Parameters &of() const;
  template <class Part> typename Part::Parameters &of();
  template <class Part> bool has() const;
  template <class Part> void choose();    // switch it on, and off what excludes it

 private:
  std::unique_ptr<PartNumbers> own_;
};

}    // namespace raceway

#endif
