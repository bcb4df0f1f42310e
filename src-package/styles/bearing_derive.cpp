// SPDX-License-Identifier: GPL-2.0-or-later
#include "bearing_derive.h"

#include "deck_values.h"
#include "derive_laws.h"

using namespace LAMMPS_NS;
using bearing::Arguments;

void BearingDerive::command(int narg, char **arg)
{
  bearing::DeriveLaws laws = bearing::data_laws();
  laws.merge(bearing::run_laws());
  Arguments args(lmp, "bearing_derive", narg, arg, 0);
  std::vector<std::string> names;
  for (const auto &law : laws) names.push_back(law.first);
  const auto law = laws.find(names[args.choice("law", names)]);
  if (args.more()) args.unknown("none, the command ends here");
  bearing::DeckValues deck(lmp, args);
  law->second(deck);
}
