// SPDX-License-Identifier: GPL-2.0-or-later
// fix bearing/grains: computes contacts of grains with each other and with walls. A wall may rotate
// with the shaft of a fix bearing/shaft and exert loads on it. Sums are evaluated in the order of
// tags, so the results do not depend on the number of ranks.
#ifdef FIX_CLASS
FixStyle(bearing/grains,FixBearingGrains)
#else
#ifndef LMP_FIX_BEARING_GRAINS_H
#define LMP_FIX_BEARING_GRAINS_H

#include "../core/bodies/ring_program.h"
#include "../core/geometry/turning_wall.h"
#include "../core/laws/grain_contact.h"
#include "../core/numbers/lab_axes.h"
#include "../deck/column_list.h"
#include "bearing_compat.h"

#include <vector>

namespace bearing {
class Arguments;
}

namespace LAMMPS_NS {

class FixBearingShaft;
class PairBearingHertz;

class FixBearingGrains : public Fix, public bearing::ColumnList {
 public:
  FixBearingGrains(class LAMMPS *, int, char **);
  ~FixBearingGrains() override;
  int setmask() override;
  void init() override;
  void setup(int) override;
  void post_force(int) override;
  double compute_vector(int) override;
  std::vector<Item> columns() const override;

  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  double memory_usage() override;

 private:
  // Contact with the grain that has this tag or, if the tag is 0, with a part of the walls.
  struct Contact {
    bearing::tag_t tag = 0;
    int part = 0;
    raceway::GrainContact of;
  };
  struct Grain {
    std::vector<Contact> contacts;
    double lost = 0.0;    // energy dissipated so far, J; each contact with another grain counts
                          // half
  };
  // A shaft with walls, which is known on all ranks. The bearing axis is the third component.
  struct Shaft {
    std::string id;
    FixBearingShaft *fix = nullptr;
    raceway::RingAtom now, before;
    raceway::Vec3 force, moment;    // force (N) and moment (N m) exerted by grains, referred to the
                                    // shaft's centre
  };
  struct Velocity {
    raceway::Vec3 v, w;
  };
  struct Wall {
    raceway::TurningWall shape;
    int shaft = -1;    // index in shafts_; -1 for a wall at rest
    int first = 0;     // index of its first part
    // State in the current step, with the bearing axis as the third component. The coordinate axes
    // of the wall are its rotation axis pose.e and the axes e1 and e2, which do not rotate about
    // pose.e.
    raceway::RingAtom pose;
    Velocity moved;
    raceway::Vec3 e1, e2;
  };
  struct Neighbour {
    int i, j;    // local indices; this rank owns i
  };
  struct Push {    // load exerted by a grain on a wall
    bearing::tag_t tag;
    int part, shaft;
    raceway::Vec3 force, moment;    // moment about the shaft's centre
    double work;                    // J, work done on the grain in the last step
  };
  struct Sums {
    double lost = 0.0, kinetic = 0.0, elastic = 0.0, contacts = 0.0;
    raceway::Vec3 first_moment;
  };

  template <class List> static void keep(List &, Grain &);
  template <class List> void keep_shafts(List &);
  void read_wall(bearing::Arguments &, bool drum);
  void check_step() const;
  void find_neighbours();
  void find_shafts();
  Velocity velocity(const Shaft *) const;
  void act(bool advance);
  void touch_grains(const Neighbour &, double dt, std::vector<Contact> &, double &lost,
                    raceway::Vec3 &force, raceway::Vec3 &torque) const;
  void touch_walls(int i, double dt, std::vector<Contact> &, double &lost, raceway::Vec3 &force,
                   raceway::Vec3 &torque);
  // Returns the contact that grain i had with the given grain or part in the previous step, or null
  // if there was none.
  const raceway::GrainContact *kept(int i, bearing::tag_t, int part) const;
  bool touched_a_wall(int i) const;
  void load_shafts();
  Sums sums() const;

  static constexpr int most_contacts = 24, numbers_kept = 15;

  PairBearingHertz *pair_;
  raceway::LabAxes axes_;
  raceway::GrainLaw wall_law_;
  std::vector<Wall> walls_;
  std::vector<Shaft> shafts_;
  std::vector<Grain> grains_;
  std::vector<Neighbour> neighbours_;
  std::vector<Push> pushes_;
  int build_ = -1;
  bool known_ = false;    // true if the contacts are those of the last step
  double work_ = 0.0;     // J, work done by the walls on the grains
  Sums start_, now_;
  bigint summed_ = -1;
};

}    // namespace LAMMPS_NS

#endif
#endif
