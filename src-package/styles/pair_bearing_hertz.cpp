// SPDX-License-Identifier: GPL-2.0-or-later
// Set-up of the pair style: commands, coefficients and restart. The step is in
// pair_bearing_compute.cpp, and the contact search is in pair_bearing_contacts.cpp.
#include "pair_bearing_hertz.h"

#include "../contacts/instants.h"
#include "../core/settings/arguments.h"
#include "../core/settings/written.h"
#include "citation.h"
#include "fixes.h"
#include "simulated_time.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace raceway;
using bearing::Arguments;
using bearing::text;

static constexpr double shortest_step = 1e-15;    // s

PairBearingHertz::PairBearingHertz(LAMMPS *lmp, bool with_film) :
    Pair(lmp), coefficients_(with_film), evaluator_(lmp), ring_sum_(lmp)
{
  single_enable = 0;
  restartinfo = 1;
  no_virial_fdotr_compute = 1;
  bearing::cite_paper(lmp);
}

PairBearingHertz::~PairBearingHertz()
{
  // Modify may already have been deleted when the host shuts down
  const int at = modify && modify->nfix ? modify->find_fix(FixBearingState::fixed_id) : -1;
  if (at >= 0) dynamic_cast<FixBearingState *>(modify->fix[at])->part_from_pair();
  if (allocated) {
    memory->destroy(setflag);
    memory->destroy(cutsq);
  }
}

PairBearingHertz *PairBearingHertz::find(LAMMPS *lmp, const std::string &asked_by)
{
  PairBearingHertz *p = dynamic_cast<PairBearingHertz *>(lmp->force->pair);
  if (!p)
    BRG_ALL_OF(lmp, asked_by + " needs pair_style bearing, bearing/hertz or bearing/ehd before it, "
                               "not below hybrid; particles beside bearings use 'pair_coeff I J "
                               "grain' and fix bearing/grains");
  return p;
}

void PairBearingHertz::allocate()
{
  const int n = atom->ntypes + 1;
  allocated = 1;
  memory->create(setflag, n, n, "pair:setflag");
  memory->create(cutsq, n, n, "pair:cutsq");
  // types that do not appear in any pair_coeff do not interact, but their coefficients count as set
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      setflag[i][j] = 1;
      cutsq[i][j] = 0.0;
    }
}

void PairBearingHertz::settings(int narg, char **arg)
{
  commands_.assign(1, std::vector<std::string>(arg, arg + narg));
  new_style_ = true;
  Arguments args(lmp,
                 std::string("pair_style ") +
                     (coefficients_.lubricated() ? "bearing/ehd" : "bearing/hertz"),
                 narg, arg, 0);
  coefficients_.read_style(args);
}

void PairBearingHertz::coeff(int narg, char **arg)
{
  if (!allocated) allocate();
  commands_.emplace_back(arg, arg + narg);
  std::string command = "pair_coeff";
  for (int k = 0; k < narg && k < 3; ++k) command += std::string(" ") + arg[k];
  Arguments args(lmp, command, narg, arg, 0);
  coefficients_.read_coeff(args, atom->ntypes);
}

void PairBearingHertz::move_last_command(size_t k)
{
  if (k + 1 >= commands_.size()) return;
  commands_[k] = commands_.back();
  commands_.pop_back();
}

void PairBearingHertz::init_style()
{
  if (strcmp(update->unit_style, "si") != 0)
    BRG_ALL(std::string("pair_style bearing needs 'units si', not 'units ") + update->unit_style +
            "'");
  if (!atom->radius_flag || !atom->rmass_flag || !atom->torque_flag || !atom->omega_flag)
    BRG_ALL(
        "pair_style bearing needs atom_style sphere (granular in LIGGGHTS), because balls rotate");
  if (force->newton_pair)
    BRG_ALL(
        "pair_style bearing needs 'newton off', because the owner of a ball computes its contacts");
  if (domain->xperiodic || domain->yperiodic || domain->zperiodic)
    BRG_ALL(
        "pair_style bearing needs 'boundary f f f' (or m, s), because a bearing is not periodic");
  if (update->whichflag == 2)
    BRG_ALL("pair_style bearing cannot minimize, because its forces depend on speeds: use run");
  if (strncmp(update->integrate_style, "respa", 5) == 0)
    BRG_ALL(
        "pair_style bearing needs 'run_style verlet': the levels of respa would not move rings");
  if (!coefficients_.any_raceway())
    BRG_ALL("pair_style bearing: no raceway; give pair_coeff BALL RING inner|outer ...");
  if (!(update->dt >= shortest_step))
    BRG_ALL("timestep is " + text(update->dt) + " s, must be at least " + text(shortest_step) +
            " s; otherwise the time would not advance");
  comm->ghost_velocity = 1;
  BRG_REQUEST_HALF();
  const bearing::TypeSizes sizes = type_sizes();
  const std::string wrong = coefficients_.prepare(sizes);
  if (!wrong.empty()) BRG_ALL(wrong);
  implicit_bits_ = 0;
  for (int k = 0; k < modify->nfix; ++k)
    if (dynamic_cast<bearing::InstantSource *>(modify->fix[k]))
      implicit_bits_ |= modify->fix[k]->groupbit;
  // these are set again by the fixes that change the contact law and by the fixes
  // bearing/capacitance
  followers_.clear();
  capacitors_ = gaps_ = false;
  validity_.forget_shoulders();
  check_ghosts();
  check_types(sizes.count);
  check_rails();
  if (update->nsteps > 0) movers_.look(lmp, coefficients_, implicit_bits_);
  profiles_.clear();    // these are set again by the fixes bearing/profile
  atoms_ = count_atoms();
  put_state_last();
  hold_rings();
  rebuild_ = true;
}

