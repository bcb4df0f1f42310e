// SPDX-License-Identifier: GPL-2.0-or-later
#include "cage_settings.h"

using raceway::CageRing;
using raceway::Freedom;
using raceway::RingProgram;

namespace bearing {

void CageSettings::read_guide(Arguments &args)
{
  of.guide = static_cast<CageRing::Guide>(args.choice("guide", {"balls", "inner", "outer"}));
  if (of.guide == CageRing::by_balls) return;
  of.land.radius = args.positive("radius of the guiding land (m)");
  of.land.clearance = args.positive("radial clearance of the cage on its land (m)");
  of.land.width = args.positive("width of a land (m)");
  of.land.lands = args.integer("number of lands", 1, 2);
}

void CageSettings::read(Arguments &args)
{
  while (args.more()) {
    if (args.integer("pockets", of.pockets, "number of pockets", 1, 100000) ||
        args.non_negative("play", play, "play along the pitch circle (m)") ||
        args.non_negative("across", across, "play along the axis (m)") ||
        args.number("phase", of.phase, "azimuth of the first pocket (rad)") ||
        args.positive("mass", of.mass, "mass (kg)") ||
        args.positive("wall", of.wall, "stiffness of the walls of a pocket (N/m)") ||
        args.within("friction", of.friction, "friction of ball and cage", 0.0, 1.0) ||
        args.non_negative("film", film_height, "height of a pocket's squeeze film (m)") ||
        args.within("land_oil", land_filled, "share of the land's gap with oil", 0.0, 1.0) ||
        args.yes("planar", planar))
      continue;
    if (args.take("shape")) {
      shape = args.choice("shape", {"cylinder", "sphere"});
    } else if (args.take("inertia")) {
      program.inertia = read_inertia(args);
    } else if (args.within("young", young[0], "Young's modulus of the balls (Pa)",
                           raceway::LEAST_YOUNG, raceway::LARGEST_YOUNG)) {
      young[1] = args.within("Young's modulus of the cage (Pa)", raceway::LEAST_YOUNG,
                             raceway::LARGEST_YOUNG);
    } else if (args.within("poisson", poisson[0], "Poisson's ratio of the balls", 0.0, 0.5)) {
      poisson[1] = args.within("Poisson's ratio of the cage", 0.0, 0.5);
    } else if (args.take("guide")) {
      read_guide(args);
    } else if (args.positive("oil", oil, "viscosity in pockets and at the land (Pa s)")) {
      filled = args.within("share of the gaps with oil", 0.0, 1.0);
      height = args.non_negative("height of a pocket's band of oil (m)");
    } else if (args.within("churning", of.oil_share, "share of oil around the cage", 0.0, 1.0)) {
      of.oil_density = args.positive("density of the oil (kg/m^3)");
      of.oil_viscosity = args.positive("viscosity of the oil (Pa s)");
      of.outer_radius = args.positive("outer radius of the cage (m)");
    } else {
      args.unknown();
    }
  }
  finish(args);
}

void CageSettings::finish(const Arguments &args)
{
  if (of.pockets == 0) args.fail("'pockets Z' is missing");
  if (play < 0.0) args.fail("'play J' is missing");
  if (of.mass == 0.0 || program.inertia.axial == 0.0)
    args.fail("'mass M' or 'inertia AXIAL TRANSVERSE' is missing");
  const bool guided = of.guide != CageRing::by_balls;
  if (guided && of.land.clearance > 0.1 * of.land.radius)
    args.fail("the clearance of the cage on its land, " + text(of.land.clearance) +
              " m, must be at most a tenth of the land's radius, " + text(of.land.radius) + " m");
  // balls can hold a cage radially only if its pockets wrap around them
  of.spherical = shape < 0 ? !guided : shape == 1;
  of.along = 0.5 * play;
  of.across = across < 0.0 ? of.along : 0.5 * across;
  if (height > 0.0 && of.along == 0.0)
    args.fail("oil in a pocket is sheared in the play, which is 0: specify 'play' or height 0");
  of.land.viscosity = oil;
  of.land.filled = land_filled < 0.0 ? filled : land_filled;
  program.mass = of.mass;
  find_freedoms();
}

void CageSettings::find_freedoms()
{
  for (int dof = 0; dof < RingProgram::N_DOF; ++dof)
    program.mode[dof] =
        planar && (dof == 2 || dof == RingProgram::TILT || dof == RingProgram::TILT + 1)
            ? Freedom::fixed
            : Freedom::free;
}

void CageSettings::prepare(Arguments &args, double ball_radius, double pitch)
{
  const double R = ball_radius, bore = 2.0 * (R + of.along),
               room = 2.0 * pitch * std::sin(3.14159265358979323846 / of.pockets);
  if (of.pockets > 1 && bore >= room)
    args.fail("play " + text(2.0 * of.along) + " m: a pocket is " + text(bore) +
              " m long, but the pitch circle of radius " + text(pitch) + " m has only " +
              text(room) + " m for each of " + std::to_string(of.pockets));
  const bool inner = of.guide == CageRing::by_inner;
  if (of.guide != CageRing::by_balls && (inner ? of.land.radius >= pitch : of.land.radius <= pitch))
    args.fail("the land is on the wrong side: 'guide " + std::string(inner ? "inner" : "outer") +
              "' with radius " + text(of.land.radius) + " m, but the pitch circle has " +
              text(pitch) + " m");
  const double E = raceway::reduced_modulus(young[0], poisson[0], young[1], poisson[1]);
  of.pitch = pitch;
  of.stiffness = raceway::pocket_stiffness(of.spherical, R, std::fmin(of.along, of.across), E);
  if (of.guide != CageRing::by_balls) of.land_stiffness = raceway::land_stiffness(of.land, E);
  const double H = film_height < 0.0 ? height : film_height;
  if (H > 0.0) of.film = {R, of.least_play(R), H, oil * filled, of.spherical};
  of.shear = height > 0.0 ? raceway::pocket_shear(oil, R, height, of.along, filled) : 0.0;
}

}    // namespace bearing
