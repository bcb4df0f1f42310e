// SPDX-License-Identifier: GPL-2.0-or-later
#include "orbit_search.h"

#include "orbit_balls.h"

#include <algorithm>

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

void OrbitSearch::begin(LAMMPS_NS::LAMMPS *lmp) { start_ = OrbitBalls(lmp).by_slot(0.0); }

void OrbitSearch::end_pass(LAMMPS_NS::LAMMPS *lmp, const SettlingChanges &changes, double settled)
{
  const OrbitBalls balls(lmp);
  now_.passes += 1.0;
  std::vector<double> end = balls.by_slot(now_.passes);
  now_.stretch =
      std::min(2.0, std::max(0.5, balls.spacing() / std::fabs(balls.advance(start_, end))));
  const bool only_follows = now_.jumped != 0.0;
  now_.jumped = 0.0;
  if (!only_follows) judge(balls, end, changes, settled);
  now_.values = only_follows || now_.jumped != 0.0 ? 0.0 : now_.values + 1.0;
  if (now_.stage == ON && now_.passes - now_.best_pass >= patience) now_.stage = NONE;
  start_ = now_.jumped != 0.0 ? OrbitBalls(lmp).by_slot(now_.passes) : end;
}

// Evaluates a ball pass whose end state is a value of the map. If a mode decays slowly, speeds are
// chosen for the start of the next ball pass, during which the fast modes settle; that ball pass is
// not a value of the map.
void OrbitSearch::judge(const OrbitBalls &balls, const std::vector<double> &end,
                        const SettlingChanges &changes, double settled)
{
  if (!map_.begun())
    map_ = raceway::FixedPoint(raceway::FixedPoint::Settings(), balls.weights(now_.passes));
  map_.add(start_, end);
  raceway::FixedPoint::Next next = map_.next();
  const double keeps = map_.contraction();
  // the part that has decayed least since the previous value may be hidden by parts that have
  // decayed more
  next.distance = std::max(next.distance, next.residual / (1.0 - std::min(keeps, slowest)));
  now_.residual = next.residual;
  now_.distance = next.distance;
  const double steady = 0.2 * settled, close = 0.1 * settled;
  // a slow mode is visible in two successive values of the map, but not across a jump
  if (now_.values > 0.0 && changes.within({steady, steady, steady, settled, 1.0}) &&
      next.distance <= settled && std::fabs(now_.stretch - 1.0) <= settled) {
    now_.stage = FOUND;
    return;
  }
  const double progress = std::max(close, next.residual);
  if (keeps < 0.0) {
    map_.forget();
    // the last jump overshot the orbit: the search begins again from here
    if (now_.values == 0.0) now_.best = HUGE_VAL;
  }
  const bool jumps = keeps > 0.0 && now_.jumps < most_jumps &&
                     settled < next.distance * std::pow(std::min(keeps, slowest), soon);
  if (progress < less * now_.best || jumps) {
    now_.best = std::min(now_.best, progress);
    now_.best_pass = now_.passes;
  }
  if (!jumps) return;
  now_.jumps += 1.0;
  now_.jumped = 1.0;
  balls.put(now_.passes, next.start);
}

}    // namespace bearing
