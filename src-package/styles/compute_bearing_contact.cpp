// SPDX-License-Identifier: GPL-2.0-or-later
#include "compute_bearing_contact.h"

#include "contact_context.h"
#include "pair_bearing_hertz.h"

using namespace LAMMPS_NS;
using bearing::RacewayContact;

// compute ID group bearing/contact all|usual|attribute ...
ComputeBearingContact::ComputeBearingContact(BRG_COMPUTE_ARGS) :
    BRG_COMPUTE_BASE, pair_(PairBearingHertz::find(lmp, "compute bearing/contact"))
{
  bearing::Arguments args(lmp, std::string("compute ") + id + " bearing/contact", narg, arg,
                          BRG_COMPUTE_FIRST);
  const bearing::Offer offer = bearing::offer_of(lmp, *pair_);
  do bearing::select_columns(args, args.word("a contact attribute"), offer, columns_);
  while (args.more());
  local_flag = 1;
  size_local_rows = 0;
  // the host expects a vector if there is one column, and an array if there are several
  size_local_cols = columns_.size() == 1 ? 0 : static_cast<int>(columns_.size());
}

void ComputeBearingContact::init()
{
  const std::string name = std::string("compute ") + id + " bearing/contact";
  pair_ = PairBearingHertz::find(lmp, name);
  context_ = bearing::context_of(lmp, *pair_, columns_, name);
}

void ComputeBearingContact::compute_local()
{
  invoked_local = update->ntimestep;
  pair_ = PairBearingHertz::find(
      lmp, "compute bearing/contact");    // the pair style may have been replaced between runs
  values_.clear();
  for (const RacewayContact &c : pair_->table().raceway) {
    if (!c.live || !(atom->mask[c.i_ball] & groupbit)) continue;
    const bearing::ContactView view = context_.view(c);
    for (const bearing::ContactColumn *a : columns_) values_.push_back(a->value(view));
  }
  const size_t n = values_.size() / columns_.size();
  size_local_rows = static_cast<int>(n);
  rows_.resize(n);
  for (size_t k = 0; k < n; ++k) rows_[k] = &values_[k * columns_.size()];
  vector_local = values_.data();
  array_local = rows_.data();
}

std::vector<bearing::ColumnList::Item> ComputeBearingContact::columns() const
{
  std::vector<Item> list;
  for (const bearing::ContactColumn *a : columns_) list.push_back({a->is.name, a->is.format});
  return list;
}

double ComputeBearingContact::memory_usage()
{
  return values_.capacity() * sizeof(double) + rows_.capacity() * sizeof(double *);
}
