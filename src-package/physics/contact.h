// SPDX-License-Identifier: GPL-2.0-or-later
// One ball on one raceway: the parts there are, the laws that are made of them, and the one
// dispatcher that every user of a law goes through.
#ifndef RACEWAY_CONTACT_H
#define RACEWAY_CONTACT_H

#include "kinematics.h"
#include "law.h"
#include "part_damping.h"
#include "part_differential_slip.h"
#include "part_drag.h"
#include "part_film.h"
#include "part_film_branch.h"
#include "part_film_gap.h"
#include "part_friction.h"
#include "part_hertz.h"
#include "part_mixed_friction.h"
#include "part_rolling.h"
#include "part_slip_slices.h"
#include "part_spin.h"

namespace raceway {

// The order is that of the bits of a set of parts, and of tables in the docs.
using Parts =
    PartList<HertzContactPart, FilmInGapPart, HysteresisPart, FilmThicknessPart, FilmDamperPart,
             NormalForcePart, FilmBranchPart, ConstantFrictionPart, StribeckFrictionPart,
             TangentialSpringPart, SmoothedFrictionPart, MixedFrictionPart, DifferentialSlipPart,
             HydrodynamicRollingPart, RollingHysteresisPart, SpinPart, SlipSlicesPart, DragPart>;

template <class... P> using Law = LawOf<Parts, P...>;
template <class... P> using DryLaw = Law<HertzContactPart, HysteresisPart, NormalForcePart, P...>;
template <class... P>
using LubricatedLaw =
    Law<HertzContactPart, HysteresisPart, FilmThicknessPart, FilmDamperPart, NormalForcePart, P...>;
// Film in the gap; damped by the film's branch, or as in the paper.
template <class... P>
using FullLaw =
    Law<FilmInGapPart, HysteresisPart, FilmThicknessPart, NormalForcePart, FilmBranchPart, P...>;
template <class... P>
using GapLaw =
    Law<FilmInGapPart, HysteresisPart, FilmThicknessPart, FilmDamperPart, NormalForcePart, P...>;

// Friction as it is in rolling contacts; without differential slip, which spin rests on.
template <template <class...> class Base>
using RollingFriction = Base<MixedFrictionPart, DifferentialSlipPart, HydrodynamicRollingPart,
                             RollingHysteresisPart, SpinPart, DragPart>;
template <template <class...> class Base>
using UniformSlip = Base<MixedFrictionPart, SmoothedFrictionPart, HydrodynamicRollingPart,
                         RollingHysteresisPart, DragPart>;

template <class... L> struct LawList {};
template <class... A, class... B, class... Others>
auto joined(LawList<A...>, LawList<B...>, Others... others)
{
  if constexpr (sizeof...(Others) == 0) return LawList<A..., B...>();
  else return joined(LawList<A..., B...>(), others...);
}

// The laws that are compiled: those that decks use. A family is compiled at a time.
using DryLaws =
    LawList<DryLaw<>, DryLaw<ConstantFrictionPart, TangentialSpringPart>,
            DryLaw<ConstantFrictionPart, SmoothedFrictionPart>,
            DryLaw<ConstantFrictionPart, DifferentialSlipPart>,
            DryLaw<ConstantFrictionPart, DifferentialSlipPart, RollingHysteresisPart, SpinPart>,
            DryLaw<ConstantFrictionPart, SlipSlicesPart, RollingHysteresisPart>>;
using LubricatedLaws =
    LawList<LubricatedLaw<>, LubricatedLaw<ConstantFrictionPart, TangentialSpringPart>,
            LubricatedLaw<ConstantFrictionPart, SmoothedFrictionPart>,
            LubricatedLaw<StribeckFrictionPart, TangentialSpringPart>,
            LubricatedLaw<StribeckFrictionPart, SmoothedFrictionPart>,
            LubricatedLaw<ConstantFrictionPart, DifferentialSlipPart>,
            RollingFriction<LubricatedLaw>, UniformSlip<LubricatedLaw>>;
using GapLaws = LawList<GapLaw<StribeckFrictionPart, TangentialSpringPart>,
                        GapLaw<StribeckFrictionPart, SmoothedFrictionPart>, RollingFriction<GapLaw>,
                        UniformSlip<GapLaw>>;
using FullLaws = LawList<FullLaw<>, FullLaw<StribeckFrictionPart, TangentialSpringPart>,
                         FullLaw<StribeckFrictionPart, SmoothedFrictionPart>,
                         RollingFriction<FullLaw>, UniformSlip<FullLaw>,
                         FullLaw<MixedFrictionPart, SlipSlicesPart, HydrodynamicRollingPart,
                                 RollingHysteresisPart, DragPart>>;
using Laws = decltype(joined(DryLaws(), LubricatedLaws(), GapLaws(), FullLaws()));

namespace detail {
template <class... P> constexpr unsigned parts_when(PartList<P...>, When when)
{
  return ((P::when == when ? Parts::bit<P>() : 0u) | ...);
}
template <class... P> constexpr unsigned parts_in(PartList<P...>, const char *slot)
{
  auto same = [](const char *a, const char *b) constexpr {
    while (*a && *a == *b) ++a, ++b;
    return *a == *b;
  };
  return ((same(P::slot, slot) ? Parts::bit<P>() : 0u) | ...);
}
template <class Own, class = void> struct Prepares : std::false_type {};
template <class Own>
struct Prepares<Own, decltype(std::declval<Own &>().prepare(std::declval<const Raceway &>()))>
    : std::true_type {};
template <class Own, class = void> struct Reaches : std::false_type {};
template <class Own>
struct Reaches<
    Own, std::void_t<decltype(std::declval<const Own &>().reach(std::declval<const Raceway &>()))>>
    : std::true_type {};
}    // namespace detail

constexpr unsigned dry_parts = detail::parts_when(Parts(), When::always);
constexpr unsigned lubricated_parts = dry_parts | detail::parts_when(Parts(), When::with_film);
constexpr unsigned friction_parts = detail::parts_in(Parts(), "friction");
constexpr unsigned tangential_parts = detail::parts_in(Parts(), "tangential");

// The set of parts that was asked for, completed: friction takes the spring if no keyword chose
// another tangential law, and without friction there is none.
constexpr unsigned completed(unsigned parts)
{
  if (!(parts & friction_parts)) return parts & ~tangential_parts;
  return parts & tangential_parts ? parts : parts | Parts::bit<TangentialSpringPart>();
}

// Everything about one raceway that does not change during a run.
struct RacewayPhysics : Raceway {
  unsigned parts = dry_parts;
  Parts::Parameters own;

