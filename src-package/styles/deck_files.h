// SPDX-License-Identifier: GPL-2.0-or-later
// bearing_input, bearing_output, bearing_range, bearing_host, bearing_resume, bearing_step,
// bearing_words, bearing_parts: a deck's data files, result folder, numbers, host, restart file,
// the number of its step, variables of several words and parts of a model, with errors that help
// before anything runs.
#ifdef COMMAND_CLASS
// clang-format off
CommandStyle(bearing_input,BearingInput)
CommandStyle(bearing_output,BearingOutput)
CommandStyle(bearing_range,BearingRange)
CommandStyle(bearing_host,BearingHost)
CommandStyle(bearing_resume,BearingResume)
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
// FOLDER/*.csv (core/settings/data_table.h); it must set these variables.
// With `set` for `needs` it has been included, and only the variables are checked: those as well
// that files set which it includes. After `set table FILE` they are those of a table
// (deck/variable_table.h), with their defaults and ranges.
class BearingInput : public bearing::CommandBase {
 public:
  explicit BearingInput(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

// bearing_output FOLDER [remove NAME ...]: make the folder (and those above it), make sure that it
// can be written and that no other run does, and remove the files NAME from it.
class BearingOutput : public bearing::CommandBase {
 public:
  explicit BearingOutput(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

// bearing_range NAME VALUE LO HI [whole] [or V] [advice TEXT]: stop with a message unless LO <=
// VALUE <= HI (and it is a whole number), or VALUE = V; TEXT says what to do.
// bearing_range table FILE: the same of all variables of a table, after setting its defaults.
class BearingRange : public bearing::CommandBase {
 public:
  explicit BearingRange(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

// bearing_host KIND NAME: set the string variables KIND to liggghts or lammps and NAME to the
// host's name and version, unless they are there already (-var). With `spheres FORMAT` set up atoms
// that are spheres, and FORMAT to what dump_modify has before the format of a line. `bearings` for
// `spheres` adds what decks of bearings begin with.
class BearingHost : public bearing::CommandBase {
 public:
  explicit BearingHost(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

// bearing_resume NAME yes|no FILE [overwrite yes|no]: set the index variable NAME to yes if asked
// to and FILE is there, else to no. A finished run beside FILE is then refused, with `overwrite
// no`.
class BearingResume : public bearing::CommandBase {
 public:
  explicit BearingResume(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

// bearing_step N: the number of the present step is N; the time goes on.
class BearingStep : public bearing::CommandBase {
 public:
  explicit BearingStep(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

// bearing_words NAME WORD ...: set the string variable NAME to these words. In quotes, where the
// hosts take several words for one, they put no variable's value.
class BearingWords : public bearing::CommandBase {
 public:
  explicit BearingWords(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

// bearing_parts PREFIX WITHOUT NAME ...: set a string variable PREFIXNAME for each NAME, to 0
// where WITHOUT, names joined by +, has it, else to 1, and PREFIXparts to all names. WITHOUT is
// `none` for no name.
class BearingParts : public bearing::CommandBase {
 public:
  explicit BearingParts(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

}    // namespace LAMMPS_NS

#endif
#endif
