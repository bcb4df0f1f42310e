// SPDX-License-Identifier: GPL-2.0-or-later
#include "kept_commands.h"

#include <cstring>

namespace bearing {

struct Mark {
  char name[8] = "Raceway";
  int layout = RESTART_LAYOUT;
};

static void write_number(FILE *fp, size_t n)
{
  const int number = static_cast<int>(n);
  fwrite(&number, sizeof(int), 1, fp);
}

void write_commands(FILE *fp, const Commands &commands)
{
  const Mark mark;
  fwrite(&mark, sizeof mark, 1, fp);
  write_number(fp, commands.size());
  for (const auto &words : commands) {
    write_number(fp, words.size());
    for (const std::string &w : words) {
      write_number(fp, w.size());
      fwrite(w.data(), 1, w.size(), fp);
    }
  }
}

constexpr int MOST = 1000000;    // largest number of commands, words per command, or characters per
                                 // word

// Returns the layout number of the restart file, 0 if it has none, or a negative value if the file
// ends early.
static int read_layout(FILE *fp, MPI_Comm world, int rank)
{
  Mark found;
  if (rank == 0 && fread(&found, sizeof found, 1, fp) != 1) found.layout = -1;
  else if (memcmp(found.name, Mark().name, sizeof found.name) != 0) found.layout = 0;
  MPI_Bcast(&found.layout, 1, MPI_INT, 0, world);
  return found.layout;
}

std::string read_commands(FILE *fp, MPI_Comm world, Commands &commands)
{
  int rank, whole = 1;
  MPI_Comm_rank(world, &rank);
  const int layout = read_layout(fp, world, rank);
  if (layout >= 0 && layout != RESTART_LAYOUT)
    return "the restart file has " +
           (layout ? "layout " + std::to_string(layout) : std::string("no layout number")) +
           " and was written by another build of Raceway; this program reads layout " +
           std::to_string(RESTART_LAYOUT) +
           ". Continue the run with the build that began it, or start it anew";
  if (layout < 0) return CUT_OR_DAMAGED;
  const auto number = [&] {
    int n = 0;
    if (rank == 0 && whole && fread(&n, sizeof(int), 1, fp) != 1) whole = 0;
    if (n < 0 || n > MOST) whole = 0;
    if (!whole) n = 0;
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
  return whole ? "" : CUT_OR_DAMAGED;
}

}    // namespace bearing
