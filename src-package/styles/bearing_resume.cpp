// SPDX-License-Identifier: GPL-2.0-or-later
#include "bearing_resume.h"

#include "result_folder.h"

#include <filesystem>

using namespace LAMMPS_NS;
using bearing::Arguments;

void BearingResume::command(int narg, char **arg)
{
  Arguments args(lmp, "bearing_resume", narg, arg, 0);
  const auto yes = [&args](const char *what) { return args.choice(what, {"no", "yes"}) == 1; };
  const std::string first = args.word("restart file");
  const bool plain = args.take("resume");
  if (!plain && args.more() && args.next() != "yes" && args.next() != "no")
    args.fail("a folder's name is one word without blanks, not '" + first + " " + args.next() +
              "'");
  const bool asked = yes("resume");
  const std::string file = plain ? first : args.word("restart file");
  const bool overwrite = args.take("overwrite") ? yes("overwrite") : !plain;
  if (args.more()) args.unknown("resume, overwrite");
  if (plain) {
    const std::string folder = std::filesystem::path(file).parent_path().string();
    bearing::claim_result_folder(lmp, args, folder.empty() ? "." : folder);
  }
  const bool on = bearing::goes_on(lmp, args, {file, asked, overwrite});
  const std::string name = plain ? "b_resumed" : first,
                    value = plain ? (on ? "1" : "0") : (on ? "yes" : "no");
  input->one(("variable " + name + " delete").c_str());
  input->one(("variable " + name + " index " + value).c_str());
}
