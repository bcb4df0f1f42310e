// SPDX-License-Identifier: GPL-2.0-or-later
#include "../raceway/raceway_physics.h"

#include "contact.h"

namespace raceway {

namespace {

template <class Own, class = void> struct Prepares : std::false_type {};
template <class Own>
struct Prepares<Own, decltype(std::declval<Own &>().prepare(std::declval<const Raceway &>()))>
    : std::true_type {};
template <class Own, class = void> struct Reaches : std::false_type {};
template <class Own>
struct Reaches<
    Own, std::void_t<decltype(std::declval<const Own &>().reach(std::declval<const Raceway &>()))>>
    : std::true_type {};

template <class... P> constexpr unsigned parts_when(PartList<P...>, When when)
{
  return ((P::when == when ? Parts::bit<P>() : 0u) | ...);
}

// Friction includes the tangential spring unless a keyword selects another tangential law. A law
// without friction has no tangential law.
unsigned completed(unsigned parts)
{
  const unsigned friction = Parts::in_slot("friction"), tangential = Parts::in_slot("tangential");
  if (!(parts & friction)) return parts & ~tangential;
  return parts & tangential ? parts : parts | Parts::bit<TangentialSpringPart>();
}

template <class Part> void add_facts(unsigned parts, LawFacts &f)
{
  if (!(parts & Parts::bit<Part>())) return;
  f.states += Part::states;
  f.couples |= Part::couples;
  f.decides |= detail::Decides<Part>::value;
  f.explicit_step |= Part::explicit_step;
}

template <class Part> bool has(unsigned parts) { return parts & Parts::bit<Part>(); }

}    // namespace

unsigned initial_parts(bool lubricated)
{
  constexpr unsigned dry = parts_when(Parts(), When::always);
  return lubricated ? dry | parts_when(Parts(), When::with_film) : dry;
}

LawFacts law_facts(unsigned parts)
{
  LawFacts f;
  Parts::each([&](auto tag) { add_facts<typename decltype(tag)::type>(parts, f); });
  f.film = has<FilmThicknessPart>(parts);
  f.film_in_gap = has<FilmInGapPart>(parts);
  f.asperities = has<MixedFrictionPart>(parts);
  f.tangential_spring = has<TangentialSpringPart>(parts);
  f.spin = has<SpinPart>(parts) || has<SlipSlicesPart>(parts);
  return f;
}

RacewayPhysics::RacewayPhysics() : parts(initial_parts(false)), own_(new PartNumbers) {}
RacewayPhysics::RacewayPhysics(const RacewayPhysics &o) :
    Raceway(o), parts(o.parts), own_(new PartNumbers(*o.own_))
{
}
RacewayPhysics::RacewayPhysics(RacewayPhysics &&) noexcept = default;
RacewayPhysics &RacewayPhysics::operator=(const RacewayPhysics &o)
{
  return *this = RacewayPhysics(o);
}
RacewayPhysics &RacewayPhysics::operator=(RacewayPhysics &&) noexcept = default;
RacewayPhysics::~RacewayPhysics() = default;

void RacewayPhysics::prepare(double pitch_radius, double mass, double overlap_limit)
{
  Raceway::prepare(pitch_radius, mass, overlap_limit);
  parts = completed(parts);
  reach = 0.0;
  Parts::each([this](auto tag) {
    using Part = typename decltype(tag)::type;
    using Own = typename Part::Parameters;
    Own &one = of<Part>();
    if constexpr (Prepares<Own>::value) one.prepare(*this);
    if constexpr (Reaches<Own>::value)
      if (has<Part>()) reach = std::fmax(reach, one.reach(*this));
  });
}

double RacewayPhysics::gap_share() const { return of<FilmInGapPart>().share; }
bool RacewayPhysics::gap_film_of_all_regimes() const
{
  return has<FilmInGapPart>() && of<FilmInGapPart>().all_regimes;
}

void RacewayPhysics::smooth_friction(double creep)
{
  choose<SmoothedFrictionPart>();
  of<SmoothedFrictionPart>().creep = creep;
}

}    // namespace raceway
