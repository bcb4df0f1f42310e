// SPDX-License-Identifier: GPL-2.0-or-later
// Heat flow between the parts of a bearing (inner ring, balls, outer ring, housing and ambient) as
// a linear network, which is integrated exactly by its matrix exponential (docs/heat).
//
//   ambient -shaft- inner ring -inner- balls -outer- outer ring -seat- housing -housing- ambient
//
// If the housing is not a node (capacity 0), the outer ring is cooled through the seat and the
// housing in series. Flowing oil connects the inner ring, the balls and the outer ring with one
// another and with the oil inlet. The heat capacity of the oil inside the bearing is neglected.
#pragma once

#include "../numbers/exp_log.h"
#include "oil_flow.h"

#include <algorithm>
#include <cmath>

namespace raceway {

constexpr int heat_nodes = 4;                  // inner ring, balls, outer ring, housing
constexpr int heat_inputs = heat_nodes + 1;    // W, into the nodes and into the flowing oil

// Losses (W) of a bearing by the place where they arise.
struct PlacedLosses {
  double inner = 0.0, outer = 0.0;    // in contacts with the inner and the outer ring
  double balls = 0.0;                 // in contacts of the balls with the cage
  double drag = 0.0;                  // of the balls in the oil
};

// Adds the heat flows due to losses to `heat`, of which there are `heat_inputs`. The fraction
// `share` of the loss in a contact enters the ball. The drag heats the oil; if the oil does not
// flow, it transfers this heat to the surfaces that it wets. In a 6208, 40 % of them are those of
// the balls, 24 % those of the inner and 36 % those of the outer ring.
inline void add_losses(double *heat, const PlacedLosses &of, double share, bool flows)
{
  const double still = flows ? 0.0 : of.drag;
  heat[0] += (1.0 - share) * of.inner + 0.25 * still;
  heat[1] += share * (of.inner + of.outer) + of.balls + 0.5 * still;
  heat[2] += (1.0 - share) * of.outer + 0.25 * still;
  heat[heat_nodes] += of.drag - still;
}

struct HeatNetwork {
  double capacity[heat_nodes] = {};    // J/K; housing: 0 if there is none
  double inner = 0.0, outer = 0.0;     // W/K, conductance from each ring to all balls together
  double shaft = 0.0;                  // W/K, from the inner ring to ambient
  double seat = 0.0;                   // W/K, from the outer ring to the housing; 0: no thermal
                                       // resistance
  double housing = 0.0;                // W/K, from the housing to ambient
  double ambient = 0.0;                // C
  OilFlow oil;

