// SPDX-License-Identifier: GPL-2.0-or-later
#include "run_bearing.h"

#include "../core/figures/fix_columns.h"
#include "../core/settings/arguments.h"
#include "ball_pass.h"
#include "fix_bearing_checkpoint.h"
#include "fix_bearing_heat.h"
#include "fix_bearing_implicit.h"
#include "fix_bearing_record.h"
#include "fix_bearing_ring.h"
#include "fix_bearing_timestep.h"
#include "fixes.h"
#include "output.h"
#include "pair_bearing_hertz.h"
#include "simulated_time.h"

#include <algorithm>

using namespace LAMMPS_NS;
using bearing::Arguments;
using bearing::digits;
using bearing::text;
using bearing::written;

static constexpr const char *command_name = "run_bearing";
// Fixes and a compute that are used only by this command.
static const std::string total_id = FixBearingRun::fixed_id, step_id = "RUN_BEARING_STEP",
                         show_id = "RUN_BEARING_SHOW", share_id = "RUN_BEARING_SHARE";

void RunBearing::read(Arguments &args)
{
  Settings &to = settings_;
  bool settles = false;
  while (args.more())
    if (args.take("settle")) {
      to.orbit = args.take("orbit");
      to.automatic = to.orbit || args.take("auto");
      if (!to.automatic && args.more() && !args.next_is_number())
        args.fail("settle is '" + args.next() +
                  "', must be a number of ball passes, auto or orbit");
      if (!to.automatic) to.settle = args.within("ball passes to settle", 0.0, 1e6);
      settles = true;
    } else if (!(args.variable("passes", to.passes) || args.variable("step", to.step) ||
                 args.variable("safety", to.safety) ||
                 args.within("rate", to.rate, "samples per second (Hz)", 1e3, 1e8) ||
                 args.within("angle", to.angle, "contact angle (degrees)", 0.0, 60.0) ||
                 args.variable("settled", to.settled) ||
                 args.integer("limit", to.limit, "ball passes to settle in", 2, 1000000))) {
      args.unknown();
    }
  if (!settles)
    args.fail("'settle N', 'settle auto' or 'settle orbit' is missing (ball passes before the "
              "measurement)");
  if (to.passes == 0.0) args.fail("'passes P' is missing (ball passes to measure)");
}

// Returns the settings that must be the same in a continued run as in the previous one.
std::string RunBearing::words() const
{
  const Settings &s = settings_;
  const std::string settle = automatic() ? (s.orbit ? "orbit" : "auto") + std::string(" settled ") +
                                               digits(s.settled) + " limit " + digits(s.limit)
                                         : digits(s.settle);
  return "settle " + settle + " step " + digits(s.step) + " safety " + digits(s.safety) + " rate " +
         digits(s.rate) + (std::isnan(s.angle) ? "" : " angle " + digits(s.angle));
}

void RunBearing::command(int narg, char **arg)
{
  Arguments args(lmp, command_name, narg, arg, 0);
  read(args);
  take_usual();
  if (domain->box_exist == 0) args.fail("there is no box yet, and therefore no bearing");
  check_moved(args);
  for (const FixBearingRecord *f : bearing::fixes_of<FixBearingRecord>(lmp))
    if (f->samples_a_pass() > 0.0 && !f->waits())
      args.fail(bearing::name_of(*f) + " has been measured already: start another record");
  if (output->thermo_every == 0)    // the table of fix bearing/progress shows more
    for (const char *line : {"thermo_style custom step", "thermo_modify lost error flush yes"})
      execute(line);
  execute("compute " + total_id + " all bearing/total");
  execute("fix " + std::string(FixBearingRun::fixed_id) + " all bearing/run " + words());
  fix_ = bearing::fixes_of<FixBearingRun>(lmp).front();
  if (!fix_->resumed()) plan();
  else if (fix_->orbit().runs()) shorten_ramps();
  if (now().measures == 0.0) settle();
  measure();
  execute("unfix " + std::string(FixBearingRun::fixed_id));
  execute("uncompute " + total_id);
  check_balance();
}

