// SPDX-License-Identifier: GPL-2.0-or-later
// bearing_input, bearing_output, bearing_range, bearing_host, bearing_step,
// bearing_words, bearing_parts: a deck's data files, result folder, numbers, host, restart file,
// the number of its step, variables of several words and parts of a model, with errors that help
// before anything runs.
#ifdef COMMAND_CLASS
// clang-format off
CommandStyle(bearing_input,BearingInput)
CommandStyle(bearing_output,BearingOutput)
CommandStyle(bearing_range,BearingRange)
CommandStyle(bearing_host,BearingHost)
CommandStyle(bearing_step,BearingStep)
CommandStyle(bearing_words,BearingWords)
CommandStyle(bearing_parts,BearingParts)
// clang-format on
#else
#ifndef LMP_DECK_FILES_H
#define LMP_DECK_FILES_H

#include "bearing_compat.h"

namespace LAMMPS_NS {

// bearing_input FOLDER NAME [needs KEY ...]: include FOLDER/NAME, or the row NAME of a table
// FOLDER/*.csv (core/settings/data_table.h); it must set these variables. If it does not exist, the
// error lists what does. With `set` instead of `needs` the file has been included already and only
// the variables are checked, including those set by its own includes. `set table FILE` checks those
// of a table (deck/variable_table.h), with their defaults and ranges.
class BearingInput : public bearing::CommandBase {
 public:
  explicit BearingInput(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

// bearing_output FOLDER [remove NAME ...]: create the folder and its parents, check that it is
// writable and that no other run writes to it, and remove the files NAME from it.
class BearingOutput : public bearing::CommandBase {
 public:
  explicit BearingOutput(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

// bearing_range NAME VALUE LO HI [whole] [or V] [advice TEXT]: stop with a message unless LO <=
// VALUE <= HI (and it is a whole number), or VALUE = V; TEXT is the advice in the message.
// bearing_range table FILE: the same of all variables of a table, after setting its defaults.
class BearingRange : public bearing::CommandBase {
 public:
  explicit BearingRange(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

// bearing_host KIND NAME: set the string variables KIND to liggghts or lammps and NAME to the
// host's name and version, unless they exist already (-var). `spheres FORMAT` sets up sphere atoms
// and sets FORMAT to the keyword of dump_modify before the format of a line. `bearings` instead of
// `spheres` adds the first commands of bearing decks.
class BearingHost : public bearing::CommandBase {
 public:
  explicit BearingHost(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

// bearing_step N: set the number of the current step to N; the time is kept.
class BearingStep : public bearing::CommandBase {
 public:
  explicit BearingStep(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

// bearing_words NAME WORD ...: set the string variable NAME to these words. Needed because the
// hosts do not substitute variables within quotes, which make one word of several.
class BearingWords : public bearing::CommandBase {
 public:
  explicit BearingWords(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

// bearing_parts PREFIX WITHOUT NAME ...: for each NAME set a string variable PREFIXNAME to 0 if the
// list WITHOUT (names joined by +, or `none`) contains it, otherwise to 1; set PREFIXparts to all
// names.
class BearingParts : public bearing::CommandBase {
 public:
  explicit BearingParts(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

}    // namespace LAMMPS_NS

#endif
#endif
