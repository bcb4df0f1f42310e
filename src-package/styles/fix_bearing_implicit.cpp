// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_implicit.h"

#include "../core/figures/fix_columns.h"
#include "../core/settings/arguments.h"
#include "fix_bearing_implicit_solver.h"
#include "fix_bearing_ring.h"
#include "fixes.h"
#include "pair_bearing_hertz.h"
#include "print_line.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace FixConst;
using bearing::Arguments;
using bearing::text;
using raceway::BearingIntegrator;

// fix ID group bearing/implicit|damping|vibration [solve all|damping] [tolerance T] [relative R]
// [error E] [control bound|estimate] [cage_tolerance TC] [order 1|2] [corrections N] [largest H]
// [creep C] [energy yes|no] [sampling HZ] [oversampling N]
FixBearingImplicit::FixBearingImplicit(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), pair_(PairBearingHertz::find(lmp, "fix bearing/implicit")),
    solver_(new Solver{{}, {}, {}, {lmp, bearing::name_of(*this)}, {}, {}, {}})
{
  BearingIntegrator::Settings &settings = solver_->settings;
  settings.dampers_only = strcmp(style, "bearing/implicit") != 0;
  if (strcmp(style, "bearing/vibration") == 0) sampling_ = bearing::usual_number("sampling");
  Arguments args(lmp, bearing::name_of(*this), narg, arg, 3);
  while (args.more()) read(args);
  if (std::isnan(relative_) && (tolerance_ > 0.0 || settings.dampers_only)) relative_ = 0.0;
  settings.relative = std::isnan(relative_) ? pair_->relative_tolerance() : relative_;
  if (settings.dampers_only && settings.relative > 0.0)
    args.fail("relative is " + text(settings.relative) +
              ", must be 0 with 'solve damping', whose tolerance is the distance a ball may move");
  if (settings.dampers_only && settings.error > 1.0)
    args.fail("error is " + text(settings.error) +
              ", must be 1 with 'solve damping', which does not estimate errors");
  const bool can_estimate = !settings.dampers_only && settings.order == 2;
  settings.estimate = estimate_.value_or(can_estimate && pair_->estimates_errors());
  if (settings.estimate && !can_estimate)
    args.fail("control is estimate, must be bound with 'solve damping' or 'order 1'");
  if (tolerance_ == 0.0) tolerance_ = settings.dampers_only ? 1e-7 : 1e-9;
  settings.newton = tolerance_;
  if (cage_ > 0.0 && cage_ < tolerance_)
    args.fail("tolerance of cage balls (m) is " + text(cage_) + ", below the tolerance of " +
              text(tolerance_));
  if (cage_ > 0.0) settings.cage = cage_ / tolerance_;
  else settings.cage = pair_->cage_tolerance_share();
  solver_->fine = settings;
  time_integrate = 1;
  bearing::provide_values(*this, bearing::of_fix_implicit::N);
}

// Reads one keyword and its value. A tolerance of 0 means that the tolerance is chosen
// automatically.
void FixBearingImplicit::read(Arguments &args)
{
  BearingIntegrator::Settings &settings = solver_->settings;
  const auto two_names = [&args](const char *brief, const char *variable, double &to) {
    if (!args.take(brief)) return args.variable(variable, to);
    to = args.number_of(variable, brief);
    return true;
  };
  if (args.variable("tolerance", tolerance_) || args.variable("cage_tolerance", cage_) ||
      two_names("relative", "relative_tolerance", relative_) ||
      two_names("error", "step_error", settings.error) ||
      args.integer("order", settings.order, "order", 1, 2) ||
      args.integer("corrections", settings.corrections, "corrections in a stage", 1, 100) ||
      args.within("largest", largest_, "largest step (s)", smallest_step, HUGE_VAL) ||
      args.within("creep", creep_, "creep of the smoothed friction", 1e-6, 1.0) ||
      args.yes("energy", energy_wanted_))
    return;
  if (args.take("control") || args.take("step_control"))
    estimate_ = args.choice("control", {"bound", "estimate"});
  else if (args.take("solve")) settings.dampers_only = args.choice("solve", {"all", "damping"});
  else if (sampling_ > 0.0 &&
           (args.variable("sampling", sampling_) || args.variable("oversampling", oversampling_)))
    return;
  else if (args.next() == "sampling" || args.next() == "oversampling")
    args.fail("sampling and oversampling belong to fix bearing/vibration");
  else args.unknown();
}