// Stops with an error if there is a ball whose motion no fix integrates.
void RunBearing::check_moved(const Arguments &args)
{
  const PairBearingHertz *pair = PairBearingHertz::find(lmp, command_name);
  const bearing::Lacking still =
      bearing::unmoved(lmp, [pair](int type) { return pair->coefficients().is_ball(type); });
  if (still.count > 0)
    args.fail("no fix moves ball " + digits(still.first) +
              ": its group needs fix bearing/implicit, bearing/verlet or nve/sphere");
}

bool RunBearing::implicit() const { return !bearing::fixes_of<FixBearingImplicit>(lmp).empty(); }

// ---- The plan: ball pass, samples and steps. Numbers are rounded in the same way as by formulas
// in a deck.

// Takes the default value from the scene: the sampling rate of fix bearing/vibration.
void RunBearing::take_usual()
{
  if (settings_.rate == 0.0)
    for (const FixBearingImplicit *f : bearing::fixes_of<FixBearingImplicit>(lmp))
      settings_.rate = std::max(settings_.rate, f->sampling_rate());
}

void RunBearing::plan()
{
  now().start = bearing::SimulatedTime::now(*update);
  if (update->ntimestep != 0) begin_at_step_0(now().start);
  now().pass = bearing::ball_pass_time(lmp, command_name, settings_.angle);
  begin_search();
  for (FixBearingHeat *f : bearing::fixes_of<FixBearingHeat>(lmp)) f->go_on();
  double ramp = 0.0;    // s, time after which the full loads act
  for (const FixBearingRing *f : bearing::fixes_of<FixBearingRing>(lmp))
    ramp = std::max(ramp, f->ramp());
  // a whole ball pass with adaptive steps precedes the steps of constant length
  const double before = automatic() ? (implicit() ? 0.0 : 1.0) : settings_.settle;
  const double least = fix_->orbit().runs() ? 1e-3 : 1e-2;    // s
  now().begin = written(before * now().pass + std::max(least, ramp));
  plan_samples();
  plan_coarse();
  if (implicit()) plan_steps();
  if (implicit() && !automatic()) plan_history();
}

// Sets the number of samples per ball pass requested by the records, and the number of samples per
// host step. The latter is ten, five, two or one, such that the number of steps in a ball pass is
// an integer and at least twenty.
void RunBearing::plan_samples()
{
  double samples = 0.0, asked = 0.0;
  for (const FixBearingRecord *f : bearing::fixes_of<FixBearingRecord>(lmp)) {
    if (!f->waits()) continue;
    if (samples != 0.0 && (f->samples_a_pass() != samples || f->within_asked() != asked))
      BRG_ALL(std::string(command_name) + ": " + bearing::name_of(*f) + " requests " +
              text(f->samples_a_pass()) + " samples in a ball pass, but another record requests " +
              text(samples) + ": use the same samples and 'within' for both");
    samples = f->samples_a_pass();
    asked = f->within_asked();
  }
  if (samples == 0.0) samples = 200.0;
  now().a_pass = settings_.rate > 0.0 ? settings_.rate * now().pass : samples;
  double chosen = 1.0;
  if (implicit() && settings_.step == 0.0 && settings_.rate == 0.0)
    for (const double n : {2.0, 5.0, 10.0})
      if (samples >= 20.0 * n && std::fmod(samples, n) == 0.0) chosen = n;
  now().within = asked != 0.0 ? asked : chosen;
}

// Sets the step of the implicit integrator to a value close to the requested step, such that it
// spans a whole number of samples or an integer fraction of one sample.
void RunBearing::plan_steps()
{
  fix_step(settings_.step == 0.0 ? sampled_length() : settings_.step);
  now().first_step = now().begin_steps = std::ceil(now().begin / now().step_length);
  if (fix_->orbit().runs()) now().steps = steps_a_pass();
}

// Lets the last ball passes before the measurement be evaluated, although their number is given.
// They show how far the results wander.
void RunBearing::plan_history()
{
  constexpr double most = 200.0;
  const double passes = std::min(std::floor(settings_.settle), most);
  now().counted = 1.0;
  if (passes == 0.0) return;
  now().steps = steps_a_pass();
  now().first_step = std::max(0.0, now().begin_steps - passes * now().steps);
}

