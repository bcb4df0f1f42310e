// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_run.h"

#include <vector>

using namespace LAMMPS_NS;

FixBearingRun::FixBearingRun(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg)
{
  for (int k = 3; k < narg; ++k) words_ += (k > 3 ? " " : "") + std::string(arg[k]);
  restart_global = 1;
}

void FixBearingRun::write_restart(FILE *fp)
{
  if (comm->me != 0) return;
  const int size = static_cast<int>(sizeof now_ + words_.size() + 1);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(&now_, sizeof now_, 1, fp);
  fwrite(words_.c_str(), 1, words_.size() + 1, fp);
}

void FixBearingRun::restart(char *buf)
{
  memcpy(&now_, buf, sizeof now_);
  const std::string then = buf + sizeof now_;
  if (then != words_)
    BRG_ALL("run_bearing: the restart file belongs to another run: '" + then + "', this one is '" +
            words_ + "'. Remove it, or resume with its settings");
  resumed_ = true;
}
