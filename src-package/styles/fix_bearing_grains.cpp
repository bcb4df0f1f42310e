// SPDX-License-Identifier: GPL-2.0-or-later
// Settings, state and output of fix bearing/grains; the forces are in fix_bearing_grains_step.cpp.
#include "fix_bearing_grains.h"

#include "../core/figures/fix_columns.h"
#include "../core/numbers/number_list.h"
#include "../core/settings/arguments.h"
#include "../ranks/gather.h"
#include "fix_bearing_shaft.h"
#include "fixes.h"
#include "pair_bearing_hertz.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace FixConst;
using bearing::Arguments;
using bearing::text;
using raceway::Vec3;

// If a collision takes fewer steps than the first limit, the run stops; if it takes fewer than the
// second, a warning is printed.
static constexpr double fewest_steps = 5.0, few_steps = 20.0;

// fix ID group bearing/grains [drum SHAFT|none R Z1 Z2] [blades SHAFT|none N R1 R2 Z1 Z2]
// [stiffness K] [restitution E] [friction MU]
FixBearingGrains::FixBearingGrains(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), pair_(PairBearingHertz::find(lmp, "fix bearing/grains"))
{
  axes_.along = pair_->coefficients().axis_index();
  Arguments args(lmp, bearing::name_of(*this), narg, arg, 3);
  while (args.more()) {
    if (args.take("drum")) read_wall(args, true);
    else if (args.take("blades")) read_wall(args, false);
    else if (!bearing::take_grain_keyword(args, wall_law_)) args.unknown();
  }
  if (!walls_.empty() && wall_law_.stiffness == 0.0)
    args.fail("'stiffness K' (N/m) of the walls is missing");
  restart_global = restart_peratom = create_attribute = 1;
  vector_flag = 1;
  size_vector = bearing::of_fix_grains::N;
  extvector = 0;
  global_freq = 1;
  BRG_SET_MAXEXCHANGE(2 + numbers_kept * most_contacts);
  grow_arrays(atom->nmax);
  atom->add_callback(0);
  atom->add_callback(1);
  BRG_ARRAYS_ARE_SET();
}

FixBearingGrains::~FixBearingGrains()
{
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
}

void FixBearingGrains::read_wall(Arguments &args, bool drum)
{
  Wall wall;
  wall.shape.drum = drum;
  const std::string shaft = args.word("ID of the fix bearing/shaft that it turns with, or none");
  if (shaft != "none") {
    const auto same = [&shaft](const Shaft &s) { return s.id == shaft; };
    const auto at = std::find_if(shafts_.begin(), shafts_.end(), same);
    wall.shaft = static_cast<int>(at - shafts_.begin());
    if (at == shafts_.end()) {
      shafts_.emplace_back();
      shafts_.back().id = shaft;
    }
  }
  if (!drum) {
    wall.shape.blades = args.integer("number of blades", 1, 1000);
    wall.shape.r1 = args.non_negative("inner radius of the blades (m)");
  }
  wall.shape.r2 = args.positive(drum ? "radius of the drum (m)" : "outer radius of the blades (m)");
  if (!(wall.shape.r2 > wall.shape.r1))
    args.fail("outer radius of the blades is " + text(wall.shape.r2) + " m, must be above " +
              text(wall.shape.r1) + " m, the inner radius");
  wall.shape.z1 = args.number("first end along the axis (m)");
  wall.shape.z2 = args.number("second end along the axis (m)");
  if (!(wall.shape.z2 > wall.shape.z1))
    args.fail("second end is " + text(wall.shape.z2) + " m, must be above the first, " +
              text(wall.shape.z1) + " m");
  if (!walls_.empty()) wall.first = walls_.back().first + walls_.back().shape.parts();
  walls_.push_back(wall);
}

int FixBearingGrains::setmask() { return POST_FORCE; }

void FixBearingGrains::init()
{
  pair_ = PairBearingHertz::find(lmp, "fix bearing/grains");
  if (bearing::fixes_of<FixBearingGrains>(lmp).front() != this)
    BRG_ALL(bearing::name_of(*this) + ": there already is a fix bearing/grains; only one can run");
  build_ = -1;
  for (int i = 0; i < atom->nlocal; ++i)
    if ((atom->mask[i] & groupbit) && !pair_->coefficients().is_grain(atom->type[i]))
      BRG_ONE(bearing::name_of(*this) + ": atom " + std::to_string(atom->tag[i]) + " is of type " +
              std::to_string(atom->type[i]) + ", which no 'pair_coeff I J grain ...' names");
  for (Shaft &s : shafts_) {
    const int k = modify->find_fix(s.id.c_str());
    s.fix = k < 0 ? nullptr : dynamic_cast<FixBearingShaft *>(modify->fix[k]);
    if (!s.fix) BRG_ALL(bearing::name_of(*this) + ": there is no fix bearing/shaft '" + s.id + "'");
    if (s.fix->bending())
      BRG_ALL(bearing::name_of(*this) + ": shaft '" + s.id +
              "' is flexible; walls need a rigid one");
    bearing::require_order(lmp, *s.fix, *this, "the walls follow the shaft");
  }
  check_step();
}

