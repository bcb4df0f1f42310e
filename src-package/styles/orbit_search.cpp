// SPDX-License-Identifier: GPL-2.0-or-later
#include "orbit_search.h"

#include "fix_bearing_ring.h"
#include "fixes.h"
#include "orbit_balls.h"

#include <algorithm>
#include <numeric>

namespace bearing {

// Number of ball passes without progress after which the bearing is assumed to have no orbit. This
// occurs if balls touch the cage or one another at different positions in every ball pass.
static constexpr double patience = 5.0;
static constexpr double most_jumps = 8.0;
// A jump is useful if ordinary ball passes would take longer than this to reach the orbit. A jump
// itself takes one ball pass in which the fast modes settle.
static constexpr double soon = 3.0;
// Slower decays cannot be distinguished from noise (settling_rest.h).
static constexpr double slowest = 0.98;
// A ball pass counts as progress if its residual is below this fraction of the smallest one so far.
static constexpr double less = 0.7;
// Smaller residuals, in units of `settled`, are no progress.
static constexpr double close = 0.1;

// Balls that leave the load zone change their places in the pockets for about a turn of the cage,
// and a shaft vibrates. The search follows the places, and damps the vibration, with coarse steps.
void OrbitSearch::begin(LAMMPS_NS::LAMMPS *lmp)
{
  const OrbitBalls balls(lmp);
  start_ = balls.by_slot(0.0);
  const auto rings = fixes_of<LAMMPS_NS::FixBearingRing>(lmp);
  const bool shaft =
      std::any_of(rings.begin(), rings.end(), [](const auto *f) { return f->shaft() != 0; });
  now_.steps = shaft || !balls.all_loaded() ? COARSE : DECK;
}

void OrbitSearch::end_pass(LAMMPS_NS::LAMMPS *lmp, const SettlingChanges &changes, double settled)
{
  const OrbitBalls balls(lmp);
  now_.passes += 1.0;
  std::vector<double> end = balls.by_slot(now_.passes);
  const std::vector<double> advance = balls.advance(start_, end);
  const auto [slowest_row, fastest_row] = std::minmax_element(advance.begin(), advance.end());
  const double mean = std::accumulate(advance.begin(), advance.end(), 0.0) / advance.size();
  now_.apart = (*fastest_row - *slowest_row) / std::fabs(mean);
  now_.stretch = std::min(2.0, std::max(0.5, balls.spacing() / std::fabs(mean)));
  const bool only_follows = now_.jumped != 0.0;
  now_.jumped = 0.0;
  if (!only_follows) judge(balls, end, changes, settled);
  now_.values = only_follows || now_.jumped != 0.0 ? 0.0 : now_.values + 1.0;
  // if only places in the pockets change, they may do so for a turn of the cage
  const double wait =
      now_.residual <= close * settled ? std::max(patience, double(balls.balls_a_row())) : patience;
  if (now_.stage == ON && now_.passes - now_.best_pass >= wait) now_.stage = NONE;
  start_ = now_.jumped != 0.0 ? OrbitBalls(lmp).by_slot(now_.passes) : end;
}

// Returns true if the last ball pass repeats the previous one. Places in the pockets may leave a
// noise that is larger than a steady state requires, but smaller than what counts as settled. The
// torque of coarse steps differs from that of the deck's steps, even on the orbit.
bool OrbitSearch::repeats(const SettlingChanges &changes, double distance, double settled)
{
  const auto at_most = [&](double share) {
    const double most = share * settled, torque = now_.steps == FIRST_OF_DECK ? HUGE_VAL : most;
    return changes.within({torque, most, most, settled, 1.0});
  };
  now_.quiet = at_most(0.5) ? now_.quiet + 1.0 : 0.0;
  // a slow mode is visible in two successive values of the map, but not across a jump
  return now_.values > 0.0 && (at_most(0.2) || now_.quiet >= 2.0) && distance <= settled &&
         std::fabs(now_.stretch - 1.0) <= settled && now_.apart <= settled;
}

// Evaluates a ball pass whose end state is a value of the map. If a mode decays slowly, speeds are
// chosen for the start of the next ball pass, during which the fast modes settle; that ball pass is
// not a value of the map.
void OrbitSearch::judge(const OrbitBalls &balls, const std::vector<double> &end,
                        const SettlingChanges &changes, double settled)
{
  if (!map_.begun()) map_ = raceway::FixedPoint(map_settings(), balls.weights(now_.passes));
  raceway::FixedPoint map = map_;
  map.add(start_, end);
  raceway::FixedPoint::Next next = map.next();
  const double keeps = map.contraction();
  // the part that has decayed least since the previous value may be hidden by parts that have
  // decayed more
  next.distance = std::max(next.distance, next.residual / (1.0 - std::min(keeps, slowest)));
  now_.residual = next.residual;
  now_.distance = next.distance;
  const bool found = repeats(changes, next.distance, settled);
  if (now_.steps == FIRST_OF_DECK) {
    // the fast modes have settled on the steps of the deck during this ball pass, which is
    // therefore not a value of the map
    now_.best_pass = now_.passes;
    now_.steps = DECK;
    now_.values = -1.0;
    if (found) now_.stage = FOUND;
    else map_ = raceway::FixedPoint(map_settings(), {});
    return;
  }
  map_ = map;
  if (found) {
    if (now_.steps == COARSE) now_.steps = FIRST_OF_DECK;
    else now_.stage = FOUND;
    return;
  }
  const double noise = close * settled, progress = std::max(noise, next.residual);
  if (keeps < 0.0) {
    map_.forget();
    // the last jump overshot the orbit: the search begins again from here
    if (now_.values == 0.0) now_.best = HUGE_VAL;
  }
  // residuals that are small but increase belong to no slow decay
  const bool jumps = keeps > 0.0 && (keeps < 1.0 || next.residual > noise) &&
                     now_.jumps < most_jumps &&
                     settled < next.distance * std::pow(std::min(keeps, slowest), soon);
  if (progress < less * now_.best || jumps) {
    now_.best = std::min(now_.best, progress);
    now_.best_pass = now_.passes;
  }
  if (!jumps) return;
  now_.jumps += 1.0;
  now_.jumped = 1.0;
  now_.quiet = 0.0;
  balls.put(now_.passes, next.start);
}

}    // namespace bearing