  int nodes() const { return capacity[3] > 0.0 ? 4 : 3; }
  // Returns true if heat can flow from every node to ambient. A ring that no ball touches has no
  // path through the balls.
  bool connected() const
  {
    const bool out = cooling() > 0.0;
    return oil.flows() || (out && outer > 0.0 && (inner > 0.0 || shaft > 0.0)) ||
           (out && inner > 0.0 && shaft > 0.0);
  }
  // Returns the steady-state conductance from the outer ring to ambient, W/K.
  double cooling() const
  {
    return seat > 0.0 && housing > 0.0 ? seat * housing / (seat + housing) : housing;
  }
};

// The network in modal coordinates. Its inputs are `heat_inputs` heat flows (W), which are constant
// or vary linearly to `end` within `over` seconds.
class HeatFlow {
 public:
  HeatFlow(const HeatNetwork &of, const double *heat, const double *end, double over) :
      HeatFlow(of, heat)
  {
    const HeatFlow then(of, end);
    for (int m = 0; m < n_; ++m) growth_[m] = (then.steady_[m] - steady_[m]) / over;
    to_outlet_ = 0.5 * (to_outlet_ + then.to_outlet_);
  }
  HeatFlow(const HeatNetwork &of, const double *heat) : net_(of), n_(of.nodes())
  {
    double to_ambient[heat_nodes] = {of.shaft, 0.0, 0.0, 0.0}, g[heat_nodes][heat_nodes] = {};
    double from_oil[heat_nodes] = {};    // W
    const auto link = [&g](int i, int j, double conductance) {
      g[i][i] += conductance;
      g[j][j] += conductance;
      g[i][j] -= conductance;
      g[j][i] -= conductance;
    };
    link(0, 1, of.inner);
    link(1, 2, of.outer);
    if (n_ == 4) {
      link(2, 3, of.seat);
      to_ambient[3] = of.housing;
    } else {
      to_ambient[2] = of.cooling();
    }
    if (of.oil.flows()) {    // the oil is eliminated, which leaves links between the surfaces and
                             // from the surfaces to the inlet
      const OilFlow &oil = of.oil;
      for (int i = 0; i < OilFlow::surfaces; ++i) {
        const double share = oil.conductance(i) / oil.total(), to_inlet = share * oil.flow;
        for (int j = 0; j < i; ++j) link(j, i, share * oil.conductance(j));
        to_ambient[i] += to_inlet;
        from_oil[i] = share * heat[heat_nodes] + to_inlet * (oil.inlet - of.ambient);
        to_outlet_ -= to_inlet * (oil.inlet - of.ambient);
      }
      to_outlet_ += oil.flow / oil.total() * heat[heat_nodes];
    }
    double into[heat_nodes] = {};
    for (int i = 0; i < n_; ++i) {
      root_[i] = std::sqrt(of.capacity[i]);
      to_ambient_[i] = to_ambient[i];
      g[i][i] += to_ambient[i];
      into[i] = heat[i] + from_oil[i];
    }
    if (n_ == 3) into[2] += heat[3];    // the heat that enters a housing without capacity
    find_steady(g, into);
    for (int i = 0; i < n_; ++i)
      for (int j = 0; j < n_; ++j) g[i][j] /= root_[i] * root_[j];
    find_modes(g);
    for (int m = 0; m < n_; ++m)
      for (int i = 0; i < n_; ++i) steady_[m] += mode_[m][i] * root_[i] * steady_rise_[i];
  }

  // Returns the time constant of the slowest mode, s.
  double slowest() const { return 1.0 / *std::min_element(rate_, rate_ + n_); }

  // Computes the temperatures (C) `time` seconds after `from`; returns the heat (J) released to
  // ambient and carried away by the oil.
  double advance(const double *from, double time, double *to) const
  {
    double now[heat_nodes], sum[heat_nodes];    // temperature rises above ambient times root_; time
                                                // integrals
    double rise[heat_nodes] = {}, spent[heat_nodes] = {};
    for (int m = 0; m < n_; ++m) {
      double begin = 0.0;
      for (int i = 0; i < n_; ++i) begin += mode_[m][i] * root_[i] * (from[i] - net_.ambient);
      const double decay = exponential(-rate_[m] * time), lag = growth_[m] / rate_[m],
                   away = begin - steady_[m] + lag;
      now[m] = steady_[m] + growth_[m] * time - lag + away * decay;
      sum[m] =
          (steady_[m] + 0.5 * growth_[m] * time - lag) * time + away * (1.0 - decay) / rate_[m];
    }
    for (int i = 0; i < n_; ++i)
      for (int m = 0; m < n_; ++m) {
        rise[i] += mode_[m][i] * now[m] / root_[i];
        spent[i] += mode_[m][i] * sum[m] / root_[i];
      }
    double carried = to_outlet_ * time;
    for (int i = 0; i < n_; ++i) {
      to[i] = net_.ambient + rise[i];
      carried += to_ambient_[i] * spent[i];
    }
    if (n_ == 3) to[3] = housing_of(to[2]);
    return carried;
  }

  // Computes the steady-state temperatures (C).
  void steady(double *to) const
  {
    for (int i = 0; i < n_; ++i) to[i] = net_.ambient + steady_rise_[i];
    if (n_ == 3) to[3] = housing_of(to[2]);
  }

  // Returns the longest time (s), up to `most`, during which no temperature changes by more than
  // `change` (K).
  double time_of_change(const double *from, double change, double most) const
  {
    const auto fits = [&](double time) {
      double to[heat_nodes];
      advance(from, time, to);
      for (int i = 0; i < n_; ++i)
        if (!(std::fabs(to[i] - from[i]) <= change)) return false;
      return true;
    };
    if (fits(most)) return most;
    double low = 0.0, high = most;
    for (int k = 0; k < 50; ++k) {
      const double middle = 0.5 * (low + high);
      (fits(middle) ? low : high) = middle;
    }
    return low;
  }

