// SPDX-License-Identifier: GPL-2.0-or-later
// `settle orbit` of run_bearing: excludes scenes in which there cannot be an orbit, and prints
// messages.
#include "../core/settings/arguments.h"
#include "ball_pass.h"
#include "fix_bearing_grains.h"
#include "fix_bearing_heat.h"
#include "fix_bearing_profile.h"
#include "fix_bearing_record.h"
#include "fix_bearing_ring.h"
#include "fixes.h"
#include "pair_bearing_hertz.h"
#include "print_line.h"
#include "run_bearing.h"

using namespace LAMMPS_NS;
using bearing::fixes_of;
using bearing::print_line;
using bearing::text;
using raceway::Multiplier;

static double number_of_balls(LAMMPS *lmp)
{
  const PairBearingHertz *pair = PairBearingHertz::find(lmp, "run_bearing");
  double balls = 0.0;
  for (int i = 0; i < lmp->atom->nlocal; ++i)
    balls += pair->coefficients().is_ball(lmp->atom->type[i]);
  MPI_Allreduce(MPI_IN_PLACE, &balls, 1, MPI_DOUBLE, MPI_SUM, lmp->world);
  return balls;
}

// Returns the reason why no ball pass in this scene can repeat the previous one, or an empty string
// if this is possible.
std::string RunBearing::why_no_orbit()
{
  if (!implicit()) return "the steps of velocity Verlet follow its stability limit";
  if (settings_.rate > 0.0) return "samples per second do not divide a ball pass";
  const std::vector<bearing::BallRow> rows =
      bearing::ball_rows(lmp, "run_bearing", settings_.angle);
  double left = number_of_balls(lmp);    // balls that are in none of the rows
  for (const bearing::BallRow &row : rows) left -= row.balls;
  if (left > 0.0) return "not all balls are between an inner and an outer ring";
  for (const bearing::BallRow &row : rows)
    if (row.balls != rows[0].balls || !(std::fabs(row.pass / rows[0].pass - 1.0) <= 1e-3))
      return "the rows of balls differ in number of balls or in speed";
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
  if (why.empty()) shorten_ramps();
  else print_line(lmp, "No orbit: " + why + ". Settling until ball passes agree");
}

// The orbit does not depend on how the loads were applied, so they are applied quickly. On a shaft,
// which is heavier than a ring, this would excite a vibration that lasts for many ball passes.
void RunBearing::shorten_ramps()
{
  for (FixBearingRing *f : fixes_of<FixBearingRing>(lmp))
    if (f->shaft() == 0) f->shorten_ramp(3e-4);
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
  if (fix_->orbit().found()) {
    print_line(lmp, "Orbit after " + after);
    say_multipliers();
  } else if (!fix_->orbit().runs()) {
    const std::string apart =
        s.apart > now().settled ? ", and the speeds of the rows of balls differ by " + text(s.apart)
                                : "";
    print_line(lmp, "No orbit: no ball pass of " + after + " repeats the previous one" + apart +
                        ". Settling until they agree");
  }
}

// Returns the multipliers whose values are known, e.g. "0.58 0.31+0.20i 0.31-0.20i".
static std::string written_multipliers(const std::vector<Multiplier> &all)
{
  std::string list;
  char one[60];
  for (const Multiplier &m : all) {
    if (!m.known()) continue;
    snprintf(one, sizeof one, m.value.imag() == 0.0 ? "%.4g" : "%.4g%+.4gi", m.value.real(),
             m.value.imag());
    list += (list.empty() ? "" : " ") + std::string(one);
  }
  return list;
}

// Names what happens to a disturbance of the orbit. It is determined by the largest multiplier.
static std::string stability(const Multiplier &largest)
{
  const std::string whirl = largest.whirls() ? ", whirl" : "";
  if (largest.stable()) return "stable" + whirl;
  return (largest.unstable() ? "unstable" : "unknown") + whirl;
}

void RunBearing::say_multipliers()
{
  const std::vector<Multiplier> all = fix_->orbit().multipliers();
  if (all.empty()) return;
  const Multiplier &m = all.front();
  char line[160];
  if (m.known())
    snprintf(line, sizeof line, "a ball pass leaves %.4f (+-%.0e) of a disturbance", m.modulus(),
             m.error);
  else
    snprintf(line, sizeof line, "a ball pass leaves at most %.2g of a disturbance",
             m.modulus() + m.error);
  std::string turns;
  if (m.whirls()) {
    char angle[60];
    snprintf(angle, sizeof angle, ", and shifts its phase by %.3f turns", std::fabs(m.turn()));
    turns = angle;
  }
  print_line(lmp, "  " + stability(m) + ": " + line + turns);
}

// Adds the results of the search to a record.
void RunBearing::note_orbit(FixBearingRecord &record)
{
  const bearing::OrbitSearch &orbit = fix_->orbit();
  record.note({"orbit", orbit.found() ? "found" : "none"});
  record.note({"orbit_passes", orbit.now().passes});
  if (!orbit.found()) return;
  const std::vector<Multiplier> all = orbit.multipliers();
  if (all.empty()) return;
  record.note({"orbit_stability", stability(all.front())});
  if (!all.front().known()) {
    const double most = all.front().modulus() + all.front().error;
    record.note({"orbit_multiplier_limit", most});
    return;
  }
  record.note({"orbit_multiplier", all.front().modulus()});
  record.note({"orbit_multiplier_error", all.front().error});
  record.note({"orbit_multipliers", written_multipliers(all)});
}
