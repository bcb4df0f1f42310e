// SPDX-License-Identifier: GPL-2.0-or-later
// Speeds up the start of Open MPI for a process without a launcher. Such a process has no peers,
// but Open MPI would start a daemon for it (0.2 s), probe all networks (0.1 s) and look for the
// caches and devices of the machine (0.01 s), which matter only to processes that share it.
#pragma once

#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <string>
#include <unistd.h>
#include <vector>

class LoneStart {
 public:
  // Must be created before MPI_Init. Settings made by the user are kept, and nothing is set if
  // there is a launcher.
  LoneStart() : alone_(!launched())
  {
    if (!alone_) return;
    offer("OMPI_MCA_ess_singleton_isolated", "1");    // no daemon
    offer("OMPI_MCA_pml", "ob1");                     // no search for fast networks
    // no session folder in /tmp, because simultaneous processes would delete each other's folders
    offer("OMPI_MCA_orte_create_session_dirs", "0");
    if (any_begins_with({"HWLOC_"})) return;
    offer("HWLOC_COMPONENTS", "synthetic");
    offer("HWLOC_SYNTHETIC", "pu:1");
  }

  bool alone() const { return alone_; }    // true if there is no launcher

  // Must be called after MPI_Init, so that programs started by a deck (`shell mpirun ...`) do not
  // inherit the settings.
  void forget()
  {
    for (const std::string &name : set) unsetenv(name.c_str());
    set.clear();
  }

 private:
  bool alone_;
  std::vector<std::string> set;

  void offer(const char *name, const char *value)
  {
    if (getenv(name)) return;
    setenv(name, value, 0);
    set.push_back(name);
  }

  // environment variables that are set by mpirun of Open MPI or MPICH, srun, aprun and flux
  static bool launched()
  {
    return any_begins_with({"OMPI_COMM_WORLD_", "PMIX_", "PMI_", "PMI2_", "SLURM_STEP",
                            "SLURM_PROCID", "ALPS_APP_", "FLUX_"});
  }

  // Returns true if the name of an environment variable begins with one of the words.
  static bool any_begins_with(std::initializer_list<const char *> words)
  {
    for (char **entry = environ; *entry; ++entry)
      for (const char *word : words)
        if (strncmp(*entry, word, strlen(word)) == 0) return true;
    return false;
  }
};
