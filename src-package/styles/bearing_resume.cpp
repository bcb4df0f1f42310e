// SPDX-License-Identifier: GPL-2.0-or-later
#include "bearing_resume.h"

#include "result_folder.h"

#include <filesystem>

using namespace LAMMPS_NS;
using bearing::Arguments;

void BearingResume::command(int narg, char **arg)
{
  Arguments args(lmp, "bearing_resume", narg, arg, 0);
  const std::string file = args.word("restart file");
  if (args.more() && args.next() != "resume")
    args.fail("a folder's name is one word without blanks, not '" + file + " " + args.next() + "'");
  bool asked = false, overwrite = false;
  while (args.more())
    if (!args.yes("resume", asked) && !args.yes("overwrite", overwrite)) args.unknown();
  const std::string folder = std::filesystem::path(file).parent_path().string();
  bearing::claim_result_folder(lmp, args, folder.empty() ? "." : folder);
  const bool on = bearing::goes_on(lmp, args, {file, asked, overwrite});
  input->one("variable b_resumed delete");
  input->one(on ? "variable b_resumed index 1" : "variable b_resumed index 0");
}
