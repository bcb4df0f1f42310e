// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_profile.h"

#include "../core/settings/arguments.h"
#include "../ranks/gather.h"
#include "fix_bearing_ring.h"
#include "fix_bearing_state.h"
#include "fixes.h"
#include "own_group.h"
#include "pair_bearing_hertz.h"

#include <algorithm>

using namespace LAMMPS_NS;
using bearing::Arguments;
using bearing::name_of;
using bearing::own_group;
using bearing::text;
using raceway::BallPitShape;
using raceway::BallShape;
using raceway::NotchShape;
using raceway::ProfileShape;
using raceway::RacewayPhysics;
using raceway::Wave;

template <class T> static void append(std::vector<T> &to, const std::vector<T> &more)
{
  to.insert(to.end(), more.begin(), more.end());
}

// Writes a word as it would appear in a deck, i.e. in quotes if it contains blanks.
static std::string quoted(const std::string &word)
{
  if (word.find_first_of(" \t") == std::string::npos) return word;
  const char mark = word.find('"') == std::string::npos ? '"' : '\'';
  return mark + word + mark;
}

// fix ID group bearing/profile [groove K] [notch AZIMUTH LENGTH WIDTH|full DEPTH EDGE] ...
// [wave ORDER AMPLITUDE PHASE] ... [file NAME] ..., or none, or
// ball [pit AZIMUTH LATITUDE LENGTH WIDTH DEPTH EDGE] ... [wave ORDER AMPLITUDE PHASE] ...
// [file NAME] ...|none; these words also after flaw_inner, flaw_outer, or flaw_ball ...
// [flawed_ball ID ...]
FixBearingProfile::FixBearingProfile(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg)
{
  PairBearingHertz::find(lmp, "fix bearing/profile");
  Arguments args(lmp, bearing::name_of(*this), narg, arg, 3);
  if (!args.more() && narg == 3) args.fail("a profile needs 'notch', 'wave', 'file' or 'none'");
  std::vector<std::string> said;
  settings_ = bearing::ProfileSettings::read(args, FixBearingState::max_grooves, said);
  for (const std::string &word : said) said_ += (said_.empty() ? "" : " ") + quoted(word);
  if (settings_.flawed.empty()) return;
  const std::string group_of = std::string(id) + "_BALLS";
  std::string line = "group " + group_of + " id";
  for (const std::string &ball : settings_.flawed) line += " " + ball;
  const int flawed = group->bitmask[own_group(lmp, group_of, [](int) { return false; })];
  input->one(line.c_str());
  const int both = flawed | groupbit;
  const auto in_both = [&](int i) { return (atom->mask[i] & both) == both; };
  igroup = own_group(lmp, group_of, in_both);
  groupbit = group->bitmask[igroup];
}

int FixBearingProfile::setmask() { return of_balls() && departs() ? FixConst::PRE_FORCE : 0; }

std::vector<FixBearingProfile::Flawed> FixBearingProfile::bodies(PairBearingHertz &pair) const
{
  const bearing::PairCoefficients &all = pair.coefficients();
  std::vector<Flawed> mine;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    if (of_balls() ? !all.is_ball(atom->type[i]) : !all.is_ring(atom->type[i]))
      BRG_ONE(name_of(*this) + ": atom " + std::to_string(atom->tag[i]) + " of group " +
              group->names[igroup] + " is of type " + std::to_string(atom->type[i]) +
              ", which no pair_coeff " +
              (of_balls() ? "puts on a raceway as a ball" : "names as a ring"));
    bool alone = norm(raceway::Vec3::from(atom->omega[i])) > 0.0;
    for (const FixBearingRing *r : bearing::fixes_of<FixBearingRing>(lmp))
      alone = alone && !r->moves(i);
    mine.push_back({atom->tag[i], atom->type[i], alone});
  }
  mine = bearing::gather_all(mine, world);
  if (mine.empty())
    BRG_ALL(name_of(*this) + ": missing " + (of_balls() ? "ball" : "ring") + ", group " +
            group->names[igroup] + " is empty");
  return mine;
}

