// SPDX-License-Identifier: GPL-2.0-or-later
// Stages of fix bearing/heat from one ball pass to the next, and the jumps of the temperatures.
#include "../core/laws/heat_average.h"
#include "../core/settings/arguments.h"
#include "fix_bearing_heat.h"
#include "fixes.h"
#include "named_bearing.h"
#include "print_line.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace raceway;
using bearing::text;
namespace of = bearing::of_fix_heat;

// number of ball passes after the load ramp before losses are averaged
static constexpr double passes_at_first = 2.0;
// If loads or speeds vary, losses are averaged over spans of 16, 32 ... ball passes, until the
// means of both halves differ from that of the span by at most this fraction.
static constexpr double scatter_of_means = 2e-3;
static constexpr size_t shortest_span = 16, longest_span = 128;    // ball passes
// A warning is printed if those of the longest span differ by more than this fraction.
static constexpr double doubtful_scatter = 1e-2;

void FixBearingHeat::enter(Stage stage)
{
  now_.stage = stage;
  now_.since = 0.0;
  now_.sum = {};
  now_.summed = 0.0;
  passes_.clear();
}

// Returns true if the mean losses so far represent the losses at the current temperatures. If loads
// or speeds vary, their period is in general not a ball pass, and the means of single ball passes
// scatter.
bool FixBearingHeat::averaged()
{
  if (!passed(now_.since, passes_.size() + 1.0) || now_.summed == 0.0) return false;
  HeatPass mean;
  mean.add(now_.sum, 1.0 / now_.summed);
  passes_.push_back(mean);
  now_.sum = {};
  now_.summed = 0.0;
  if (!varies_) return true;
  const size_t count = passes_.size();
  const bool is_span = count >= shortest_span && (count & (count - 1)) == 0;
  if (!is_span) return false;
  const double scatter = scatter_of_passes(passes_);
  if (scatter <= scatter_of_means) return true;
  if (count < longest_span) return false;
  if (scatter > doubtful_scatter && !warned_ && comm->me == 0)
    BRG_WARN(bearing::name_of(*this) + ": mean losses of bearing " + bearing_->name +
             " still change by " + text(100.0 * scatter) + " % from one half of " +
             std::to_string(longest_span) +
             " ball passes to the other, as its loads or speeds vary slowly or irregularly: "
             "temperatures depend on when the losses are averaged");
  warned_ = warned_ || scatter > doubtful_scatter;
  return true;
}

void FixBearingHeat::go_on()
{
  if (idle_ || now_.stage != STAY || control_.until > 0.0) return;
  now_.heat.forget_losses();
  now_.pass = 0.0;
  enter(WAIT);
}

void FixBearingHeat::end_of_step()
{
  now_.since += update->dt;
  ahead_ = 0.0;
  now_.run += update->dt;
  switch (static_cast<int>(now_.stage)) {
    case WAIT:
      if (now_.since >= ramp_ + passes_at_first * now_.pass) enter(WATCH);
      break;
    case RAMP:
      if (passed(now_.since)) enter(WATCH);
      break;
    case LAST:
      if (passed(now_.since)) enter(STAY);
      break;
    case WATCH:
      if (update->ntimestep % stride_ == 0) {
        const double dt = stride_ * update->dt;
        now_.sum.add(losses(), dt);
        now_.summed += dt;
      }
      if (averaged()) now_.stage = READY;
      break;
    default: break;
  }
  if (now_.stage == READY) jump_if_all_are_ready();
}

// Lets the temperatures of all bearings jump if each of them is ready or steady. Steady bearings
// keep their temperatures.
void FixBearingHeat::jump_if_all_are_ready()
{
  std::vector<FixBearingHeat *> ready;
  for (FixBearingHeat *f : together_)
    if (f->now_.stage == READY) ready.push_back(f);
    else if (f->now_.stage != STAY) return;
  jump_together(ready);
}