 private:
  double housing_of(double outer_ring) const
  {
    if (!(net_.seat > 0.0)) return outer_ring;
    return net_.ambient + (outer_ring - net_.ambient) * net_.seat / (net_.seat + net_.housing);
  }

  // Computes the equilibrium temperature rises above ambient for the conductances `g`. The
  // elimination stores the conductance of each part to ambient separately from the links between
  // parts, so it never subtracts nearly equal numbers (Grassmann, Taksar, Heyman, Oper. Res. 33,
  // 1985).
  void find_steady(const double g[heat_nodes][heat_nodes], const double *heat)
  {
    double link[heat_nodes][heat_nodes] = {}, out[heat_nodes], drive[heat_nodes], own[heat_nodes];
    for (int i = 0; i < n_; ++i) {
      for (int j = 0; j < n_; ++j)
        if (i != j) link[i][j] = -g[i][j];
      out[i] = to_ambient_[i];    // conductance to ambient, including the paths through the parts
                                  // already eliminated
      drive[i] = heat[i];
    }
    for (int k = 0; k < n_; ++k) {
      own[k] = out[k];
      for (int j = k + 1; j < n_; ++j) own[k] += link[k][j];
      for (int i = k + 1; i < n_; ++i) {
        const double share = link[i][k] / own[k];
        out[i] += share * out[k];
        drive[i] += share * drive[k];
        for (int j = k + 1; j < n_; ++j)
          if (i != j) link[i][j] += share * link[k][j];
      }
    }
    for (int k = n_ - 1; k >= 0; --k) {
      double sum = drive[k];
      for (int j = k + 1; j < n_; ++j) sum += link[k][j] * steady_rise_[j];
      steady_rise_[k] = sum / own[k];
    }
  }

  // Computes eigenvalues and eigenvectors of a symmetric matrix by Jacobi rotations.
  void find_modes(double a[heat_nodes][heat_nodes])
  {
    double v[heat_nodes][heat_nodes] = {};
    for (int i = 0; i < n_; ++i) v[i][i] = 1.0;
    for (int sweep = 0; sweep < 30; ++sweep)
      for (int p = 0; p < n_; ++p)
        for (int q = p + 1; q < n_; ++q) {
          if (a[p][q] == 0.0) continue;
          const double theta = 0.5 * (a[q][q] - a[p][p]) / a[p][q],
                       t = (theta < 0.0 ? -1.0 : 1.0) /
                           (std::fabs(theta) + std::sqrt(theta * theta + 1.0)),
                       c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
          if (!std::isfinite(t)) continue;
          for (int k = 0; k < n_; ++k) {
            const double x = a[k][p], y = a[k][q];
            a[k][p] = c * x - s * y;
            a[k][q] = s * x + c * y;
          }
          for (int k = 0; k < n_; ++k) {
            const double x = a[p][k], y = a[q][k];
            a[p][k] = c * x - s * y;
            a[q][k] = s * x + c * y;
          }
          a[p][q] = a[q][p] = 0.0;
          for (int k = 0; k < n_; ++k) {
            const double x = v[k][p], y = v[k][q];
            v[k][p] = c * x - s * y;
            v[k][q] = s * x + c * y;
          }
        }
    for (int m = 0; m < n_; ++m) {
      rate_[m] = a[m][m];
      for (int i = 0; i < n_; ++i) mode_[m][i] = v[i][m];
    }
  }

  HeatNetwork net_;
  int n_;
  double root_[heat_nodes] = {}, to_ambient_[heat_nodes] = {};    // square roots of the capacities;
                                                                  // W/K
  // W, heat carried away by the oil, excluding the part that is proportional to the temperature
  // rises above ambient
  double to_outlet_ = 0.0;
  double rate_[heat_nodes] = {}, steady_[heat_nodes] = {};    // for each mode
  double growth_[heat_nodes] = {};                            // growth of steady_ for each mode,
                                                              // 1/s
  double steady_rise_[heat_nodes] = {};                       // K, above ambient
  double mode_[heat_nodes][heat_nodes] = {};
};

}    // namespace raceway
