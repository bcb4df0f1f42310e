// SPDX-License-Identifier: GPL-2.0-or-later
#include "profile_settings.h"

#include <algorithm>
#include <cmath>
#include <sstream>

using raceway::BallPitShape;
using raceway::NotchShape;
using raceway::PeriodicCurve;
using raceway::Wave;

namespace bearing {

namespace {

constexpr int most_points = 1000000;    // per table

BallPitShape read_pit(Arguments &args)
{
  BallPitShape n;
  n.azimuth = args.within("azimuth of the pit (rad)", -7.0, 7.0);
  n.latitude = args.within("latitude of the pit (rad)", -1.5, 1.5);
  n.length = args.within("length of the pit (m)", 1e-6, 1.0);
  n.width = args.within("width of the pit (m)", 1e-6, 1.0);
  n.depth = args.within("depth of the pit (m)", 1e-9, 1.0);
  n.edge = args.within("edge of the pit (m)", 1e-7, 1e-2);
  return n;
}

NotchShape read_notch(Arguments &args)
{
  NotchShape n;
  n.azimuth = args.within("azimuth of the notch (rad)", -7.0, 7.0);
  n.length = args.within("length of the notch (m)", 1e-6, 1.0);
  n.width = args.take("full") ? HUGE_VAL : args.within("width of the notch (m)", 1e-6, 1.0);
  n.depth = args.within("depth of the notch (m)", 1e-9, 1.0);
  n.edge = args.within("edge of the notch (m)", 1e-7, 1e-2);
  return n;
}

Wave read_wave(Arguments &args)
{
  Wave w;
  w.order = args.integer("order of the wave", 1, 10000);
  w.amplitude = args.within("amplitude of the wave (m)", 0.0, 1e-2);
  w.phase = args.number("phase of the wave (rad)");
  return w;
}

// Reads lines of the form "azimuth depth" (rad, m), which must be evenly spaced over one turn. #
// starts a comment.
PeriodicCurve read_table(Arguments &args)
{
  const std::string name = args.word("file");
  const std::optional<std::string> content = args.content(name);
  if (!content) args.fail("cannot read '" + name + "'");
  std::vector<double> azimuth, depth;
  std::istringstream lines(*content);
  std::string line;
  for (int n = 1; std::getline(lines, line); ++n) {
    std::istringstream words(line.substr(0, line.find('#')));
    const std::string where = "'" + name + "' line " + std::to_string(n);
    double a, d;
    std::string rest;
    if (!(words >> a)) {
      words.clear();
      if (words >> rest) args.fail(where + ": '" + rest + "' is not an azimuth (rad)");
      continue;
    }
    if (!(words >> d) || words >> rest || !(std::fabs(d) <= 1e-2))
      args.fail(where + ": needs an azimuth (rad) and a depth (m) within -0.01 and 0.01");
    azimuth.push_back(a);
    depth.push_back(d);
  }
  const int n = static_cast<int>(depth.size());
  if (n < 8 || n > most_points)
    args.fail("'" + name + "' has " + std::to_string(n) + " points, must have 8 to " +
              std::to_string(most_points));
  for (int k = 0; k < n; ++k)
    if (!(std::fabs(azimuth[k] - azimuth[0] - 2.0 * M_PI * k / n) < 0.01 * 2.0 * M_PI / n))
      args.fail("'" + name + "' point " + std::to_string(k + 1) + " is at " + text(azimuth[k]) +
                " rad, must be at " + text(azimuth[0] + 2.0 * M_PI * k / n) +
                ": the points must be evenly spaced over one turn");
  return PeriodicCurve(azimuth[0], depth);
}

void read_raceway(Arguments &args, int most_grooves, ProfileSettings &s)
{
  while (args.more()) {
    if (args.take("groove")) s.groove = args.integer("groove", 0, most_grooves - 1);
    else if (args.take("notch")) s.raceway.notches.push_back(read_notch(args));
    else if (args.take("wave")) s.raceway.waves.push_back(read_wave(args));
    else if (args.take("file")) s.raceway.tables.push_back(read_table(args));
    else args.unknown("groove, notch, wave, file, none, or 'ball' first");
  }
  if (!s.departs()) args.fail("a profile needs 'notch', 'wave', 'file' or 'none'");
}

void read_ball(Arguments &args, ProfileSettings &s)
{
  while (args.more()) {
    if (args.take("pit")) s.ball.pits.push_back(read_pit(args));
    else if (args.take("wave")) s.ball.waves.push_back(read_wave(args));
    else if (args.take("file")) s.ball.tables.push_back(read_table(args));
    else if (args.next() == "flawed_ball") args.skip_rest();
    else args.unknown("pit, wave, file, none, flawed_ball");
  }
  if (!s.departs()) args.fail("a profile of balls needs 'pit', 'wave', 'file' or 'none'");
}

}    // namespace

// Among the deck variables, flaw_inner and flaw_outer specify profiles of raceways, and flaw_ball
// specifies a profile of balls, by default of the first ball. The last keyword, flawed_ball,
// specifies the numbers of these balls.
ProfileSettings ProfileSettings::read(Arguments &args, int most_grooves,
                                      std::vector<std::string> &said)
{
  ProfileSettings s;
  if (args.more() && args.next() == "flawed_ball") args.skip_rest();    // the balls have no flaw
  if (!args.more()) return s;
  const bool of_variable = args.take("flaw_ball");
  if (of_variable) s.flawed = {"1"};
  s.of_balls = of_variable || args.take("ball");
  if (!s.of_balls && !args.take("flaw_inner")) args.take("flaw_outer");
  said = args.rest();
  const auto at = std::find(said.begin(), said.end(), "flawed_ball");
  if (at != said.end()) {
    s.flawed.assign(at + 1, said.end());
    if (s.flawed.empty()) args.fail("'flawed_ball' without the number of a ball");
    said.erase(at, said.end());
  }
  if (s.of_balls) said.insert(said.begin(), "ball");
  if (args.take("none")) {
    if (args.more() && args.next() == "flawed_ball") args.skip_rest();
    if (args.more()) args.fail("'none' stands alone: no flaws");
  } else if (s.of_balls) {
    read_ball(args, s);
  } else {
    read_raceway(args, most_grooves, s);
  }
  return s;
}

}    // namespace bearing
