// SPDX-License-Identifier: GPL-2.0-or-later
#include "ring_settings.h"

#include "written.h"

#include <cmath>

using raceway::Freedom;
using raceway::RingInertia;
using raceway::RingProgram;
using raceway::Support;

namespace bearing {

static const char *const lab[] = {"x", "y", "z"}, *const turn[] = {"rx", "ry", "rz"};

RingWords::RingWords(Arguments &args, const raceway::LabAxes &axes, RingSettings &to, bool each) :
    args_(args), axes_(axes), to_(to), each_(each)
{
  for (int k = 0; k < 3; ++k) number_[axes_.lab_axis(k)] = k;
}

const char *RingWords::name_of(int dof) const
{
  return dof < RingProgram::TILT ? lab[axes_.lab_axis(dof)]
                                 : turn[axes_.lab_axis(dof - RingProgram::TILT)];
}

void RingWords::read_freedom(const std::string &name, int dof)
{
  Freedom &mode = to_.program.mode[dof];
  // in the order of Freedom
  mode = static_cast<Freedom>(args_.choice(name, {"fixed", "free", "speed", "position"}));
  if (mode == Freedom::speed || mode == Freedom::position)
    to_.value[dof] = DrivenValue::read(args_, name, each_);
}

bool RingWords::take_freedom()
{
  for (int dof = 0; dof < RingProgram::SPIN; ++dof)
    if (args_.take(name_of(dof))) {
      read_freedom(name_of(dof), dof);
      return true;
    }
  if (!args_.take("spin")) return false;
  read_freedom("spin", RingProgram::SPIN);
  if (to_.program.mode[RingProgram::SPIN] == Freedom::position)
    args_.fail("spin takes fixed, free or speed, not position");
  return true;
}

void RingWords::read_vector(int first, const std::string &what)
{
  for (int k : number_) to_.value[first + k] = DrivenValue::read(args_, what, each_);
}

RingInertia read_inertia(Arguments &args)
{
  RingInertia inertia;
  inertia.axial = args.positive("inertia about the axis (kg m^2)");
  inertia.transverse = args.positive("inertia across the axis (kg m^2)");
  if (inertia.axial > 2.0 * inertia.transverse)
    args.fail("inertia " + text(inertia.axial) + " " + text(inertia.transverse) +
              ": no body has more than twice as much about its axis as across it");
  return inertia;
}

void RingWords::read_support()
{
  std::vector<std::string> names;
  for (int dof = 0; dof < RingProgram::SPIN; ++dof) names.push_back(name_of(dof));
  Support &on = to_.program.support[args_.choice("support", names)];
  on.stiffness = args_.within("stiffness of the support", 0.0, 1e15);
  on.damping = args_.within("damping of the support", 0.0, 1e12);
  if (on.stiffness == 0.0 && on.damping == 0.0) args_.fail("a support needs stiffness or damping");
  to_.program.supported = true;
}

bool RingWords::take()
{
  RingProgram &p = to_.program;
  if (take_freedom()) return true;
  if (args_.positive("mass", p.mass, "mass (kg)")) return true;
  if (args_.take("inertia")) {
    p.inertia = read_inertia(args_);
  } else if (args_.take("force")) {
    read_vector(RingProgram::FORCE, "force (N)");
  } else if (args_.take("moment")) {
    read_vector(RingProgram::MOMENT, "moment (N m)");
  } else if (args_.number("rotating", p.turning.size, "rotating force (N)")) {
    p.turning.speed = args_.number("speed of the rotating force (rad/s)");
    p.turning.phase = args_.number("phase of the rotating force (rad)");
  } else if (args_.non_negative("unbalance", p.unbalance.moment, "unbalance (kg m)")) {
    p.unbalance.phase = args_.number("phase of the unbalance (rad)");
  } else if (args_.take("support")) {
    read_support();
  } else {
    return (each_ && (args_.word("to", to_.holder, "to") || take_load() || take_housing())) ||
           args_.non_negative("ramp", p.ramp, "ramp time (s)");
  }
  return true;
}

// Reads the loads of a radial bearing. `free loaded` frees the directions in which the loads act.
bool RingWords::take_load()
{
  if (args_.take("free")) {
    args_.choice("free", {"loaded"});
    return free_loaded_ = true;
  }
  if (args_.variable("load", load_)) return loads_ = true;
  if (args_.variable("load_azimuth", azimuth_)) return true;
  return args_.variable("axial", axial_) && (loads_ = true);
}

// Reads the settings of a housing on springs that carries the ring.
bool RingWords::take_housing()
{
  std::string housing;
  if (args_.variable("housing", housing)) {
    springs_ = housing == "springs";
    return true;
  }
  return args_.variable("housing_mass", housing_mass_) ||
         args_.variable("housing_frequency", housing_frequency_) ||
         args_.variable("housing_damping", housing_damping_);
}

// Sets the forces. The direction of the radial load is rounded to 15 digits, so that a load along
// -y has no component along x.
void RingWords::apply_load()
{
  RingProgram &p = to_.program;
  if (loads_) {
    for (int k = 0; k < 3; ++k)
      if (!to_.value[RingProgram::FORCE + k].is_zero())
        args_.fail("'force' excludes 'load' and 'axial', which set the same forces");
    const auto part = [this](double share) {
      return DrivenValue::constant(written(std::floor(1.0e15 * share + 0.5) / 1.0e15 * load_));
    };
    to_.value[RingProgram::FORCE] = part(std::cos(azimuth_));
    to_.value[RingProgram::FORCE + 1] = part(std::sin(azimuth_));
    to_.value[RingProgram::FORCE + 2] = DrivenValue::constant(axial_);
    const auto moment = [this](int k) {
      const double value = to_.value[RingProgram::MOMENT + k].constant_value();
      return std::isnan(value) ? 0.0 : value;
    };
    const bool turns = p.mode[RingProgram::SPIN] == Freedom::speed;
    to_.stated = {true,
                  load_,
                  azimuth_,
                  axial_,
                  {moment(0), moment(1)},
                  p.unbalance.moment,
                  turns ? to_.value[RingProgram::SPIN].constant_value() : NAN};
  }
  if (!free_loaded_) return;
  const auto loaded = [this](int which) { return !to_.value[which].is_zero(); };
  p.mode[0] = p.mode[1] = Freedom::free;
  if (loaded(RingProgram::FORCE + 2)) p.mode[2] = Freedom::free;
  if (loaded(RingProgram::MOMENT) || loaded(RingProgram::MOMENT + 1))
    p.mode[RingProgram::TILT] = p.mode[RingProgram::TILT + 1] = Freedom::free;
}

void RingWords::apply_housing()
{
  if (!springs_) return;
  RingProgram &p = to_.program;
  const double speed = written(2.0 * M_PI * housing_frequency_);
  for (int k = 0; k < 2; ++k) {
    p.mode[k] = Freedom::free;
    p.support[k].stiffness = written(housing_mass_ * (speed * speed));
    p.support[k].damping = written(2.0 * housing_damping_ * housing_mass_ * speed);
  }
  p.mass = housing_mass_;
  p.supported = true;
}

void RingWords::finish(const RingBody &usual)
{
  RingProgram &p = to_.program;
  apply_load();
  apply_housing();
  if (p.mass == 0.0) p.mass = usual.mass;
  if (p.inertia.axial == 0.0) p.inertia = usual.inertia;
  check();
}

void RingWords::check() const
{
  const RingProgram &p = to_.program;
  if (p.unbalance.moment > 0.0 && p.mode[RingProgram::SPIN] != Freedom::speed)
    args_.fail("unbalance needs 'spin speed W': the eccentric mass turns with an imposed spin");
  for (int dof = 0; dof < RingProgram::SPIN; ++dof)
    if ((p.support[dof].stiffness > 0.0 || p.support[dof].damping > 0.0) && !p.free(dof))
      args_.fail(std::string("'support ") + name_of(dof) + "' needs '" + name_of(dof) + " free'");
  if (!to_.holder.empty() && !p.supported) args_.fail("'to " + to_.holder + "' needs a support");
  for (int k : number_)
    if (p.free(k) && p.mass == 0.0) args_.fail(std::string(name_of(k)) + " free needs 'mass M'");
  for (int k = RingProgram::TILT; k < RingProgram::N_DOF; ++k)
    if (p.free(k) && p.inertia.axial == 0.0)
      args_.fail("a free tilt or spin needs 'inertia AXIAL TRANSVERSE'");
}

}    // namespace bearing
