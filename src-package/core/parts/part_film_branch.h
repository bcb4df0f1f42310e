// SPDX-License-Identifier: GPL-2.0-or-later
// Film damping by a spring and a dashpot in series (film_branch.h) instead of eq 5. This part acts
// after the normal force and adds to it. The force of the branch is treated as constant in
// derivatives.
#pragma once

#include "../laws/film_branch.h"
#include "part_damping.h"

namespace raceway {

// The power of the branch is f times the rate of overlap. It is negative while the film springs
// back. k_m changes with the film, so f^2/(2 k_m) is not a potential (at rest k_m becomes 0 while f
// remains), and the loss in the dashpot alone, f^2/(k_m tau), would not add up to the work done on
// the branch.
struct FilmBranchLoss : DampingPower {
  template <class T> static RACEWAY_INLINE Value<T> of(const ContactStateT<T> &c)
  {
    return c.film_force * held(c.overlap_rate);
  }
};

struct FilmBranchPart : PartBase {
  static constexpr const char *name = "film_branch", *slot = "film_damping", *needs = "film_in_gap";
  static constexpr bool needs_film = true;
  static constexpr int states = 1;    // N, force of the branch
  using Losses = LossList<FilmBranchLoss>;

  static std::vector<Keyword<Parameters>> keywords()
  {
    return {{"film_damping",
             "branch",
             true,
             {},
             nullptr,
             "one Maxwell branch in parallel with the Hertz spring, after *gap*"}};
  }

  static std::vector<StateColumn> columns()
  {
    return {{{"film_force", "N", "force of the film's Maxwell branch", vanishes},
             &ContactState::film_force,
             Needs::film,
             false}};
  }

  template <class T>
  static RACEWAY_INLINE void act(const Parameters &, const Raceway &,
                                 const RacewayConstantsT<Value<T>> &k, const LawStates<T> &m,
                                 ContactStateT<T> &c)
  {
    using B = Value<T>;
    const B root = held(c.root);
    const FilmBranchT<B> f = film_branch(B(1.5 * k.K * root), c.h_c, B(held(c.compression)),
                                         B(k.b * root), c.entrainment);
    const BranchStepT<B> step = branch_step(f, m.dt, m.stage);
    const T force = step.slope * c.overlap_rate + m.before[0] * step.left;
    m.after[0] = force;
    const T N = c.load + c.damping * c.overlap_rate + force;
    c.normal = where(N > 0.0, N, 0.0);
    c.film_force = held(force);
    c.film_stiffness = f.stiffness;
    c.film_rate = f.rate;
  }
};

}    // namespace raceway
