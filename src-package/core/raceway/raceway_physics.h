// SPDX-License-Identifier: GPL-2.0-or-later
// A raceway and its contact law, for code that does not depend on the parts of the law. The parts
// are included only in contact.h and where a law is evaluated.
#pragma once

#include "contact_state.h"
#include "raceway.h"

#include <memory>

namespace raceway {

// Largest number of state variables of a contact; contact.h asserts that it is sufficient.
constexpr int most_states = 8;

// Properties of a set of parts, one bit per part in the order of `Parts` (contact.h).
struct LawFacts {
  int states = 0;                // number of state variables of a contact
  bool couples = false;          // the law depends on relative rotations and has couples and a drag
                                 // force
  bool decides = false;          // a part determines the onset of contact
  bool explicit_step = false;    // the law cannot be used in an implicit step
  bool film = false, film_in_gap = false, asperities = false, tangential_spring = false;
  bool spin = false;    // friction opposes spin about the contact normal
};
LawFacts law_facts(unsigned parts);

// Returns the parts of a dry or lubricated pair style before any keyword is read.
unsigned initial_parts(bool lubricated);

struct PartNumbers;    // the parameters of all parts

// All constant properties of one raceway.
struct RacewayPhysics : Raceway {
  unsigned parts;

  RacewayPhysics();
  RacewayPhysics(const RacewayPhysics &);
  RacewayPhysics(RacewayPhysics &&) noexcept;
  RacewayPhysics &operator=(const RacewayPhysics &);
  RacewayPhysics &operator=(RacewayPhysics &&) noexcept;
  ~RacewayPhysics();

  // pitch_radius (m) determines gamma, mass (kg) the dashpot; overlap_limit is a fraction of R_b.
  void prepare(double pitch_radius, double mass, double overlap_limit);

  LawFacts facts() const { return law_facts(parts); }
  // For contacts with the film in the gap, the functions below return the fraction of the film that
  // adds to the overlap, and whether the film follows the law for all regimes.
  double gap_share() const;
  bool gap_film_of_all_regimes() const;
  // Replaces the tangential spring by Coulomb's law smoothed over the slide-roll ratio `creep`.
  void smooth_friction(double creep);

  // Parameters of one part; defined in contact.h.
  template <class Part> const typename Part::Parameters &of() const;
  template <class Part> typename Part::Parameters &of();
  template <class Part> bool has() const;
  template <class Part> void choose();    // enables Part and disables the parts that it excludes

 private:
  std::unique_ptr<PartNumbers> own_;
};

}    // namespace raceway
