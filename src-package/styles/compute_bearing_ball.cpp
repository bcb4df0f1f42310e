// SPDX-License-Identifier: GPL-2.0-or-later
#include "compute_bearing_ball.h"

#include "../core/figures/bearing_columns.h"
#include "contact_context.h"
#include "fix_bearing_state.h"
#include "pair_bearing_hertz.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace raceway;
using bearing::RacewayContact;
namespace of_ball = bearing::of_ball;

// compute ID group bearing/ball ATTRIBUTE|inner_ATTRIBUTE|outer_ATTRIBUTE ...
ComputeBearingBall::ComputeBearingBall(BRG_COMPUTE_ARGS) :
    BRG_COMPUTE_BASE, pair_(PairBearingHertz::find(lmp, "compute bearing/ball"))
{
  bearing::Arguments args(lmp, std::string("compute ") + id + " bearing/ball", narg, arg,
                          BRG_COMPUTE_FIRST);
  do {
    const std::string name = args.word("a ball attribute");
    const auto own = std::find_if(of_ball::list, of_ball::list + of_ball::N,
                                  [&name](const raceway::Column &c) { return name == c.name; });
    if (own != of_ball::list + of_ball::N) {
      columns_.push_back({static_cast<int>(own - of_ball::list), false, nullptr});
      continue;
    }
    const bool is_inner = name.compare(0, 6, "inner_") == 0,
               is_outer = name.compare(0, 6, "outer_") == 0;
    const bearing::ContactColumn *a =
        is_inner || is_outer ? bearing::find_contact_column(name.substr(6)) : nullptr;
    if (!a)
      args.fail("unknown attribute '" + name +
                "'; known: azimuth, orbit, turn_w, turn_x, turn_y, turn_z, and with inner_ or "
                "outer_ before it: " +
                bearing::contact_column_names());
    if (a->needs_film() && !pair_->coefficients().lubricated())
      args.fail("attribute '" + name + "' " + bearing::needs_lubricant);
    columns_.push_back({-1, is_inner, a});
    needed_.push_back(a);
  } while (args.more());
  peratom_flag = 1;
  size_peratom_cols = columns_.size() == 1 ? 0 : static_cast<int>(columns_.size());
}

ComputeBearingBall::~ComputeBearingBall()
{
  memory->destroy(vector_);
  memory->destroy(array_);
}

void ComputeBearingBall::init()
{
  const std::string name = std::string("compute ") + id + " bearing/ball";
  pair_ = PairBearingHertz::find(lmp, name);
  context_ = bearing::context_of(lmp, *pair_, needed_, name);
  for (const Column &c : columns_)
    if (c.own >= 0 && of_ball::needs_turn(c.own) && !pair_->profiles().any_ball())
      BRG_ALL(name + ": attribute '" + of_ball::list[c.own].name +
              "' needs a fix bearing/profile with a profile of balls, which tracks their rotation");
}

// All values are 0 for atoms other than balls. The values of a contact are 0 if the ball does not
// touch that raceway.
void ComputeBearingBall::compute_peratom()
{
  invoked_peratom = update->ntimestep;
  pair_ = PairBearingHertz::find(
      lmp, "compute bearing/ball");    // the pair style may have been replaced between runs
  const int n = static_cast<int>(columns_.size());
  if (atom->nmax > nmax_) {
    nmax_ = atom->nmax;
    memory->destroy(vector_);
    memory->destroy(array_);
    memory->create(vector_, nmax_, "bearing/ball:vector");
    memory->create(array_, nmax_, n, "bearing/ball:array");
    vector_atom = vector_;
    array_atom = array_;
  }
  bearing::send_velocities(lmp);
  for (int i = 0; i < atom->nlocal; ++i) {
    vector_[i] = 0.0;
    for (int k = 0; k < n; ++k) array_[i][k] = 0.0;
  }
  for (const RacewayContact &c : pair_->table().raceway) {
    if (!(atom->mask[c.i_ball] & groupbit) || !pair_->table().leads(c)) continue;
    const bearing::ContactView view = context_.view(c);
    for (int k = 0; k < n; ++k) {
      double &v = array_[c.i_ball][k];
      if (columns_[k].attribute == nullptr && v != 0.0 && c.side() == Side::inner)
        continue;    // values that belong to the ball itself are relative to the outer ring
      if (columns_[k].own >= 0) {
        v = own_value(columns_[k].own, c);
      } else if ((c.live || columns_[k].attribute->needs_surroundings()) &&
                 columns_[k].inner == (c.side() == Side::inner)) {
        v = columns_[k].attribute->value(view);
      }
      if (k == 0) vector_[c.i_ball] = v;
    }
  }
}

double ComputeBearingBall::own_value(int own, const RacewayContact &c) const
{
  if (own == of_ball::AZIMUTH)
    return bearing::azimuth(Vec3::from(atom->x[c.i_ball]) - Vec3::from(atom->x[c.i_ring]),
                            context_.axis);
  if (own == of_ball::ORBIT) return bearing::orbit_of(*atom, *pair_, c);
  const Quaternion turn = pair_->state()->turn(c.i_ball);
  double vector[3];
  LabAxes{pair_->coefficients().axis_index()}.lab(turn.v).to(vector);
  return own == of_ball::TURN_W ? turn.w : vector[own - of_ball::TURN_X];
}

std::vector<bearing::ColumnList::Item> ComputeBearingBall::columns() const
{
  std::vector<Item> list;
  for (const Column &c : columns_) {
    const raceway::Column &is = c.attribute ? c.attribute->is : of_ball::list[c.own];
    const std::string before = !c.attribute ? "" : c.inner ? "inner_" : "outer_";
    list.push_back({before + is.name, is.format});
  }
  return list;
}

double ComputeBearingBall::memory_usage()
{
  return double(nmax_) * (columns_.size() + 1) * sizeof(double);
}
