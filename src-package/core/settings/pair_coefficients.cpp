// SPDX-License-Identifier: GPL-2.0-or-later
#include "pair_coefficients.h"

#include "../contact/part_table.h"
#include "../laws/damped_hertz.h"
#include "raceway_options.h"

#include <algorithm>

using namespace raceway;

namespace bearing {

double PairCoefficients::Spheres::stiffness(double R1, double R2) const
{
  return factor * sphere_stiffness(R1, R2, reduced_modulus(E1, nu1, E2, nu2));
}

PairCoefficients::PairCoefficients(bool with_film) : with_film_(with_film)
{
  if (with_film) defaults_.parts = initial_parts(true);
}

void PairCoefficients::read_style(Arguments &args)
{
  *this = PairCoefficients(with_film_);
  while (args.more()) {
    if (args.take("axis")) axis_ = args.choice("axis", {"x", "y", "z"});
    else if (!args.within("overlap_limit", overlap_limit_, "overlap_limit", 1e-4, 0.5) &&
             !read_raceway_keyword(args, with_film_, defaults_))
      args.unknown();
  }
}

void PairCoefficients::read_coeff(Arguments &args, int types)
{
  const int i = args.integer("first type", 1, types), j = args.integer("second type", 1, types);
  const int role = args.choice("role", {"inner", "outer", "sphere", "cage", "grain"});
  if (role != 4)
    for (const int type : {i, j})
      if (is_grain(type))
        args.fail("type " + std::to_string(type) + " is a grain and cannot belong to a bearing");
  if (role == 2) return read_spheres(args, i, j);
  if (role == 3) return read_cage(args, i, j, types);
  if (role == 4) return read_grains(args, i, j);
  if (i == j) args.fail("ball and ring need different atom types");
  if (raceway(j, i))
    args.fail("the ball type must come first, but it comes second in an earlier pair_coeff");
  RacewayPhysics p = defaults_;
  p.groove.side = role == 0 ? Side::inner : Side::outer;
  p.groove.raceway_radius = args.positive("raceway radius (m)");
  p.groove.groove_radius = args.positive("groove radius (m)");
  if (p.groove.groove_radius >= p.groove.raceway_radius)
    args.fail("groove radius " + text(p.groove.groove_radius) +
              " must be smaller than the raceway radius " + text(p.groove.raceway_radius));
  double arch = 0.0;
  while (args.more())
    if (!args.positive("gothic_arch", arch,
                       "distance of the groove centres from the ring's middle plane (m)") &&
        !read_raceway_keyword(args, with_film_, p))
      args.unknown();
  if (with_film_ && p.model.lubricant.viscosity == 0.0)
    args.fail("bearing/ehd needs 'lubricant VISCOSITY PRESSURE_VISCOSITY' here or in pair_style; "
              "without a lubricant use bearing/hertz");
  if (with_film_ && p.ring_roughness == 0.0)
    args.fail(
        "bearing/ehd needs 'roughness RACEWAY BALL' (m) here or in pair_style: it determines the "
        "lambda ratio and the floor of the film damper");
  p.groove.offset = -arch;
  raceways_[{i, j, 0}] = p;
  if (arch > 0.0) {    // a raceway that exists keeps its address, which tables of contacts hold
    p.number = 1;
    p.groove.offset = arch;
    raceways_[{i, j, 1}] = p;
  } else {
    raceways_.erase({i, j, 1});
  }
  ball_type_.resize(types + 1);
  ring_type_.resize(types + 1);
  ball_type_[i] = ring_type_[j] = 1;
  if (ball_type_[j] || ring_type_[i] || is_cage(j))
    args.fail("a type can be only one of ball, ring and cage");
}

void PairCoefficients::read_cage(Arguments &args, int ball, int cage, int types)
{
  ring_type_.resize(types + 1);
  ball_type_.resize(types + 1);
  cage_type_.resize(types + 1);
  if (!ball_type_[ball])
    args.fail("type " + std::to_string(ball) + " is not a ball: its raceways must come first");
  if (ball_type_[cage] || !raceways_of(cage).empty())
    args.fail("type " + std::to_string(cage) + " is a ball or a ring with a raceway already");
  ring_type_[cage] = cage_type_[cage] = 1;
  if (args.more()) args.unknown("none, the command ends here");
}

void PairCoefficients::read_spheres(Arguments &args, int i, int j)
{
  Spheres s;
  s.E1 = args.within("Young's modulus of the first type (Pa)", raceway::LEAST_YOUNG,
                     raceway::LARGEST_YOUNG);
  s.nu1 = args.within("Poisson's ratio of the first type", 0.0, 0.5);
  s.E2 = args.within("Young's modulus of the second type (Pa)", raceway::LEAST_YOUNG,
                     raceway::LARGEST_YOUNG);
  s.nu2 = args.within("Poisson's ratio of the second type", 0.0, 0.5);
  // eq. 3 as printed has an extra factor 1/(1 - nu), with nu of the rolling ball, which is the
  // first type
  s.factor = args.take("printed") ? 1.0 / (1.0 - s.nu1) : 1.0;
  if (args.more()) args.unknown();
  spheres_[std::minmax(i, j)] = s;
}

bool take_grain_keyword(Arguments &args, GrainLaw &law)
{
  return args.positive("stiffness", law.stiffness, "stiffness (N/m)") ||
         args.within("restitution", law.restitution, "coefficient of restitution", 0.01, 1.0) ||
         args.non_negative("friction", law.friction, "coefficient of friction");
}

void PairCoefficients::read_grains(Arguments &args, int i, int j)
{
  GrainLaw law;
  while (args.more())
    if (!take_grain_keyword(args, law)) args.unknown();
  if (law.stiffness == 0.0) args.fail("'stiffness K' (N/m) of the grains is missing");
  for (const int type : {i, j})
    if (is_named(type))
      args.fail("type " + std::to_string(type) + " belongs to a bearing and cannot be a grain");
  grains_[std::minmax(i, j)] = law;
  grain_type_.insert({i, j});
}

const GrainLaw *PairCoefficients::grains(int type_1, int type_2) const
{
  const auto it = grains_.find(std::minmax(type_1, type_2));
  return it == grains_.end() ? nullptr : &it->second;
}

bool PairCoefficients::is_named(int type) const
{
  return is_ring(type) || is_ball(type) ||
         std::any_of(spheres_.begin(), spheres_.end(), [type](const auto &s) {
           return s.first.first == type || s.first.second == type;
         });
}

int PairCoefficients::sides_of(int ball_type) const
{
  int sides = 0;
  for (const RacewayPhysics *p : raceways_under(ball_type))
    sides |= p->groove.side == Side::inner ? 1 : 2;
  return sides;
}

const RacewayPhysics *PairCoefficients::raceway(int ball_type, int ring_type, int groove) const
{
  const auto it = raceways_.find({ball_type, ring_type, groove});
  return it == raceways_.end() ? nullptr : &it->second;
}

std::vector<const RacewayPhysics *> PairCoefficients::raceways_of(int ring_type) const
{
  std::vector<const RacewayPhysics *> list;
  for (const auto &r : raceways_)
    if (r.first.ring == ring_type) list.push_back(&r.second);
  return list;
}

std::vector<const RacewayPhysics *> PairCoefficients::raceways_under(int ball_type) const
{
  std::vector<const RacewayPhysics *> list;
  for (const auto &r : raceways_)
    if (r.first.ball == ball_type) list.push_back(&r.second);
  return list;
}

bool PairCoefficients::many_grooves() const
{
  return std::any_of(raceways_.begin(), raceways_.end(),
                     [](const auto &entry) { return entry.first.number > 0; });
}

double PairCoefficients::pitch_radius(int ring_type) const
{
  for (const auto &own : raceways_) {
    if (own.first.ring != ring_type) continue;
    const Groove &g = own.second.groove;
    for (const RacewayPhysics *other : raceways_under(own.first.ball))
      if (other->groove.side != g.side)
        return 0.5 * (g.raceway_radius + other->groove.raceway_radius);
    return g.raceway_radius + (g.side == Side::inner ? 1.0 : -1.0) * g.ball_radius;
  }
  return 0.0;
}

const PairCoefficients::Spheres *PairCoefficients::spheres(int type_1, int type_2) const
{
  const auto it = spheres_.find(std::minmax(type_1, type_2));
  return it == spheres_.end() ? nullptr : &it->second;
}

void PairCoefficients::set_law(unsigned parts)
{
  law_ = parts;
  facts_ = law_facts(parts);
}

std::string PairCoefficients::prepare_again()
{
  const std::string wrong = prepare(TypeSizes(sizes_));
  if (wrong.empty() && creep_ > 0.0) smooth_friction(creep_);
  return wrong;
}

void PairCoefficients::grow(int ball_type, double inner_ring, double balls, double outer_ring)
{
  for (auto &entry : raceways_)
    if (entry.first.ball == ball_type)
      entry.second.grow(entry.second.groove.side == Side::inner ? inner_ring : outer_ring, balls);
}

bool PairCoefficients::smooth_friction(double creep)
{
  bool changed = false;
  creep_ = creep;
  for (auto &entry : raceways_) {
    RacewayPhysics &p = entry.second;
    if (!p.facts().tangential_spring) continue;
    p.smooth_friction(creep);
    set_law(p.parts);
    changed = true;
  }
  return changed;
}

// A ball is a neighbour of a ring if it touches the groove or has moved beyond it by up to half a
// ball radius. Ghosts are needed only up to that distance. Spheres touch at the sum of their radii.
double PairCoefficients::cutoff(int i, int j) const
{
  // balls of the same type are neighbours, so that overlapping balls can be rejected at the start
  if (i == j && is_ball(i)) return 2.0 * sizes_.largest[i];
  if (spheres(i, j) || grains(i, j)) return sizes_.largest[i] + sizes_.largest[j];
  const RacewayPhysics *p = raceway(j, i);
  if (!p) p = raceway(i, j);
  if (!p) return 0.0;
  const double R = p->groove.ball_radius;
  return p->centre_circle + p->groove.groove_radius - R + std::max(0.5, overlap_limit_) * R;
}

double PairCoefficients::reach() const
{
  double reach = 0.0;
  for (const auto &r : raceways_)
    reach = std::max(reach, r.second.groove.raceway_radius + r.second.groove.groove_radius);
  return reach;
}

static std::string name_of(int ball, int ring)
{
  return "pair_coeff " + std::to_string(ball) + " " + std::to_string(ring);
}

std::string PairCoefficients::prepare(const TypeSizes &sizes)
{
  sizes_ = sizes;
  bool first = true;
  for (auto &entry : raceways_) {
    const int ball = entry.first.ball;
    RacewayPhysics &p = entry.second;
    if (!is_there(entry.first)) continue;
    p.groove.ball_radius = sizes.largest[ball];
    const std::string who = name_of(ball, entry.first.ring) + ": ";
    std::string wrong = wrong_size(entry.first, p);
    if (!wrong.empty()) return who + wrong;
    p.prepare(p.groove.raceway_radius +
                  (p.groove.side == Side::inner ? 1.0 : -1.0) * p.groove.ball_radius,
              sizes.mass[ball], overlap_limit_);
    if (!first && p.parts != law_)
      return who + "all raceways of a run share one contact law (its numbers may differ); here " +
             law_text(p.parts) + ", before " + law_text(law_);
    set_law(p.parts);
    wrong = contradiction(law_);
    if (!wrong.empty()) return who + wrong;
    first = false;
  }
  return wrong_rings();
}

// Returns false if the bearing of a pair_coeff is not in the box.
bool PairCoefficients::is_there(const GrooveName &of) const
{
  return sizes_.count[of.ball] > 0 || sizes_.count[of.ring] > 0;
}

std::string wrong_groove(const Groove &g)
{
  const double R = g.ball_radius;
  if (!(g.groove_radius > R * (1.0 + 1e-9)))
    return "groove radius " + text(g.groove_radius) + " m must be larger than the ball radius " +
           text(R) + " m (a conformal groove is not a Hertz point contact)";
  if (std::fabs(g.offset) >= g.slack())
    return "gothic_arch " + text(std::fabs(g.offset)) +
           " m must be smaller than the groove radius minus the ball radius, " + text(g.slack()) +
           " m: otherwise a ball does not fit between both grooves";
  return "";
}

// The radius and the mass of the balls are those of the atoms; all balls of a type have the same
// size.
std::string PairCoefficients::wrong_size(const GrooveName &of, const RacewayPhysics &p) const
{
  const double R = sizes_.largest[of.ball], smallest = sizes_.smallest[of.ball];
  const Groove &g = p.groove;
  const std::string type = std::to_string(of.ball);
  if (R == 0.0) return "there is no ball of type " + type;
  if (R - smallest > 1e-12 * R)
    return "balls of type " + type + " have radii from " + text(smallest) + " to " + text(R) +
           " m; give each size its own type";
  if (const std::string wrong = wrong_groove(g); !wrong.empty()) return wrong;
  if (g.side == Side::outer && !(g.raceway_radius - R > R))
    return "raceway radius " + text(g.raceway_radius) +
           " m leaves no pitch circle for balls of radius " + text(R) + " m";
  return "";
}

// A ball type has at most one inner and one outer ring type, and the ball must fit between them.
std::string PairCoefficients::wrong_rings() const
{
  for (const auto &a : raceways_) {
    const int ball = a.first.ball, ring = a.first.ring;
    if (!is_there(a.first)) continue;
    if (sizes_.count[ring] == 0)
      return "missing ring: " + name_of(ball, ring) + " names ring type " + std::to_string(ring) +
             ", but no atom has that type";
    for (const auto &b : raceways_) {
      if (b.first.ball != ball || b.first.ring == ring) continue;
      const Groove &in = a.second.groove, &out = b.second.groove;
      if (in.side == Side::inner && out.side == Side::outer &&
          in.raceway_radius >= out.raceway_radius)
        return "two rings at odds: inner raceway radius " + text(in.raceway_radius) + " m (type " +
               std::to_string(ring) + ") is not smaller than the outer one, " +
               text(out.raceway_radius) + " m (type " + std::to_string(b.first.ring) + ")";
    }
  }
  return "";
}

}    // namespace bearing
