// SPDX-License-Identifier: GPL-2.0-or-later
// A table that is written by a fix. The file is opened on rank 0. If this fails, the run stops with
// an error on all ranks. If there is no file name, nothing is written.
#pragma once

#include "../core/settings/arguments.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <mpi.h>

namespace bearing {

class TextFile {
 public:
  ~TextFile()
  {
    if (file_) fclose(file_);
  }
  TextFile() = default;
  TextFile(const TextFile &) = delete;
  TextFile &operator=(const TextFile &) = delete;

  bool wanted() const { return wanted_; }    // valid on every rank
  FILE *file() const { return file_; }       // open on rank 0; null on other ranks
  void open(const Arguments &args, const std::string &name, const char *head, MPI_Comm world)
  {
    int rank, trouble = 0;
    MPI_Comm_rank(world, &rank);
    wanted_ = true;
    if (rank == 0) {
      file_ = fopen(name.c_str(), "w");
      if (file_) fprintf(file_, "# %s\n", head);
      else trouble = errno;
    }
    MPI_Bcast(&trouble, 1, MPI_INT, 0, world);
    if (trouble) args.fail("cannot write '" + name + "': " + strerror(trouble));
  }

 private:
  bool wanted_ = false;
  FILE *file_ = nullptr;
};

}    // namespace bearing