  template <class Part> const typename Part::Parameters &of() const
  {
    return std::get<Parts::place<Part>()>(own);
  }
  template <class Part> typename Part::Parameters &of()
  {
    return std::get<Parts::place<Part>()>(own);
  }
  template <class Part> bool has() const { return parts & Parts::bit<Part>(); }
  // Switch a part on, and off what excludes it.
  template <class Part> void choose()
  {
    if (Part::slot[0]) parts &= ~detail::parts_in(Parts(), Part::slot);
    parts |= Parts::bit<Part>();
  }

  // pitch_radius (m) sets gamma; ball_mass (kg) the dashpot; overlap_limit is a fraction of R_b.
  void prepare(double pitch_radius, double mass, double overlap_limit)
  {
    Raceway::prepare(pitch_radius, mass, overlap_limit);
    parts = completed(parts);
    reach = 0.0;
    Parts::each([this](auto tag) { prepare_part<typename decltype(tag)::type>(); });
  }

 private:
  template <class Part> void prepare_part()
  {
    auto &one = of<Part>();
    using Own = typename Part::Parameters;
    if constexpr (detail::Prepares<Own>::value) one.prepare(*this);
    if constexpr (detail::Reaches<Own>::value)
      if (has<Part>()) reach = std::fmax(reach, one.reach(*this));
  }
};

// Calls f(law) with the compiled law that has these parts; false if there is none. f must be
// inlined where lanes are (RACEWAY_INLINE, lane.h).
namespace detail {
template <class F, class... L>
RACEWAY_INLINE bool with_law(unsigned parts, LawList<L...>, const F &f)
{
  return ((L::parts == parts && (f(L()), true)) || ...);
}
template <class... L> constexpr int most_states(LawList<L...>)
{
  int most = 0;
  ((most = L::states > most ? L::states : most), ...);
  return most;
}
}    // namespace detail
template <class F, class Family> RACEWAY_INLINE bool with_law(unsigned parts, Family, const F &f)
{
  return detail::with_law(parts, Family(), f);
}
template <class F> RACEWAY_INLINE bool with_law(unsigned parts, const F &f)
{
  return detail::with_law(parts, Laws(), f);
}
constexpr int most_states =
    detail::most_states(Laws());    // of any law: what a contact has room for

// Motions of a contact whose position is known and within reach. Returns whether there is no
// contact after all.
template <class L, class T>
RACEWAY_INLINE auto approach(const RacewayPhysics &p, const BallStateT<T> &ball,
                             const RingStateT<T> &ring, ContactStateT<T> &c)
{
  find_motions<L::couples>(p, ball, ring, c);
  if constexpr (L::decides) return L::misses(p, p.law.at(c.cos_angle), c);
  else return std::false_type();
}

// Motions, and what law L makes of them, of a contact.
template <class L, class T>
RACEWAY_INLINE void act(const RacewayPhysics &p, const BallStateT<T> &ball,
                        const RingStateT<T> &ring, const LawStates<T> &memory, ContactStateT<T> &c)
{
  approach<L>(p, ball, ring, c);
  L::act(p, p.law.at(c.cos_angle), memory, c);
}

template <class L, class T>
RACEWAY_INLINE ContactForcesT<T> contact_forces(const RacewayPhysics &p, const BallStateT<T> &ball,
                                                const RingStateT<T> &ring,
                                                const LawStates<T> &memory, ContactStateT<T> &c)
{
  act<L>(p, ball, ring, memory, c);
  return assemble<L::couples>(p, ring.e, c);
}

}    // namespace raceway

#endif
