// SPDX-License-Identifier: GPL-2.0-or-later
// Fast start of Open MPI for a process without a launcher. Such a process has no peers, but Open
// MPI would start a daemon for it (0.2 s) and probe all its networks (0.1 s).
#ifndef LONE_START_H
#define LONE_START_H

#include <cstdlib>
#include <cstring>
#include <string>
#include <unistd.h>
#include <vector>

class LoneStart {
 public:
  // To be created before MPI_Init. Settings of the user are kept; under a launcher nothing is set.
  LoneStart()
  {
    if (launched()) return;
    offer("OMPI_MCA_ess_singleton_isolated", "1");    // no daemon
    offer("OMPI_MCA_pml", "ob1");                     // no search for fast networks
    // no session folder below /tmp, which simultaneous processes would delete from one another
    offer("OMPI_MCA_orte_create_session_dirs", "0");
  }

  // To be called after MPI_Init: programs started by a deck (`shell mpirun ...`) must not inherit
  // the settings.
  void forget()
  {
    for (const std::string &name : set) unsetenv(name.c_str());
    set.clear();
  }

 private:
  std::vector<std::string> set;

  void offer(const char *name, const char *value)
  {
    if (getenv(name)) return;
    setenv(name, value, 0);
    set.push_back(name);
  }

  // environment variables that mpirun of Open MPI or MPICH, srun, aprun and flux set
  static bool launched()
  {
    for (char **entry = environ; *entry; ++entry)
      for (const char *start : {"OMPI_COMM_WORLD_", "PMIX_", "PMI_", "PMI2_", "SLURM_STEP",
                                "SLURM_PROCID", "ALPS_APP_", "FLUX_"})
        if (strncmp(*entry, start, strlen(start)) == 0) return true;
    return false;
  }
};

#endif