// Stops with an error if a ball cannot follow the notch.
void FixBearingProfile::check_notch(const NotchShape &n, const char *what, double rolling) const
{
  const double most = std::min(0.5 * n.length, std::sqrt(2.0 * rolling * n.depth));
  if (!(n.edge < most))
    BRG_ALL(name_of(*this) + ": edge of the " + what + " (m) is " + text(n.edge) +
            ", must be below " + text(most) +
            ": half the length, or the distance in which a ball reaches the bottom");
}

void FixBearingProfile::check_wave(const Wave &w, double radius, double rolling) const
{
  const double most = 0.1 * radius * radius / (double(w.order) * w.order * rolling);
  if (!(w.amplitude < most))
    BRG_ALL(name_of(*this) + ": amplitude of the wave (m) of order " + std::to_string(w.order) +
            " is " + text(w.amplitude) + ", must be below " + text(most) +
            ": a tenth of the ball's curvature");
}

void FixBearingProfile::check(const RacewayPhysics &p) const
{
  const double R = p.groove.raceway_radius, rolling = p.rolling_radius(1.0);
  for (const NotchShape &n : settings_.raceway.notches) {
    if (!(n.length < M_PI * R))
      BRG_ALL(name_of(*this) + ": length of the notch (m) is " + text(n.length) +
              ", must be below half the raceway's circumference, " + text(M_PI * R));
    check_notch(n, "notch", rolling);
  }
  for (const Wave &w : settings_.raceway.waves) check_wave(w, R, rolling);
}

void FixBearingProfile::check_ball(const RacewayPhysics &p) const
{
  const double R = p.groove.ball_radius, rolling = p.rolling_radius(1.0);
  for (const BallPitShape &n : settings_.ball.pits) {
    for (const auto &size : {std::make_pair("length", n.length * (1.0 / std::cos(n.latitude))),
                             std::make_pair("width", n.width)})
      if (!(size.second < R))
        BRG_ALL(name_of(*this) + ": " + size.first + " of the pit (m) is " + text(size.second) +
                " on the equator, must be below the ball's radius, " + text(R));
    check_notch(n, "pit", rolling);
  }
  for (const Wave &w : settings_.ball.waves) check_wave(w, R, rolling);
}

void FixBearingProfile::check_pits(bearing::tag_t ring, const ProfileShape &shape,
                                   const RacewayPhysics &p) const
{
  const std::vector<NotchShape> &all = shape.notches;
  for (size_t i = 0; i < all.size(); ++i)
    for (size_t k = i + 1; k < all.size(); ++k) {
      if (all[i].width == HUGE_VAL || all[k].width == HUGE_VAL) continue;
      const double apart = std::fabs(std::remainder(all[i].azimuth - all[k].azimuth, 2.0 * M_PI)) *
                           p.groove.raceway_radius;
      if (apart < 0.5 * (all[i].length + all[k].length))
        BRG_ALL(name_of(*this) + ": two notches with a width overlap on ring " +
                std::to_string(ring) + ", at " + text(all[i].azimuth) + " and " +
                text(all[k].azimuth) +
                " rad; give the longer one the width 'full', or replace them by one notch");
    }
}

// The first fix of this style combines all profiles and passes them to the pair style.
void FixBearingProfile::init()
{
  const std::vector<FixBearingProfile *> all = bearing::fixes_of<FixBearingProfile>(lmp);
  PairBearingHertz &pair = *PairBearingHertz::find(lmp, "fix bearing/profile");
  if (departs()) pair.state()->follow_axes();
  if (all.front() == this) {
    add_rings(pair, all);
    add_balls(pair, all);
  }
  const auto first = std::find_if(all.begin(), all.end(), [](const FixBearingProfile *f) {
    return f->of_balls() && f->departs();
  });
  turns_ = first != all.end() && *first == this;
}

