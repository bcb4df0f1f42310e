// SPDX-License-Identifier: GPL-2.0-or-later
#include "kept_commands.h"

namespace bearing {

static void write_number(FILE *fp, size_t n)
{
  const int number = static_cast<int>(n);
  fwrite(&number, sizeof(int), 1, fp);
}

void write_commands(FILE *fp, const Commands &commands)
{
  write_number(fp, commands.size());
  for (const auto &words : commands) {
    write_number(fp, words.size());
    for (const std::string &w : words) {
      write_number(fp, w.size());
      fwrite(w.data(), 1, w.size(), fp);
    }
  }
}

bool read_commands(FILE *fp, MPI_Comm world, Commands &commands)
{
  int rank, whole = 1;
  MPI_Comm_rank(world, &rank);
  const auto number = [&] {
    int n = 0;
    if (rank == 0 && whole && fread(&n, sizeof(int), 1, fp) != 1) whole = n = 0;
    MPI_Bcast(&n, 1, MPI_INT, 0, world);
    return n;
  };
  commands.resize(number());
  for (auto &words : commands) {
    words.resize(number());
    for (std::string &w : words) {
      w.resize(number());
      if (rank == 0 && fread(&w[0], 1, w.size(), fp) != w.size()) whole = 0;
      MPI_Bcast(&w[0], static_cast<int>(w.size()), MPI_CHAR, 0, world);
    }
  }
  MPI_Bcast(&whole, 1, MPI_INT, 0, world);
  return whole;
}

}    // namespace bearing
