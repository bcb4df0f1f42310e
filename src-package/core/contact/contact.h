// SPDX-License-Identifier: GPL-2.0-or-later
// The parts of the contact law, and the laws that are compiled as a whole. All other sets of parts
// are evaluated by any_law.h.
#pragma once

#include "../parts/part_damping.h"
#include "../parts/part_differential_slip.h"
#include "../parts/part_drag.h"
#include "../parts/part_film.h"
#include "../parts/part_film_branch.h"
#include "../parts/part_film_gap.h"
#include "../parts/part_friction.h"
#include "../parts/part_hertz.h"
#include "../parts/part_mixed_friction.h"
#include "../parts/part_rolling.h"
#include "../parts/part_slip_slices.h"
#include "../parts/part_spin.h"
#include "../raceway/kinematics.h"
#include "../raceway/raceway_physics.h"
#include "law.h"

namespace raceway {

// The parts act in this order, so that each part comes after the parts whose results it uses. The
// order also defines the bits in a set of parts and the order of the tables in the docs.
using Parts =
    PartList<HertzContactPart, FilmInGapPart, HysteresisPart, FilmThicknessPart, FilmDamperPart,
             NormalForcePart, FilmBranchPart, ConstantFrictionPart, StribeckFrictionPart,
             MixedFrictionPart, TangentialSpringPart, SmoothedFrictionPart, DifferentialSlipPart,
             SlipSlicesPart, HydrodynamicRollingPart, RollingHysteresisPart, SpinPart, DragPart>;

template <class... P> using Law = LawOf<Parts, P...>;
template <class... P> using DryLaw = Law<HertzContactPart, HysteresisPart, NormalForcePart, P...>;
template <class... P>
using LubricatedLaw =
    Law<HertzContactPart, HysteresisPart, FilmThicknessPart, FilmDamperPart, NormalForcePart, P...>;
template <class... P>
using FullLaw =
    Law<FilmInGapPart, HysteresisPart, FilmThicknessPart, NormalForcePart, FilmBranchPart, P...>;

template <class... L> struct LawList {};

// The laws in inputs/models; for each of them, a loop over contacts with the law inlined is
// compiled. This list affects only the speed, not the results.
using DryLaws = LawList<DryLaw<ConstantFrictionPart, TangentialSpringPart>,
                        DryLaw<ConstantFrictionPart, SmoothedFrictionPart>>;
using PaperLaws = LawList<LubricatedLaw<StribeckFrictionPart, TangentialSpringPart>,
                          LubricatedLaw<StribeckFrictionPart, SmoothedFrictionPart>>;
using FilmLaws = LawList<FullLaw<StribeckFrictionPart, TangentialSpringPart>,
                         FullLaw<StribeckFrictionPart, SmoothedFrictionPart>>;
using FullLaws = LawList<FullLaw<MixedFrictionPart, DifferentialSlipPart, HydrodynamicRollingPart,
                                 RollingHysteresisPart, SpinPart, DragPart>>;

// Calls f(law) if one of the laws in the list has exactly these parts; otherwise returns false. f
// must be inlined where lanes are used (RACEWAY_INLINE, lane.h).
template <class F, class... L>
RACEWAY_INLINE bool with_law(unsigned parts, LawList<L...>, const F &f)
{
  return ((L::parts == parts && (f(L()), true)) || ...);
}

// Parameters of all parts.
struct PartNumbers {
  Parts::Parameters of;
};

template <class Part> const typename Part::Parameters &RacewayPhysics::of() const
{
  return std::get<Parts::place<Part>()>(own_->of);
}
template <class Part> typename Part::Parameters &RacewayPhysics::of()
{
  return std::get<Parts::place<Part>()>(own_->of);
}
template <class Part> bool RacewayPhysics::has() const { return parts & Parts::bit<Part>(); }
template <class Part> void RacewayPhysics::choose()
{
  if (Part::slot[0]) parts &= ~Parts::in_slot(Part::slot);
  parts |= Parts::bit<Part>();
}

static_assert(Parts::most_states() <= most_states, "raceway_physics.h: most_states is too small");

}    // namespace raceway