void FixBearingProfile::add_rings(PairBearingHertz &pair,
                                  const std::vector<FixBearingProfile *> &all) const
{
  std::map<bearing::tag_t, std::map<const RacewayPhysics *, ProfileShape>> sums;
  for (const FixBearingProfile *f : all) {
    if (f->of_balls() || !f->departs()) continue;
    for (const Flawed &r : f->bodies(pair)) {
      if (r.turns_alone)
        BRG_ALL(name_of(*f) + ": ring " + std::to_string(r.tag) +
                " spins without a fix bearing/ring, which tracks its angle");
      bool found = false;
      for (const RacewayPhysics *p : pair.coefficients().raceways_of(r.type)) {
        if (p->number != f->settings_.groove) continue;
        found = true;
        f->check(*p);
        ProfileShape &s = sums[r.tag][p];
        const ProfileShape &own = f->settings_.raceway;
        append(s.notches, own.notches);
        append(s.waves, own.waves);
        append(s.tables, own.tables);
        f->check_pits(r.tag, s, *p);
      }
      if (!found)
        BRG_ALL(name_of(*f) + ": ring " + std::to_string(r.tag) + " has no groove " +
                std::to_string(f->settings_.groove));
    }
  }
  for (const auto &ring : sums)
    for (const auto &one : ring.second) pair.profiles().add(ring.first, one.first, one.second);
}

void FixBearingProfile::add_balls(PairBearingHertz &pair,
                                  const std::vector<FixBearingProfile *> &all) const
{
  const auto has_pit = [](const NotchShape &n) { return n.width < HUGE_VAL; };
  const bool ring_pits = std::any_of(all.begin(), all.end(), [&](const FixBearingProfile *f) {
    return std::any_of(f->settings_.raceway.notches.begin(), f->settings_.raceway.notches.end(),
                       has_pit);
  });
  std::map<bearing::tag_t, std::map<const RacewayPhysics *, BallShape>> sums;
  for (const FixBearingProfile *f : all) {
    if (!f->of_balls() || !f->departs()) continue;
    if (ring_pits && !f->settings_.ball.pits.empty())
      BRG_ALL(name_of(*f) +
              ": a ball with a pit cannot meet a notch of a raceway that has a width; "
              "give the notch the width 'full'");
    for (const Flawed &b : f->bodies(pair))
      for (const RacewayPhysics *p : pair.coefficients().raceways_under(b.type)) {
        f->check_ball(*p);
        BallShape &s = sums[b.tag][p];
        append(s.pits, f->settings_.ball.pits);
        append(s.waves, f->settings_.ball.waves);
        append(s.tables, f->settings_.ball.tables);
        f->check_apart(b.tag, s, p->groove.ball_radius);
      }
  }
  for (const auto &ball : sums)
    for (const auto &one : ball.second) pair.profiles().add(ball.first, one.first, one.second);
}

// Stops with an error if two pits overlap in azimuth, because the effects of their strips on one
// contact would not be additive.
void FixBearingProfile::check_apart(bearing::tag_t ball, const BallShape &shape,
                                    double radius) const
{
  const std::vector<BallPitShape> &all = shape.pits;
  for (size_t i = 0; i < all.size(); ++i)
    for (size_t k = i + 1; k < all.size(); ++k) {
      const double apart = std::fabs(std::remainder(all[i].azimuth - all[k].azimuth, 2.0 * M_PI)),
                   far = 0.5 * (all[i].length / std::cos(all[i].latitude) +
                                all[k].length / std::cos(all[k].latitude));
      if (apart * radius < far)
        BRG_ALL(name_of(*this) + ": two pits of ball " + std::to_string(ball) +
                " overlap in azimuth, at " + text(all[i].azimuth) + " and " + text(all[k].azimuth) +
                " rad; a contact may meet only one at a time");
    }
}

// With velocity Verlet, each ball is rotated over a step by its mid-step spin. Fix bearing/implicit
// rotates its balls itself.
void FixBearingProfile::pre_force(int)
{
  if (!turns_) return;
  PairBearingHertz &pair = *PairBearingHertz::find(lmp, "fix bearing/profile");
  const raceway::LabAxes axes = {pair.coefficients().axis_index()};
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!pair.coefficients().is_ball(atom->type[i]) || pair.is_implicit(i)) continue;
    raceway::Quaternion &turn = pair.state()->turn(i);
    const raceway::Vec3 spin = axes.third(raceway::Vec3::from(atom->omega[i]));
    turn = (raceway::Quaternion::by(spin * update->dt) * turn).normal();
  }
}