// A ring that no fix moves keeps its position and its axis, so it has no velocity but its spin,
// whatever another command or a fix of the last run has left.
void PairBearingHertz::hold_rings()
{
  int moved = 0;    // groups of the fixes that move rings
  for (int k = 0; k < modify->nfix; ++k) {
    const Fix &f = *modify->fix[k];
    if (strcmp(f.style, "bearing/ring") == 0 || strcmp(f.style, "bearing/shaft") == 0)
      moved |= f.groupbit;
  }
  for (int i = 0; i < atom->nlocal; ++i) {
    const int type = atom->type[i];
    if (!coefficients_.is_ring(type) || coefficients_.is_cage(type) || (atom->mask[i] & moved))
      continue;
    Vec3().to(atom->v[i]);
    const Vec3 e = state_->axis(i), w = Vec3::from(atom->omega[i]), spin = e * dot(w, e);
    if (norm(w - spin) > 1e-12 * norm(w)) spin.to(atom->omega[i]);
  }
}

// The state fix must be the last fix, because it restores the forces of the previous step after the
// set-up of every other fix. If fixes have been defined since the previous run, the state fix is
// moved to the end again, together with its state. If the command pair_style has been given since
// then, its contacts start anew.
void PairBearingHertz::put_state_last()
{
  const int at = modify->find_fix(FixBearingState::fixed_id);
  if (at < 0 || at != modify->nfix - 1) {
    FixBearingState::Contents kept;
    if (at >= 0) {
      kept = dynamic_cast<FixBearingState *>(modify->fix[at])->release();
      modify->delete_fix(FixBearingState::fixed_id);
    }
    const char *words[3] = {FixBearingState::fixed_id, "all", "bearing/state"};
    modify->add_fix(3, const_cast<char **>(words));
    if (at >= 0)
      dynamic_cast<FixBearingState *>(modify->fix[modify->nfix - 1])->take(std::move(kept));
  }
  state_ = dynamic_cast<FixBearingState *>(modify->fix[modify->nfix - 1]);
  state_->serve(*this);
  state_->check_numbers();
  state_->continue_time();
  if (new_style_ && at >= 0) {
    if (state_->has_another_axis())
      BRG_ALL(std::string("pair_style: axis is ") + "xyz"[coefficients_.axis_index()] +
              ", but the bearings of the previous run have another axis");
    state_->forget_contacts();
  }
  new_style_ = false;
  state_->keep_axes();
}

bearing::TypeSizes PairBearingHertz::type_sizes() const
{
  const int n = atom->ntypes + 1;
  bearing::TypeSizes s = {std::vector<double>(n, HUGE_VAL), std::vector<double>(n, 0.0),
                          std::vector<double>(n, 0.0), std::vector<int>(n, 0)};
  for (int i = 0; i < atom->nlocal; ++i) {
    const int t = atom->type[i];
    s.smallest[t] = std::min(s.smallest[t], atom->radius[i]);
    s.largest[t] = std::max(s.largest[t], atom->radius[i]);
    s.mass[t] = std::max(s.mass[t], atom->rmass[i]);
    ++s.count[t];
  }
  MPI_Allreduce(MPI_IN_PLACE, s.smallest.data(), n, MPI_DOUBLE, MPI_MIN, world);
  MPI_Allreduce(MPI_IN_PLACE, s.largest.data(), n, MPI_DOUBLE, MPI_MAX, world);
  MPI_Allreduce(MPI_IN_PLACE, s.mass.data(), n, MPI_DOUBLE, MPI_MAX, world);
  MPI_Allreduce(MPI_IN_PLACE, s.count.data(), n, MPI_INT, MPI_SUM, world);
  return s;
}

