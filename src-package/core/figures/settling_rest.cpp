// SPDX-License-Identifier: GPL-2.0-or-later
#include "settling_rest.h"

namespace bearing {

using raceway::Vec3;
using Series = std::vector<Vec3>;    // values of a quantity, one per ball pass; a scalar uses one
                                     // component

static double length(const Vec3 &v) { return std::sqrt(dot(v, v)); }

// Returns, in order, up to three steps between the means over the last spans.
static Series steps_of(const Series &passes, size_t span)
{
  const size_t spans = std::min<size_t>(4, passes.size() / span);
  Series means(spans), steps;
  for (size_t k = 0; k < spans; ++k) {
    const auto from = passes.end() - static_cast<std::ptrdiff_t>((spans - k) * span);
    for (size_t i = 0; i < span; ++i) means[k] += from[static_cast<std::ptrdiff_t>(i)];
    means[k] = means[k] * (1.0 / static_cast<double>(span));
    if (k > 0) steps.push_back(means[k] - means[k - 1]);
  }
  return steps;
}

static Vec3 mean_of(const Series &steps)
{
  Vec3 sum;
  for (const Vec3 &s : steps) sum += s;
  return sum * (1.0 / static_cast<double>(steps.size()));
}

// Returns true if the scatter of the steps is at least as large as their mean.
static bool scatters(const Series &steps)
{
  const Vec3 mean = mean_of(steps);
  double squares = 0.0;
  for (const Vec3 &s : steps) squares += dot(s - mean, s - mean);
  return steps.size() > 2 && squares / (static_cast<double>(steps.size()) - 1.0) >= dot(mean, mean);
}

// Returns the change per span for the case without drift: the mean step, but at least a third of
// the last step.
static double change(const Series &steps)
{
  return std::max(length(mean_of(steps)), length(steps.back()) / static_cast<double>(steps.size()));
}

// Returns the remaining change due to a drift, or 0 if there is no drift.
static double rest_of_drift(const Series &steps, size_t span, double slowest)
{
  double products = 0.0, squares = 0.0;
  for (size_t k = 1; k < steps.size(); ++k) {
    products += dot(steps[k], steps[k - 1]);
    squares += dot(steps[k - 1], steps[k - 1]);
  }
  if (!(products > 0.0) || scatters(steps)) return 0.0;
  const double ratio = std::min(products / squares, std::pow(slowest, static_cast<double>(span)));
  // a drift is assumed not to end abruptly
  const double last = std::max(length(steps.back()), ratio * length(steps[steps.size() - 2]));
  return last * ratio / (1.0 - ratio);
}

static double rest_of(const Series &passes, double slowest)
{
  const size_t longest = std::max<size_t>(1, passes.size() / 4);
  const Series slow = steps_of(passes, longest);
  double rest =
      (scatters(slow) ? change(slow) : length(slow.back())) / static_cast<double>(longest);
  for (size_t span = 1; span <= longest; span *= 2)
    rest = std::max(rest, rest_of_drift(steps_of(passes, span), span, slowest));
  return rest;
}

// Returns the values of a quantity, which `number` takes from a ball pass.
template <class Number>
static Series series_of(const std::vector<SettlingSample> &passes, Number number)
{
  Series all;
  for (const SettlingSample &p : passes) all.push_back({number(p), 0.0, 0.0});
  return all;
}

static double relative(double change, double value)
{
  return change == 0.0 ? 0.0 : change / std::fabs(value);
}

static Series axes_of(const std::vector<SettlingSample> &passes)
{
  Series all;
  for (const SettlingSample &p : passes)
    all.push_back(p.weight > 0.0 ? Vec3::from(p.axis) * (1.0 / p.weight) : Vec3());
  return all;
}

// Returns the changes between the means over the last two of the longest spans.
static SettlingChanges latest_changes(const std::vector<SettlingSample> &passes)
{
  const size_t span = std::max<size_t>(1, passes.size() / 4);
  Settling settling(static_cast<int>(span));
  for (auto p = passes.end() - static_cast<std::ptrdiff_t>(2 * span); p != passes.end(); ++p)
    settling.add(*p);
  return settling.changes();
}

// Returns the changes that `change` finds in the series of each quantity except those of the cage.
template <class Change>
static SettlingChanges changes_of(const std::vector<SettlingSample> &passes, Change change)
{
  const auto share = [&](auto number) {
    return relative(change(series_of(passes, number)), number(passes.back()));
  };
  SettlingChanges c;
  c.torque = share([](const SettlingSample &p) { return p.torque; });
  c.load = std::max(share([](const SettlingSample &p) { return p.load[0]; }),
                    share([](const SettlingSample &p) { return p.load[1]; }));
  c.cage_speed = share([](const SettlingSample &p) { return p.cage_speed; });
  c.spin_axis = change(axes_of(passes));
  return c;
}

SettlingChanges settling_rest(const std::vector<SettlingSample> &passes, double slowest)
{
  if (passes.size() < 2) return {};
  SettlingChanges rest =
      changes_of(passes, [slowest](const Series &all) { return rest_of(all, slowest); });
  const SettlingChanges latest = latest_changes(passes);
  rest.pocket_fall = latest.pocket_fall;
  rest.cage_orbit = latest.cage_orbit;
  return rest;
}

// Returns the largest distance between two means over `window` values.
static double spread(const Series &all, size_t window)
{
  Series means;
  for (size_t first = 0; first + window <= all.size(); ++first)
    means.push_back(mean_of({all.begin() + static_cast<std::ptrdiff_t>(first),
                             all.begin() + static_cast<std::ptrdiff_t>(first + window)}));
  double most = 0.0;
  for (const Vec3 &a : means)
    for (const Vec3 &b : means) most = std::max(most, length(a - b));
  return most;
}

SettlingChanges settling_wander(const std::vector<SettlingSample> &passes, size_t window)
{
  const size_t half = passes.size() / 2;
  if (half < 2) return {};
  window = std::min(window, half - 1);
  const std::vector<SettlingSample> last(passes.end() - static_cast<std::ptrdiff_t>(half),
                                         passes.end());
  return changes_of(last, [window](const Series &all) { return spread(all, window); });
}

}    // namespace bearing