FixBearingImplicit::~FixBearingImplicit() = default;

FixBearingImplicit::Control FixBearingImplicit::control() const
{
  const BearingIntegrator::Settings &settings = solver_->settings;
  return {tolerance_, settings.relative, settings.cage * tolerance_, settings.estimate};
}

void FixBearingImplicit::coarse(double correction)
{
  BearingIntegrator::Settings &settings = solver_->settings;
  settings = solver_->fine;
  if (correction == 0.0 || !can_be_coarse()) return;
  settings.dampers_only = false;
  settings.order = 1;
  settings.estimate = false;
  settings.error = 100.0;
  settings.newton = std::max(settings.newton, correction);
}

bool FixBearingImplicit::coarse_saves() const
{
  return can_be_coarse() && (solver_->fine.dampers_only || tolerance_ < 1e-7);
}

int FixBearingImplicit::setmask() { return INITIAL_INTEGRATE; }

void FixBearingImplicit::init()
{
  pair_ = PairBearingHertz::find(lmp, "fix bearing/implicit");
  // the default depends on the contact law, which may have been unknown before
  if (std::isnan(relative_))
    solver_->settings.relative = solver_->fine.relative = pair_->relative_tolerance();
  gravity_.clear();
  check_fixes();
  find_rings();
  instants_ = bearing::Instants();
  capacitors_.clear();
  if (pair_->coefficients().smooth_friction(creep_))
    bearing::print_line(lmp, bearing::name_of(*this) + ": friction smoothed over a creep of " +
                                 text(creep_) + " of the entrainment speed");
}

// Finds the fixes whose rings are in the group. The list is the same on all ranks, although ranks
// may own different rings or none at all.
void FixBearingImplicit::find_rings()
{
  const std::vector<FixBearingRing *> all = bearing::fixes_of<FixBearingRing>(lmp);
  std::vector<int> seen;    // two flags per fix: it has rings in the group; it has rings outside
                            // the group
  for (const FixBearingRing *r : all) {
    int mine = 0, others = 0;
    for (int i = 0; i < atom->nlocal; ++i)
      if (r->moves(i)) (atom->mask[i] & groupbit ? mine : others) = 1;
    seen.push_back(mine);
    seen.push_back(others);
  }
  MPI_Allreduce(MPI_IN_PLACE, seen.data(), static_cast<int>(seen.size()), MPI_INT, MPI_MAX, world);
  rings_.clear();
  for (size_t k = 0; k < all.size(); ++k) {
    if (!seen[2 * k]) continue;
    if (seen[2 * k + 1])
      BRG_ALL(bearing::name_of(*this) + ": its group has some rings of fix " + all[k]->id +
              " but not all of them");
    if (solver_->settings.dampers_only && all[k]->bending())
      BRG_ALL(bearing::name_of(*all[k]) + ": a flexible shaft needs 'solve all' of fix " + id +
              " bearing/implicit");
    rings_.push_back(all[k]);
  }
}

// Returns true for styles that act during a step without changing the motion of atoms. All other
// styles may change it.
static bool only_reads(const std::string &style)
{
  for (const std::string known :
       {"ave/", "balance", "check/", "contact", "controller", "deform/check", "diam/max", "halt",
        "heat/gran", "massflow/", "mesh/", "move/mesh", "neighlist/", "pair/tracker", "print",
        "property/", "store/", "vector"})
    if (style.compare(0, known.size(), known) == 0) return true;
  return false;
}

