// SPDX-License-Identifier: GPL-2.0-or-later
#include "raceway_options.h"

using namespace raceway;

namespace bearing {

std::string raceway_keywords(bool with_film)
{
  std::string s = "young, poisson, ellipse, hysteresis, friction, tangential";
  if (with_film) s += ", lubricant, film, roughness, floor, damper, regimes";
  return s;
}

static bool read_film_keyword(Arguments &args, RacewayPhysics &p)
{
  if (args.take("lubricant")) {
    p.model.lubricant.viscosity = args.positive("viscosity (Pa s)");
    p.model.lubricant.pressure_viscosity = args.positive("pressure-viscosity coefficient (1/Pa)");
  } else if (args.take("film")) {
    const FilmModel models[] = {FilmModel::masjedi_khonsari, FilmModel::masjedi_khonsari_printed,
                                FilmModel::hamrock_dowson};
    p.model.film = models[args.choice("film", {"masjedi", "masjedi/printed", "hamrock"})];
  } else if (args.take("roughness")) {
    p.ring_roughness = args.positive("roughness of the raceway (m)");
    p.ball_roughness = args.non_negative("roughness of the ball (m)");
  } else if (args.take("floor")) {
    p.film_floor = args.positive("film floor of the damper (m)");
  } else if (args.take("damper")) {
    p.model.damper_full_axis = args.choice("damper length", {"a", "2a"}) == 1;
    p.model.damper_rolling_radius = args.choice("damper radius", {"Rb", "Rx"}) == 1;
  } else if (args.take("regimes")) {
    p.curve.lambda_1 = args.positive("film parameter at the end of the boundary regime");
    p.curve.lambda_2 = args.positive("film parameter at the start of the full film");
    if (p.curve.lambda_2 <= p.curve.lambda_1)
      args.fail("regimes " + text(p.curve.lambda_1) + " " + text(p.curve.lambda_2) +
                ": the second must be larger");
  } else {
    return false;
  }
  return true;
}

bool read_raceway_keyword(Arguments &args, bool with_film, RacewayPhysics &p)
{
  if (args.take("young")) {
    p.material.ball_young = args.positive("Young's modulus of the ball (Pa)");
    p.material.ring_young = args.positive("Young's modulus of the ring (Pa)");
  } else if (args.take("poisson")) {
    p.material.ball_poisson = args.within("Poisson's ratio of the ball", 0.0, 0.5);
    p.material.ring_poisson = args.within("Poisson's ratio of the ring", 0.0, 0.5);
  } else if (args.take("ellipse")) {
    const Ellipse forms[] = {Ellipse::exact, Ellipse::hamrock, Ellipse::printed};
    p.model.ellipse = forms[args.choice("ellipse", {"exact", "hamrock", "printed"})];
  } else if (args.take("hysteresis")) {
    p.hysteresis = args.non_negative("hysteretic damping alpha_e (s/m)");
  } else if (args.take("friction")) {
    if (args.take("none")) {
      p.friction = Friction::none;
    } else if (args.take("constant")) {
      p.friction = Friction::constant;
      p.mu = args.within("friction coefficient", 0.0, 2.0);
    } else if (with_film && args.take("stribeck")) {
      p.friction = Friction::stribeck;
      p.curve.mu_boundary = args.within("boundary friction coefficient", 0.0, 2.0);
      p.curve.mu_full = args.within("full-film friction coefficient", 0.0, 2.0);
    } else {
      args.fail("friction '" + args.word("friction law") + "', must be one of: none, constant MU" +
                (with_film ? ", stribeck MU_BOUNDARY MU_FULL"
                           : " (stribeck needs pair_style bearing/ehd)"));
    }
    if (args.take("smoothed")) p.creep = args.within("creep of the smoothed friction", 1e-6, 1.0);
  } else if (args.take("tangential")) {
    p.tangential_ratio = args.positive("tangential over normal stiffness");
    p.tangential_zeta = args.within("tangential damping over critical", 0.0, 2.0);
  } else {
    return with_film && read_film_keyword(args, p);
  }
  return true;
}

}    // namespace bearing