// Returns the time (s) spanned by the samples within a host step.
double RunBearing::sampled_length()
{
  const double length = now().pass / now().a_pass * now().within;
  return implicit() ? written(length) : length;
}

// Sets the step to a value close to `wanted`, such that a sample or `within` samples take a whole
// number of steps.
void RunBearing::fix_step(double wanted)
{
  const double largest = sampled_length();
  now().every = std::ceil(largest / written(wanted) - (implicit() ? 1e-9 : 0.0));
  now().step_length = written(largest / now().every);
}

bearing::Sampling RunBearing::sampling()
{
  return {static_cast<int>(now().every), static_cast<int>(now().within)};
}

// ---- settling

void RunBearing::set_step(double dt) { execute("timestep " + digits(dt)); }

void RunBearing::run(double steps)
{
  if (steps > static_cast<double>(update->ntimestep)) execute("run " + digits(steps) + " upto");
}

void RunBearing::show(double rows, const std::string &title, const std::string &more)
{
  execute("fix " + show_id + " all bearing/progress " + digits(std::max(1.0, rows)) + " " +
          total_id + " title " + title + more);
}

void RunBearing::settle()
{
  if (implicit()) {
    set_step(now().step_length);
    for (auto *f : bearing::fixes_of<bearing::WaitsForRun>(lmp)) f->settle(sampling());
    show(std::ceil(now().begin_steps / 5), "Settling");
    choose_steps();
    run(now().begin_steps);
    execute("unfix " + show_id);
  } else if (now().begin_steps == 0.0) {
    settle_adaptively();
  }
  if (now().passes == 0.0) now().coarse = now().may_be_coarse;
  choose_steps();
  warm_up();
  if (automatic()) settle_until_still();
  // with steps of constant length, the time follows from the number of steps, so that rounding
  // errors are the same in a run that has been stopped
  const bool even = implicit() && !settings_.orbit;
  // if a run was stopped after the last step of settling, LIGGGHTS rejects new fixes after
  // reset_timestep until the data of the restart file are released, which happens here
  if (fix_->resumed()) lmp->init();
  begin_at_step_0(even ? now().start + update->ntimestep * now().step_length
                       : bearing::SimulatedTime::now(*update));
  now().measures = 1.0;
}

// In both settling and measurement, steps are counted from 0, but the simulated time is not reset.
void RunBearing::begin_at_step_0(double time)
{
  execute("reset_timestep 0");
  // with velocity Verlet, the forces of the last settling step belong to a step of another length
  PairBearingHertz::find(lmp, command_name)->state()->forget_forces();
  bearing::SimulatedTime::set(*update, time);
}

// With velocity Verlet, the bearings settle with steps that are a fraction of the stability limit.
// The step of the measurement is then derived from the smallest limit found.
void RunBearing::settle_adaptively()
{
  constexpr double chunk = 5000.0;    // steps
  const bool chooses = settings_.step == 0.0;
  const std::string done = "f_" + step_id + "[3]";
  // a run that was stopped continues with the last step that it chose (fix bearing/timestep)
  if (!chooses) set_step(settings_.step);
  else if (update->ntimestep == 0) set_step(1e-7);
  execute("fix " + step_id + " all bearing/timestep " +
          (chooses ? "20 safety " + digits(settings_.safety) + " adapt yes" : "1000 exceed stop"));
  execute("variable " + share_id + " equal " + done + "/" + digits(now().begin));
  show(chunk, "Settling", " share v_" + share_id);
  // a run that was stopped in the last chunk completes it
  const auto in_chunk = [&] { return std::fmod(static_cast<double>(update->ntimestep), chunk); };
  while (written(bearing::SimulatedTime::now(*update)) < now().begin || in_chunk() != 0.0)
    execute("run " + digits(chunk - in_chunk()) + " post no");
  FixBearingTimestep *const step = bearing::fixes_of<FixBearingTimestep>(lmp).back();
  const double limit = step->compute_vector(bearing::of_fix_timestep::SMALLEST);
  for (const std::string &id : {step_id, show_id}) execute("unfix " + id);
  execute("variable " + share_id + " delete");
  fix_step(chooses ? settings_.safety * written(limit) : settings_.step);
  now().begin_steps = static_cast<double>(update->ntimestep);
  // rounding errors of the time are then the same in a run that has been stopped
  if (!chooses)
    bearing::SimulatedTime::set(*update, now().start + now().begin_steps * settings_.step);
}

