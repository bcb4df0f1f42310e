// SPDX-License-Identifier: GPL-2.0-or-later
// Temperatures of a bearing that jump from ball pass to ball pass (docs/heat). A pass gives mean
// losses, which change little while temperatures do; they are assumed to hold as long as no
// temperature moves by more than `change`. The contacts run at the temperatures predicted
// for the end of a jump; the jump is then made with losses that vary linearly from those at its
// start to those at its end. The error is therefore of second order in `change`, and the heat that
// is booked is the heat that was used.
#ifndef RACEWAY_HEAT_JUMPS_H
#define RACEWAY_HEAT_JUMPS_H

#include "heat_network.h"

namespace raceway {

// A ball pass: mean heat into each node (W), mean conductances of the contacts (W/K).
struct HeatPass {
  double heat[heat_nodes] = {}, inner = 0.0, outer = 0.0;
  double power() const { return heat[0] + heat[1] + heat[2] + heat[3]; }
};

struct HeatControl {
  double change = 2.0;       // K, largest of a node in a jump
  double error = 0.5;        // K, error allowed in a jump because losses change with temperature
  double until = 0.0;        // s, thermal time to cover; 0: until temperatures are steady
  double steady = 0.05;      // K, difference from the steady state
  double hottest = 200.0;    // C
  double share = 0.2;        // of the slowest time constant, the longest jump
  bool both_ends = true;     // false: use the losses at the start of a jump
};

enum class HeatEnd { none = 0, reached = 1, steady = 2, seizes = 3, hot = 4 };

// Doubles only, as in a restart file.
struct HeatState {
  double time = 0.0;              // s
  double at[heat_nodes] = {};     // C, at that time
  double law[heat_nodes] = {};    // C, predicted temperatures at which the contacts run
  double length = 0.0;            // s, of the jump that `law` predicts; 0: none
  HeatPass start;                 // at the start of that jump
  double jumps = 0.0;
  double booked = 0.0, carried = 0.0;    // J, from the losses, and to ambient
  double correction = 0.0;               // K, largest of the last jump: predicted minus corrected
  double slope = 0.0, gain = 0.0;        // W/K, of the losses; over the conductance of the whole
  double seen = 0.0;                     // ball passes
  // C and W, of an earlier pass far enough away for a slope
  double oil_before = 0.0, power_before = 0.0;
  double alarms = 0.0;    // slopes in a row with a gain above 1
  double alarm = 0.0;     // s, thermal time of the first of them
  double end = 0.0;       // a HeatEnd

  double oil() const { return oil_of(law); }
  // C, of the oil in the contacts: that of the surfaces it wets
  static double oil_of(const double *t) { return (t[0] + t[1] + t[2]) / 3.0; }
};

// J, stored in excess of that at `from`
inline double stored_heat(const HeatNetwork &net, const double *from, const double *to)
{
  double sum = 0.0;
  for (int i = 0; i < net.nodes(); ++i) sum += net.capacity[i] * (to[i] - from[i]);
  return sum;
}

// Takes the ball pass that ran at `s.law` and begins the next jump. `net` is without its contacts.
inline void heat_jump(HeatState &s, const HeatPass &seen, HeatNetwork net, const HeatControl &c)
{
  constexpr double lasting = 0.5;    // of the slowest time constant
  // number of slopes with a gain above 1 that rules out chance
  constexpr int in_a_row = 3;
  constexpr double least_rise = 2.0;    // K, above which a slope exceeds the scatter of ball passes
  if (s.length > 0.0) {                 // complete the jump whose end has just been computed
    const HeatPass &end = c.both_ends ? seen : s.start;
    net.inner = 0.5 * (s.start.inner + end.inner);
    net.outer = 0.5 * (s.start.outer + end.outer);
    double to[heat_nodes];
    s.carried += HeatFlow(net, s.start.heat, end.heat, s.length).advance(s.at, s.length, to);
    s.booked += 0.5 * (s.start.power() + end.power()) * s.length;
    s.time += s.length;
    s.jumps += 1.0;
    s.correction = 0.0;
    for (int i = 0; i < heat_nodes; ++i) {
      s.correction = std::max(s.correction, std::fabs(to[i] - s.law[i]));
      s.at[i] = to[i];
    }
  }
  net.inner = seen.inner;
  net.outer = seen.outer;
  const HeatFlow flow(net, seen.heat);
  double last[heat_nodes];
  flow.steady(last);
  const double ran = s.oil(), rise = ran - s.oil_before, power = seen.power();
  const bool first = s.seen == 0.0, known = !first && std::fabs(rise) >= least_rise;
  if (known) s.slope = (power - s.power_before) / rise;
  s.gain = power > 0.0 ? s.slope * (HeatState::oil_of(last) - net.ambient) / power : 0.0;
  if (known) s.alarms = s.gain >= 1.0 && rise > 0.0 ? s.alarms + 1.0 : 0.0;
  if (s.alarms <= 1.0) s.alarm = s.time;
  if (known || first) {
    s.oil_before = ran;
    s.power_before = power;
  }
  s.seen += 1.0;
  double left = 0.0;    // K, difference from the steady state, with losses that change
  for (int i = 0; i < net.nodes(); ++i) left = std::max(left, std::fabs(last[i] - s.at[i]));
  if (s.gain > 0.0) left = s.gain < 1.0 ? left / (1.0 - s.gain) : HUGE_VAL;
  HeatEnd end = HeatEnd::none;
  // light parts that lead cause a gain above 1 for a while: it must last longer than that
  if (s.alarms >= in_a_row && s.time - s.alarm >= lasting * flow.slowest()) end = HeatEnd::seizes;
  else if (!(*std::max_element(s.at, s.at + net.nodes()) < c.hottest))
    end = s.gain >= 1.0 ? HeatEnd::seizes : HeatEnd::hot;
  else if (c.until > 0.0 && s.time >= c.until * (1.0 - 1e-12)) end = HeatEnd::reached;
  else if (c.until == 0.0 && left <= c.steady) end = HeatEnd::steady;
  s.end = static_cast<double>(end);
  s.start = seen;
  s.length = 0.0;
  for (int i = 0; i < heat_nodes; ++i) s.law[i] = s.at[i];
  if (end != HeatEnd::none) return;
  // a first-order jump of a change dT has an error of at most |P'| dT/(G - P'); using both ends
  // halves it
  double change = c.change;
  if (s.gain >= 1.0) change = 0.0;
  else if (s.gain != 0.0)
    change =
        std::min(change, (c.both_ends ? 2.0 : 1.0) * c.error * (1.0 - s.gain) / std::fabs(s.gain));
  change = std::max(change, 0.1 * c.change);
  double most = c.share * flow.slowest();
  if (c.until > 0.0) most = std::min(most, c.until - s.time);
  s.length = flow.time_of_change(s.at, change, most);
  // light parts follow the losses at the end of the jump, so these are predicted by the slope
  flow.advance(s.at, s.length, s.law);
  if (!c.both_ends || !(power > 0.0) || !(std::fabs(s.gain) < 1.0)) return;
  for (int k = 0; k < 4; ++k) {
    const double grown = 1.0 + s.slope * (s.oil() - ran) / power;
    double end_heat[heat_nodes];
    for (int i = 0; i < heat_nodes; ++i) end_heat[i] = grown * seen.heat[i];
    HeatFlow(net, seen.heat, end_heat, s.length).advance(s.at, s.length, s.law);
  }
}

}    // namespace raceway

#endif