// Returns the mean values of the ball passes over which losses have been averaged.
HeatPass FixBearingHeat::mean_pass() const
{
  HeatPass seen = mean_of_passes(passes_, 0, passes_.size());
  seen.convection = convection();
  return seen;
}

// Stops with an error if a ring or the balls have lost every path for their heat.
void FixBearingHeat::check_paths() const
{
  const HeatPass seen = mean_pass();
  HeatNetwork net = network_;
  net.inner = seen.inner;
  net.outer = seen.outer;
  if (net.connected()) return;
  BRG_ALL(bearing::name_of(*this) + ": during a whole ball pass, no ball of bearing " +
          bearing_->name + " touched its " + (net.inner > 0.0 ? "outer" : "inner") +
          " ring, so heat cannot flow between them: load the bearing, or cool it with oil_flow");
}

// Lets the temperatures of all bearings jump by the same time, the shortest that any of them
// permits, so that they share one thermal clock. They continue until all of them are steady.
void FixBearingHeat::jump_together(const std::vector<FixBearingHeat *> &bearings)
{
  for (const FixBearingHeat *f : bearings) f->check_paths();
  double length = 0.0, steady = bearings.front()->control_.steady;
  const auto tried = [](const FixBearingHeat *f, const HeatControl &c) {
    HeatState s = f->now_.heat;
    heat_jump(s, f->mean_pass(), f->network_, c);
    return s;
  };
  const auto ends = [&](const FixBearingHeat *f) { return tried(f, f->control_).end != 0.0; };
  if (bearings.size() > 1 && !std::all_of(bearings.begin(), bearings.end(), ends)) {
    steady = -1.0;
    for (const FixBearingHeat *f : bearings) {
      HeatControl c = f->control_;
      c.steady = steady;
      const double own = tried(f, c).length;
      if (own > 0.0) length = length > 0.0 ? std::min(length, own) : own;
    }
  }
  for (FixBearingHeat *f : bearings) {
    HeatControl c = f->control_;
    c.steady = steady;
    c.length = length;
    f->jump(c);
  }
}

// Lets the temperatures jump according to the mean losses.
void FixBearingHeat::jump(const HeatControl &control)
{
  const HeatPass seen = mean_pass();
  HeatState &heat = now_.heat;
  now_.jump = heat.length;
  heat_jump(heat, seen, network_, control);
  for (int k = 0; k < parts; ++k) {
    now_.from[k] = now_.to[k];
    now_.to[k] = heat.law[k];
  }
  now_.oil = heat.oil();
  apply_ = true;
  const HeatEnd end = static_cast<HeatEnd>(static_cast<int>(heat.end));
  enter(end == HeatEnd::none ? RAMP : LAST);
  Row row;
  for (int k = 0; k < of::N; ++k) row[k] = value(k);
  rows_.push_back(row);
  now_.rows = static_cast<double>(rows_.size());
  write_row(row);
  say(seen.power());
  const std::string at = bearing::name_of(*this) + ": bearing " + bearing_->name + " at " +
                         text(heat.time) + " s: inner ring " + text(heat.at[0]) + ", balls " +
                         text(heat.at[1]) + ", outer ring " + text(heat.at[2]) + " C, losses " +
                         text(seen.power()) + " W";
  if (end == HeatEnd::seizes)
    BRG_ALL(at + ": it seizes. Losses grow with temperature " + text(heat.gain) +
            " times as fast as cooling: thermal runaway. Improve the cooling, or increase the "
            "clearance");
  if (end == HeatEnd::hot)
    BRG_ALL(at + ": hotter than " + text(control_.hottest) + " C. Improve cooling");
}

void FixBearingHeat::say(double power) const
{
  const HeatState &h = now_.heat;
  char line[160];
  snprintf(line, sizeof line,
           "Thermal time %.6g s: inner ring %.2f, balls %.2f, outer ring %.2f, housing %.2f C, "
           "losses %.4g W, gain %.2f",
           h.time, h.at[0], h.at[1], h.at[2], h.at[3], power, h.gain);
  bearing::print_line(lmp, line);
}