// The hosts use the larger of the ghost cutoff in the deck and the cutoff of the pair styles, so a
// smaller cutoff in the deck is probably a mistake.
void PairBearingHertz::check_ghosts()
{
  const double reach = coefficients_.reach();
  if (comm->cutghostuser > 0.0 && comm->cutghostuser < reach)
    BRG_ALL("pair_style bearing: the ghost cutoff " + text(comm->cutghostuser) +
            " m (" BRG_GHOST_COMMAND
            " cutoff) is too small: it must include the centre of a ball's ring, up to " +
            text(reach) + " m away; leave the cutoff out");
}

void PairBearingHertz::expect_sphere(int ball_type, int cage_type)
{
  cage_types_.insert(std::minmax(ball_type, cage_type));
}

// Types that do not appear in any pair_coeff do not interact, which is hardly intended. Warns once
// per type.
void PairBearingHertz::check_types(const std::vector<int> &count)
{
  for (const auto &c : cage_types_) {
    if (coefficients_.spheres(c.first, c.second)) continue;
    silent_types_.insert(c.second);
    if (comm->me == 0)
      BRG_WARN("cage balls pass through the balls: there is no 'pair_coeff " +
               std::to_string(c.first) + " " + std::to_string(c.second) + " sphere ...'");
  }
  cage_types_.clear();
  std::string types;
  for (int t = 1; t <= atom->ntypes; ++t)
    if (count[t] > 0 && !coefficients_.is_named(t) && !coefficients_.is_grain(t) &&
        silent_types_.insert(t).second)
      types += ' ' + std::to_string(t);
  if (!types.empty() && comm->me == 0)
    BRG_WARN("pair_style bearing: no pair_coeff names type" + types +
             ": its atoms pass through everything");
}

// Cage balls that are not on rails are not held by anything. Warns whenever the number of such
// balls has changed.
void PairBearingHertz::check_rails()
{
  int railed = 0;
  for (int k = 0; k < modify->nfix; ++k)
    if (strcmp(modify->fix[k]->style, "bearing/cage") == 0) railed |= modify->fix[k]->groupbit;
  bigint mine = 0, all = 0;
  for (int i = 0; i < atom->nlocal; ++i) {
    const int t = atom->type[i];
    mine += coefficients_.is_named(t) && !coefficients_.is_ball(t) && !coefficients_.is_ring(t) &&
            !(atom->mask[i] & railed);
  }
  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (all > 0 && all != without_rails_ && comm->me == 0)
    BRG_WARN("pair_style bearing: " + std::to_string(all) +
             " cage balls are not in the group of any fix bearing/cage: no rails hold them");
  without_rails_ = all;
}

bigint PairBearingHertz::count_atoms() const
{
  std::vector<char> named(atom->ntypes + 1, 0);
  for (int t = 1; t <= atom->ntypes; ++t) named[t] = coefficients_.is_named(t);
  bigint mine = 0, all = 0;
  for (int i = 0; i < atom->nlocal; ++i) mine += named[atom->type[i]];
  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  return all;
}

// Stops with an error if atoms are missing. The hosts delete atoms that leave the box, and LIGGGHTS
// does so without a message.
void PairBearingHertz::check_atoms() const
{
  const bigint now = count_atoms();
  if (now != atoms_)
    BRG_ALL("lost " + std::to_string(atoms_ - now) + " of " + std::to_string(atoms_) +
            " balls, cage balls and rings at step " + std::to_string(update->ntimestep) +
            ": they have left the box. Either the speed or step is too large, a cage has no rails "
            "(fix bearing/cage), or a ring has no fix");
}

double PairBearingHertz::init_one(int i, int j)
{
  const double cut = coefficients_.cutoff(i, j);
  state_->ghost_reach(cut);
  return cut;
}

// Writes the commands, followed by the simulated time, which a deck may use before its next run.
void PairBearingHertz::write_restart(FILE *fp)
{
  bearing::write_commands(fp, commands_);
  const double time = bearing::SimulatedTime::now(*update);
  fwrite(&time, sizeof time, 1, fp);
}

void PairBearingHertz::read_restart BRG_READ_RESTART_SIG
{
  BRG_UNUSED_RESTART_ARGS;
  bearing::Commands commands;
  const std::string wrong = bearing::read_commands(fp, world, commands);
  if (!wrong.empty()) BRG_ALL("pair_style bearing: " + wrong);
  for (const auto &words : commands)
    bearing::pass_words(words, [&](int narg, char **arg) {
      if (&words == &commands.front()) settings(narg, arg);
      else coeff(narg, arg);
    });
  double time;
  if (comm->me == 0 && fread(&time, sizeof time, 1, fp) != 1)
    BRG_ONE(std::string("pair_style bearing: ") + bearing::CUT_OR_DAMAGED);
  MPI_Bcast(&time, sizeof time, MPI_BYTE, 0, world);
  bearing::SimulatedTime::set(*update, time);
}

double PairBearingHertz::memory_usage()
{
  return table_.raceway.capacity() * sizeof(bearing::RacewayContact) +
         table_.sphere.capacity() * sizeof(bearing::SphereContact);
}