// Stops with an error if another fix moves the atoms of this group or applies forces that the step
// does not include.
void FixBearingImplicit::check_fixes()
{
  // returns the local index, plus one, of an atom that is in both this group and the group of fix
  // f, or 0
  auto shared = [this](const Fix &f) {
    for (int i = 0; i < atom->nlocal; ++i)
      if ((atom->mask[i] & groupbit) && (atom->mask[i] & f.groupbit)) return i + 1;
    return 0;
  };
  for (const FixBearingImplicit *f : bearing::fixes_of<FixBearingImplicit>(lmp))
    if (f != this)
      if (const int i = shared(*f))
        BRG_ONE(bearing::name_of(*this) + " and fix " + f->id + " both move atom " +
                std::to_string(atom->tag[i - 1]));
  const int acts =
      INITIAL_INTEGRATE | POST_INTEGRATE | PRE_FORCE | POST_FORCE | FINAL_INTEGRATE | END_OF_STEP;
  for (int k = 0; k < modify->nfix; ++k) {
    const Fix &f = *modify->fix[k];
    // the step accounts for the forces of this package's fixes
    if (strncmp(f.style, "bearing/", 8) == 0) continue;
    if (strcmp(f.style, "gravity") == 0) {
      add_gravity(*modify->fix[k]);
      continue;
    }
    const char *does = f.time_integrate                ? "moves them too"
                       : modify->fmask[k] & POST_FORCE ? "adds forces that "
                                                         "an implicit step does not include"
                                                       : "may change their motion";
    // this applies to fixes of any group, because recenter may move atoms outside its group
    const char *changes = BRG_CHANGES_BOX(f)                 ? "box"
                          : strcmp(f.style, "dt/reset") == 0 ? "timestep"
                          : strcmp(f.style, "recenter") == 0 ? "positions of its atoms"
                                                             : nullptr;
    if (changes)
      BRG_ALL(bearing::name_of(*this) + ": fix " + f.id + " (" + f.style + ") may not change the " +
              changes);
    if (f.time_integrate || ((modify->fmask[k] & acts) && !only_reads(f.style)))
      if (shared(f))
        BRG_ONE(bearing::name_of(*this) + ": its group has atoms of fix " + f.id + " (" + f.style +
                "), which " + does);
  }
}

// Stops with an error unless gravity acts on all bodies of a bearing, because the step applies it
// to all of them.
void FixBearingImplicit::add_gravity(Fix &f)
{
  int inside = 0;
  for (int i = 0; i < atom->nlocal; ++i)
    if (atom->mask[i] & groupbit) inside |= atom->mask[i] & f.groupbit ? 1 : 2;
  MPI_Allreduce(MPI_IN_PLACE, &inside, 1, MPI_INT, MPI_BOR, world);
  if (inside == 3)
    BRG_ALL(bearing::name_of(*this) + ": fix " + f.id +
            " (gravity) pulls some atoms of its group, but not all of them");
  if (inside == 1) gravity_.push_back(&f);
}

// Returns the acceleration of an atom due to the gravity fixes in this step, in m/s^2, with the
// bearing axis as the third component. Must be called on all ranks, because a variable may be
// evaluated.
raceway::Vec3 FixBearingImplicit::gravity()
{
  if (gravity_.empty()) return {};
  const size_t n = 3 * static_cast<size_t>(atom->nlocal);
  if (n > 0) forces_.assign(&atom->f[0][0], &atom->f[0][0] + n);
  raceway::Vec3 fall;
  double mass = 1.0;    // kg, a fixed value, so that rounding does not depend on the first atom of
                        // the rank
  int one = 0;
  while (one < atom->nlocal && !(atom->mask[one] & groupbit)) ++one;
  if (one < atom->nlocal) {
    fall.to(atom->f[one]);
    std::swap(mass, atom->rmass[one]);
  }
  for (Fix *f : gravity_) f->post_force(0);
  if (one < atom->nlocal) {
    fall = raceway::Vec3::from(atom->f[one]);
    std::swap(mass, atom->rmass[one]);
  }
  if (n > 0) std::copy(forces_.begin(), forces_.end(), &atom->f[0][0]);
  return raceway::LabAxes{pair_->coefficients().axis_index()}.third(fall);
}

void FixBearingImplicit::setup(int)
{
  build_ = -1;
  solver_->own.clear();
  solver_->integrators.clear();    // the fixes that move the rings may have changed
  substeps_ = corrections_ = refused_ = time_ = worst_ = 0.0;
  solver_->energy = BearingIntegrator::Energy();
  begun_ = false;
  stored_before_ = 0.0;
  smallest_ = HUGE_VAL;
}
