// SPDX-License-Identifier: GPL-2.0-or-later
// `settle orbit` of run_bearing: excludes scenes in which there cannot be an orbit, and prints
// messages.
#include "../core/settings/arguments.h"
#include "ball_pass.h"
#include "fix_bearing_grains.h"
#include "fix_bearing_heat.h"
#include "fix_bearing_profile.h"
#include "fix_bearing_ring.h"
#include "fixes.h"
#include "print_line.h"
#include "run_bearing.h"

using namespace LAMMPS_NS;
using bearing::fixes_of;
using bearing::print_line;
using bearing::text;

// Returns the reason why no ball pass in this scene can repeat the previous one, or an empty string
// if this is possible.
std::string RunBearing::why_no_orbit()
{
  if (!implicit()) return "the steps of velocity Verlet follow its stability limit";
  if (settings_.rate > 0.0) return "samples per second do not divide a ball pass";
  if (bearing::ball_rows(lmp, "run_bearing") != 1) return "there are several rows of balls";
  for (const FixBearingProfile *f : fixes_of<FixBearingProfile>(lmp))
    if (f->departs()) return bearing::name_of(*f) + " makes balls or positions differ";
  for (const FixBearingRing *f : fixes_of<FixBearingRing>(lmp))
    if (!f->constant())
      return "loads or speeds of " + bearing::name_of(*f) + " change or turn with the ring";
  for (const FixBearingHeat *f : fixes_of<FixBearingHeat>(lmp))
    if (!f->idle()) return "temperatures change";
  if (!fixes_of<FixBearingGrains>(lmp).empty()) return "grains load the bearing";
  return "";
}

void RunBearing::begin_search()
{
  if (!settings_.orbit) return;
  const std::string why = why_no_orbit();
  bearing::OrbitSearch::State &search = fix_->orbit().now();
  search.stage = why.empty() ? bearing::OrbitSearch::ON : bearing::OrbitSearch::NONE;
  now().settled = 0.1 * settings_.settled;
  if (!why.empty()) print_line(lmp, "No orbit: " + why + ". Settling until ball passes agree");
}

// Prints a line after a ball pass of the search.
void RunBearing::say_search()
{
  const bearing::OrbitSearch::State &s = fix_->orbit().now();
  char line[160];
  if (s.jumped == 0.0)
    snprintf(line, sizeof line, "  speeds of the balls %.1e, %.1e in all later ball passes",
             s.residual, s.distance);
  else snprintf(line, sizeof line, "  speeds of the balls %.1e; the next are chosen", s.residual);
  print_line(lmp, line);
  const std::string after = text(s.passes) + " ball passes";
  if (fix_->orbit().found()) print_line(lmp, "Orbit after " + after);
  else if (!fix_->orbit().runs())
    print_line(lmp, "No orbit: no ball pass of " + after +
                        " repeats the previous one. Settling until they agree");
}
