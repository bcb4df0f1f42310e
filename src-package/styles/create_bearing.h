// SPDX-License-Identifier: GPL-2.0-or-later
// create_bearing: creates the balls, the cage balls and one atom per ring of a bearing. The bearing
// starts rolling or at rest.
#ifdef COMMAND_CLASS
CommandStyle(create_bearing,CreateBearing)
#else
#ifndef LMP_CREATE_BEARING_H
#define LMP_CREATE_BEARING_H

#include "../core/geometry/groove.h"
#include "../core/laws/start_attitude.h"
#include "new_atoms.h"

namespace bearing {
class Arguments;
}

namespace LAMMPS_NS {

class PairBearingHertz;

class CreateBearing : public bearing::CommandBase {
 public:
  explicit CreateBearing(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);

 private:
  struct Plan {
    int ball_type = 0, inner_type = 0, outer_type = 0;
    int cage_type = 0, ring_cage = 0;    // types of cage balls and of a one-piece cage; 0: none
    int balls = 0;
    double ball_radius = 0.0, ball_density = 7800.0;
    double cage_radius = 0.0, cage_density = 1140.0;
    double centre[3] = {0.0, 0.0, 0.0};
    double phase = 0.0;                             // rad, azimuth of the first ball
    double inner_speed = 0.0, outer_speed = 0.0;    // rad/s
    int seat = 0;    // +1 or -1: the inner ring starts moved forward or backward into contact with
                     // all balls
    double thrust = 0.0;                   // N, on the inner ring
    double middle = 0.0;                   // m, radius midway between the raceways
    double pitch = 0.0;                    // m, radius of the circle through the balls' centres
    double ball_z = 0.0, inner_z = 0.0;    // m, positions along the axis
    double cosine = 1.0;                   // cosine of the contact angle
    bool groups = false;                   // true if the groups are to be created
  };

  void command_named(bearing::Arguments &);
  bool balls_of(int type) const;
  void check_host(const bearing::Arguments &);
  bool create(const bearing::Arguments &, Plan);
  Plan parse(bearing::Arguments &);
  static bool take_motion(bearing::Arguments &, Plan &);
  void check(const bearing::Arguments &, const PairBearingHertz &, Plan &);
  static void seat(const bearing::Arguments &, const raceway::Groove &inner,
                   const raceway::Groove &outer, double clearance, Plan &);
  static raceway::BallRotation rotation(const Plan &, const PairBearingHertz &);
  void place(const Plan &, const PairBearingHertz &);
  void make_groups(const Plan &);
  void add(int type, const raceway::Vec3 &x, double radius, double mass, const raceway::Vec3 &v,
           const raceway::Vec3 &w);

  bearing::tag_t next_tag_ = 0;
  std::vector<bearing::NewAtom> atoms_;
};

}    // namespace LAMMPS_NS

#endif
#endif
