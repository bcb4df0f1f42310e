// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef COMMAND_CLASS
// clang-format off
CommandStyle(bearing_fleet,BearingFleet)
// clang-format on
#else
#ifndef LMP_BEARING_FLEET_H
#define LMP_BEARING_FLEET_H

#include "../core/settings/arguments.h"
#include "bearing_compat.h"

namespace LAMMPS_NS {

// bearing_fleet FILE numbers FIRST LAST STEP [only K] grid COLUMNS SPACING tables FOLDER NOTE
// create WORD ...: bearings in a grid, each with the load, speed and phase given in FILE for its
// number.
class BearingFleet : public bearing::CommandBase {
 public:
  explicit BearingFleet(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);

 private:
  struct Fleet {
    std::vector<std::string> commands;    // commands in FILE
    int first = 0, last = 0, step = 1, only = 0;
    int columns = 0;
    double spacing = 0.0;    // m, of the grid
    std::string folder, note;
    std::vector<std::string> words;    // arguments of create_bearing
  };

  Fleet parse(bearing::Arguments &);
  void read(bearing::Arguments &, const std::string &file, Fleet &);
  void create(const bearing::Arguments &, const Fleet &, int number, bool last);
};

}    // namespace LAMMPS_NS

#endif
#endif
