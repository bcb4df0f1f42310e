// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef COMMAND_CLASS
// clang-format off
CommandStyle(bearing,NameBearing)
// clang-format on
#else
#ifndef LMP_NAME_BEARING_H
#define LMP_NAME_BEARING_H

#include "bearing_compat.h"

namespace bearing {
class Arguments;
struct NamedBearing;
}

namespace LAMMPS_NS {

// bearing NAME FILE|ROW types B C I O [clearance X] [contact_angle A] [four_point A]
// [cage auto|yes|no|ring|chain] [inputs FOLDER] [vars K ...]: reads the data of a bearing for later
// commands that refer to it by name, and sets the variables NAME_... of the host. Stops with an
// error if -var sets a variable that is defined neither in the deck nor in the data.
class NameBearing : public bearing::CommandBase {
 public:
  explicit NameBearing(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);

 private:
  void refuse_unknown(const bearing::Arguments &, const std::string &inputs);
  static std::string cage_ball_datum(const bearing::NamedBearing &);
  std::string usual_cage(bool cage_balls);
  void derive(const bearing::Arguments &, bearing::NamedBearing &);
  void set_variables(const bearing::NamedBearing &);
};

}    // namespace LAMMPS_NS

#endif
#endif