// Runs ball pass by ball pass until the temperatures of the fixes bearing/heat no longer change.
void RunBearing::warm_up()
{
  if (automatic() && now().steps != 0.0) return;    // the temperatures no longer change
  const std::vector<FixBearingHeat *> heats = bearing::fixes_of<FixBearingHeat>(lmp);
  const auto still = [&heats] {
    return std::all_of(heats.begin(), heats.end(), [](const auto *f) { return f->still(); });
  };
  const auto done = [this] { return static_cast<double>(update->ntimestep) - now().begin_steps; };
  const double steps = steps_a_pass();
  while (!still() || std::fmod(done(), steps) != 0.0) {    // in whole ball passes, even if the run
                                                           // was stopped during one
    set_step(now().step_length);
    const double passes = std::floor(done() / steps) + 1.0;
    execute("run " + digits(now().begin_steps + passes * steps) + " upto post no");
  }
  if (automatic()) now().begin_steps = static_cast<double>(update->ntimestep);
}

double RunBearing::steps_a_pass()
{
  return now().every * std::max(1.0, std::round(now().a_pass / now().within));
}

// ---- The measurement.

void RunBearing::start_fixes()
{
  for (int k = 0; k < modify->nfix; ++k) {
    if (auto *f = dynamic_cast<FixBearingRecord *>(modify->fix[k]); f && f->waits()) {
      f->set_samples_a_pass(written(now().a_pass));
      f->note({"passes", settings_.passes}, true);
      f->note({"settling_evaluations", now().evaluations});
      note_settling(*f);
    }
    if (auto *f = dynamic_cast<bearing::WaitsForRun *>(modify->fix[k]); f && f->waits())
      f->measure(sampling());
  }
}

void RunBearing::measure()
{
  const double a_pass = now().a_pass, within = now().within, every = now().every;
  const double samples =
      settings_.rate > 0.0 ? std::ceil(settings_.passes * a_pass - 0.5) : settings_.passes * a_pass;
  const double steps = samples * every / within;
  if (!(steps >= 1.0 && steps <= 2e9 && steps == std::floor(steps)))
    BRG_ALL(std::string(command_name) + ": host steps of the measurement is " + text(steps) +
            ", must be a whole number from 1 to 2e9: use fewer passes or samples; within must "
            "divide them");
  if (steps < static_cast<double>(update->ntimestep))
    BRG_ALL(std::string(command_name) + ": the run to resume has reached step " +
            std::to_string(update->ntimestep) + ", beyond these passes, " + text(steps) +
            " steps: use more passes");
  set_step(now().step_length);
  if (now().counted != 0.0) fix_->estimate_rest();
  if (update->ntimestep == 0) say_cage_orbit();
  start_fixes();
  if (!implicit()) execute("fix " + step_id + " all bearing/timestep 1000 exceed stop");
  show(std::ceil(steps / 20), "Measuring");
  execute("run " + digits(steps) + " upto");
  execute("unfix " + show_id);
  if (!implicit()) execute("unfix " + step_id);
}

// Stops with an error if the contacts of a ring do not carry its load on average. In this case, the
// bearing had not settled, and the results are meaningless.
void RunBearing::check_balance() const
{
  for (FixBearingCheckpoint *f : bearing::fixes_of<FixBearingCheckpoint>(lmp))
    if (const double left = f->compute_scalar(); !(left <= 0.05))
      BRG_ALL(std::string(command_name) + ": contacts do not carry " + text(left) +
              " of the load, at most 0.05 is allowed: not settled. Settle more ball passes, or "
              "measure more");
}
