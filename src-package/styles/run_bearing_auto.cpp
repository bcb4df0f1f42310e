// SPDX-License-Identifier: GPL-2.0-or-later
// `settle auto` of run_bearing: settles ball pass by ball pass until the remaining changes are
// small (core/figures/settling_rest.h). Implicit steps are coarse at first, but in the last ball
// passes they are those specified in the deck.
#include "../core/settings/arguments.h"
#include "../core/settings/written.h"
#include "fix_bearing_heat.h"
#include "fix_bearing_implicit.h"
#include "fixes.h"
#include "print_line.h"
#include "run_bearing.h"

using namespace LAMMPS_NS;
using bearing::digits;
using bearing::text;

// Smallest number of ball passes in which a drift can be distinguished from noise.
static constexpr double first_passes = 3.0;

// Plans coarse steps for the time while the loads are applied and, if coarse steps save
// evaluations, also for the time afterwards. With fix bearing/heat, the later steps are not coarse,
// because the temperatures depend on the losses, which require the steps specified in the deck.
void RunBearing::plan_coarse()
{
  now().coarse = now().may_be_coarse = 0.0;
  if (!automatic()) return;
  for (const FixBearingImplicit *f : bearing::fixes_of<FixBearingImplicit>(lmp)) {
    if (f->can_be_coarse()) now().coarse = 1.0;
    if (f->coarse_saves()) now().may_be_coarse = 1.0;
  }
  for (const FixBearingHeat *f : bearing::fixes_of<FixBearingHeat>(lmp))
    if (!f->idle()) now().may_be_coarse = 0.0;
}

void RunBearing::settle_until_still()
{
  const double steps = steps_a_pass();
  now().steps = steps;
  now().first_step = now().begin_steps;
  while (within_pass() || (!still() && now().passes < settings_.limit)) {
    const bool searches = fix_->orbit().runs();
    plan_pass();
    choose_steps();
    set_step(now().step_length);
    execute("run " + digits(now().begin_steps + (now().passes + 1.0) * steps) + " upto post no");
    say_pass();
    if (searches) say_search();
  }
  if (!still() && comm->me == 0)
    BRG_WARN("run_bearing: not settled after " + text(now().passes) +
             " ball passes: estimated remaining change of torque " + text(now().rest.torque) +
             ", of loads " + text(now().rest.load) + ", of cage speed " +
             text(now().rest.cage_speed) + ", of spin axes " + text(now().rest.spin_axis) + " rad" +
             pocket_fall() + "; required " + text(settings_.settled));
}

// Chooses the steps for the next ball pass or, when a stopped run continues, for the current one.
// They are coarse as long as changes remain. The state that is reached with coarse steps may differ
// slightly from the state reached with the steps of the deck. If a change still remains with the
// latter, coarse steps are resumed.
void RunBearing::plan_pass()
{
  const bool last = now().passes + 1.0 >= settings_.limit;
  const bool search = fix_->orbit().runs();
  if (last || (search && !fix_->orbit().coarse()) ||
      (!search && now().passes >= first_passes && rests_are_small()))
    now().coarse = 0.0;
  else now().coarse = now().may_be_coarse;
}

void RunBearing::choose_steps()
{
  const double correction = fix_->orbit().runs() ? 1e-8 : 1e-9;    // m
  for (FixBearingImplicit *f : bearing::fixes_of<FixBearingImplicit>(lmp))
    f->coarse(now().coarse != 0.0 ? correction : 0.0);
}

// Returns true if a stopped run continues within a ball pass, whose end decides what follows.
bool RunBearing::within_pass()
{
  return static_cast<double>(update->ntimestep) > now().begin_steps + now().passes * now().steps;
}

bool RunBearing::still()
{
  if (fix_->orbit().runs()) return false;
  return fix_->orbit().found() || (now().coarse == 0.0 && rests_are_small());
}

// Returns true if the remaining changes are small, but not before the cage has made half a turn,
// because a ball that is initially in the loaded arc keeps its position in its pocket until it
// leaves the arc, at most half a turn of the cage later.
bool RunBearing::rests_are_small()
{
  const double s = settings_.settled;
  return now().passes >= 0.5 * fix_->pockets() && now().rest.within({s, 0.1 * s, s, s, 0.5});
}

std::string RunBearing::pocket_fall()
{
  char part[60] = "";
  if (fix_->pockets() > 0.0)
    snprintf(part, sizeof part, ", fall of pocket forces %.1e", now().rest.pocket_fall);
  return part;
}

void RunBearing::say_pass()
{
  if (now().passes < 2.0) return;
  const bearing::SettlingChanges &r = now().rest;
  char line[160];
  snprintf(line, sizeof line,
           "Ball pass %.0f: remaining changes: torque %.1e, loads %.1e, cage speed %.1e,"
           " spin axes %.1e rad",
           now().passes, r.torque, r.load, r.cage_speed, r.spin_axis);
  bearing::print_line(lmp, line + pocket_fall() + (now().coarse != 0.0 ? " (coarse steps)" : ""));
}
