// SPDX-License-Identifier: GPL-2.0-or-later
#include "ring_settings.h"

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

std::string RingWords::known() const
{
  return std::string("x, y, z, ") + name_of(RingProgram::TILT) + ", " +
         name_of(RingProgram::TILT + 1) +
         ", spin, mass, inertia, force, moment, rotating, unbalance, support, " +
         (each_ ? "to, " : "") + "ramp";
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

void RingWords::read_inertia()
{
  RingInertia &inertia = to_.program.inertia;
  inertia.axial = args_.positive("inertia about the axis (kg m^2)");
  inertia.transverse = args_.positive("inertia across the axis (kg m^2)");
  if (inertia.axial > 2.0 * inertia.transverse)
    args_.fail("inertia " + text(inertia.axial) + " " + text(inertia.transverse) +
               ": no body has more than twice as much about its axis as across it");
}

void RingWords::read_support()
{
  std::vector<std::string> names;
  for (int dof = 0; dof < RingProgram::SPIN; ++dof) names.push_back(name_of(dof));
  Support &on = to_.program.support[args_.choice("support", names)];
  on.stiffness = args_.within("stiffness of the support", 0.0, 1e15);
  on.damping = args_.within("damping of the support", 0.0, 1e12);
  if (on.stiffness == 0.0 && on.damping == 0.0)
    args_.fail("a support with neither stiffness nor damping");
  to_.program.supported = true;
}

bool RingWords::take()
{
  RingProgram &p = to_.program;
  if (take_freedom()) return true;
  if (args_.take("mass")) {
    p.mass = args_.positive("mass (kg)");
  } else if (args_.take("inertia")) {
    read_inertia();
  } else if (args_.take("force")) {
    read_vector(RingProgram::FORCE, "force (N)");
  } else if (args_.take("moment")) {
    read_vector(RingProgram::MOMENT, "moment (N m)");
  } else if (args_.take("rotating")) {
    p.turning.size = args_.number("rotating force (N)");
    p.turning.speed = args_.number("speed of the rotating force (rad/s)");
    p.turning.phase = args_.number("phase of the rotating force (rad)");
  } else if (args_.take("unbalance")) {
    p.unbalance.moment = args_.non_negative("unbalance (kg m)");
    p.unbalance.phase = args_.number("phase of the unbalance (rad)");
  } else if (args_.take("support")) {
    read_support();
  } else if (each_ && args_.take("to")) {
    to_.holder = args_.word("to");
  } else if (args_.take("ramp")) {
    p.ramp = args_.non_negative("ramp time (s)");
  } else {
    return false;
  }
  return true;
}

void RingWords::check() const
{
  const RingProgram &p = to_.program;
  if (p.unbalance.moment > 0.0 && p.mode[RingProgram::SPIN] != Freedom::speed)
    args_.fail("unbalance needs 'spin speed W': the mass off centre turns with an imposed spin");
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