void FixBearingGrains::check_step() const
{
  double shortest = HUGE_VAL;    // s, duration of the shortest collision
  const int n = atom->ntypes;
  std::vector<double> mass(n + 1, HUGE_VAL);
  for (int i = 0; i < atom->nlocal; ++i)
    if (atom->mask[i] & groupbit)
      mass[atom->type[i]] = std::min(mass[atom->type[i]], atom->rmass[i]);
  MPI_Allreduce(MPI_IN_PLACE, mass.data(), n + 1, MPI_DOUBLE, MPI_MIN, world);
  for (int a = 1; a <= n; ++a) {
    if (std::isinf(mass[a])) continue;
    if (!walls_.empty()) shortest = std::min(shortest, wall_law_.duration(mass[a]));
    for (int b = 1; b <= n; ++b)
      if (const raceway::GrainLaw *law = pair_->coefficients().grains(a, b))
        if (!std::isinf(mass[b]))
          shortest = std::min(shortest, law->duration(mass[a] * mass[b] / (mass[a] + mass[b])));
  }
  const std::string say = bearing::name_of(*this) + ": timestep " + text(update->dt) +
                          " s, but a collision of the lightest grains takes " + text(shortest) +
                          " s: ";
  if (update->dt * fewest_steps > shortest)
    BRG_ALL(say + "the timestep must be at most " + text(shortest / fewest_steps) + " s");
  if (update->dt * few_steps > shortest && comm->me == 0)
    BRG_WARN(say + "use " + text(shortest / few_steps) + " s or less");
}

std::vector<bearing::ColumnList::Item> FixBearingGrains::columns() const
{
  std::vector<Item> list;
  for (const bearing::Column &c : bearing::of_fix_grains::list)
    list.push_back({std::string(c.name), "%.9g"});
  return list;
}

// Returns the sums over all grains, which are evaluated in the order of tags.
FixBearingGrains::Sums FixBearingGrains::sums() const
{
  struct One {
    bearing::tag_t tag;
    Sums of;
  };
  std::vector<One> all;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    const Vec3 v = Vec3::from(atom->v[i]), w = Vec3::from(atom->omega[i]);
    const double m = atom->rmass[i], R = atom->radius[i];
    One one = {atom->tag[i], {}};
    one.of.lost = grains_[i].lost;
    one.of.kinetic = 0.5 * m * (dot(v, v) + 0.4 * R * R * dot(w, w));
    for (const Contact &c : grains_[i].contacts) {
      const double share = c.tag ? 0.5 : 1.0;
      one.of.elastic += share * c.of.energy;
      if (c.of.energy > 0.0) one.of.contacts += share;
    }
    one.of.first_moment = Vec3::from(atom->x[i]) * m;
    all.push_back(one);
  }
  all = bearing::gather_all(all, world);
  std::sort(all.begin(), all.end(), [](const One &a, const One &b) { return a.tag < b.tag; });
  Sums total;
  for (const One &one : all) {
    total.lost += one.of.lost;
    total.kinetic += one.of.kinetic;
    total.elastic += one.of.elastic;
    total.contacts += one.of.contacts;
    total.first_moment += one.of.first_moment;
  }
  return total;
}

double FixBearingGrains::compute_vector(int k)
{
  using namespace bearing::of_fix_grains;
  if (summed_ != update->ntimestep) now_ = sums();
  summed_ = update->ntimestep;
  const Vec3 fall = now_.first_moment - start_.first_moment;
  switch (k) {
    case CONTACTS: return now_.contacts;
    case WORK: return work_;
    case DISSIPATED: return now_.lost;
    case STORED: return now_.kinetic + now_.elastic - start_.kinetic - start_.elastic;
    case KINETIC: return now_.kinetic;
    default: return k == MX ? fall.x : k == MY ? fall.y : fall.z;
  }
}

void FixBearingGrains::grow_arrays(int n) { grains_.resize(n); }

void FixBearingGrains::copy_arrays(int i, int j, int) { grains_[j] = grains_[i]; }

void FixBearingGrains::set_arrays(int i) { grains_[i] = Grain(); }

template <class List> void FixBearingGrains::keep(List &list, Grain &g)
{
  size_t n = g.contacts.size();
  list(g.lost, n);
  g.contacts.resize(n);
  for (Contact &c : g.contacts)
    list(c.tag, c.part, c.of.spring, c.of.force, c.of.couple, c.of.moment, c.of.energy);
}

int FixBearingGrains::pack_exchange(int i, double *buf)
{
  bearing::NumberWriter list;
  keep(list, grains_[i]);
  return list.copy_to(buf);
}

int FixBearingGrains::unpack_exchange(int i, double *buf)
{
  bearing::NumberReader list(buf);
  keep(list, grains_[i]);
  return list.count();
}

int FixBearingGrains::pack_restart(int i, double *buf)
{
  const int m = 1 + pack_exchange(i, buf + 1);
  buf[0] = m;
  return m;
}

void FixBearingGrains::unpack_restart(int i, int nth)
{
  double **extra = atom->extra;
  int m = 0;
  for (int k = 0; k < nth; ++k) m += static_cast<int>(extra[i][m]);
  unpack_exchange(i, &extra[i][m + 1]);
}

int FixBearingGrains::size_restart(int i)
{
  return 3 + numbers_kept * static_cast<int>(grains_[i].contacts.size());
}

int FixBearingGrains::maxsize_restart() { return 3 + numbers_kept * most_contacts; }

// Names the last positions and loads of the shafts in the order in which they are named in the
// command.
template <class List> void FixBearingGrains::keep_shafts(List &list)
{
  list(known_);
  for (Shaft &s : shafts_) list(s.now, s.force, s.moment);
}

void FixBearingGrains::write_restart(FILE *fp)
{
  bearing::NumberWriter list;
  keep_shafts(list);
  if (comm->me == 0) list.write(fp);
}

void FixBearingGrains::restart(char *buf)
{
  bearing::NumberReader list(buf);
  keep_shafts(list);
}

double FixBearingGrains::memory_usage()
{
  double bytes = grains_.capacity() * sizeof(Grain) + neighbours_.capacity() * sizeof(Neighbour);
  for (const Grain &g : grains_) bytes += g.contacts.capacity() * sizeof(Contact);
  return bytes;
}
