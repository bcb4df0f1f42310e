// SPDX-License-Identifier: GPL-2.0-or-later
#include "bearing_figures.h"

#include "../contact/part_table.h"

#include <algorithm>

namespace bearing {

using raceway::as_whole;
using raceway::has_none;
using raceway::Needs;
using raceway::Side;

void BallFigures::contact(const ContactView &view)
{
  const raceway::ContactState &state = view.state;
  const int s = view.raceway.groove.side == Side::inner ? 0 : 1;
  contacts += 1.0;
  loaded[s] = 1.0;
  const bool top = s == 0 && !(state.load < load[0]);    // an inner ring may have two grooves
  load[s] = std::max(load[s], state.load);
  pressure[s] = std::max(pressure[s], view.raceway.law.at(state.cos_angle).p * state.root);
  h_min = std::min(h_min, state.h_min);
  lambda = std::min(lambda, state.lambda);
  const raceway::LossPowers powers = raceway::loss_powers(state);
  for (int k = 0; k < raceway::most_loss_columns; ++k) loss[k] += powers.of[k];
  capacitance[s] += view.capacitor.capacitance;
  gap(view);
  if (!top) return;
  entrainment = state.entrainment;
  asperity_share = state.asperity_share;
  film[0] = state.h_min;
  film[1] = state.lambda;
  film[2] = view.capacitor.h_c;
}

void BallFigures::gap(const ContactView &view)
{
  whole[view.raceway.groove.side == Side::inner ? 0 : 1] += view.capacitor.total();
}

void BallFigures::cage(double loss, double force)
{
  cage_loss += loss;
  if (!(force <= cage_force)) cage_force = force;
}

void BallFigures::take_pairs(const BallFigures &ball)
{
  std::copy(ball.loaded, ball.loaded + 2, loaded);
  std::copy(ball.capacitance, ball.capacitance + 2, capacitance);
  std::copy(ball.whole, ball.whole + 2, whole);
}

void BearingFigures::add(const BallFigures &b)
{
  balls += b.balls;
  contacts += b.contacts;
  loaded_balls += b.loaded[0] * b.loaded[1];
  if (b.load[0] > load[0]) {
    entrainment = b.entrainment;
    asperity_share = b.asperity_share;
    std::copy(b.film, b.film + 3, film);
  }
  for (int s = 0; s < 2; ++s) {
    load[s] = std::max(load[s], b.load[s]);
    pressure[s] = std::max(pressure[s], b.pressure[s]);
  }
  h_min = std::min(h_min, b.h_min);
  lambda = std::min(lambda, b.lambda);
  orbit += b.orbit;
  for (int k = 0; k < raceway::most_loss_columns; ++k) loss[k] += b.loss[k];
  cage_loss += b.cage_loss;
  if (!(b.cage_force <= cage_force)) cage_force = b.cage_force;    // the result is NaN if any value
                                                                   // is NaN
  const double series = raceway::series_capacitance(b.capacitance[0], b.capacitance[1]),
               surrounded = raceway::series_capacitance(b.whole[0], b.whole[1]);
  capacitance += series;
  capacitance_top = std::max(capacitance_top, series);
  whole += surrounded;
  whole_top = std::max(whole_top, surrounded);
}

namespace {

using F = const BearingFigures &;

double contacts(F f, int) { return f.contacts; }
double loaded_balls(F f, int) { return f.loaded_balls; }
double load_inner(F f, int) { return f.load[0]; }
double load_outer(F f, int) { return f.load[1]; }
double pressure(F f, int) { return std::max(f.pressure[0], f.pressure[1]); }
double cage_speed(F f, int) { return f.cage_speed(); }
double thinnest(F f, int) { return f.contacts > 0.0 ? f.h_min : 0.0; }
double smallest_lambda(F f, int) { return f.contacts > 0.0 ? f.lambda : 0.0; }

const Figure cage_force = {
    {"cage_force", "N", "largest force between a ball and the cage or between two balls"},
    [](F f, int) { return f.cage_force; },
    Needs::nothing,
    0,
    true};

// Returns the set of the parts that have the given property.
unsigned parts_with(bool raceway::LawFacts::*fact)
{
  unsigned parts = 0;
  for (size_t k = 0; k < raceway::part_table().size(); ++k)
    if (raceway::law_facts(1u << k).*fact) parts |= 1u << k;
  return parts;
}

// Adds the losses with the given value of `usual`. All of these losses are columns in every law
// with rolling friction; the loss of a part that is absent is 0.
void add_losses(std::vector<Figure> &list, bool usual)
{
  const unsigned couples = parts_with(&raceway::LawFacts::couples);
  const auto &table = raceway::loss_table();
  for (int k = 0; k < int(table.size()); ++k)
    if (table[k].is.usual == usual)
      list.push_back({{table[k].is.name, "W", table[k].is.meaning},
                      [](F f, int at) { return f.loss[at]; },
                      Needs::nothing,
                      usual ? 0 : couples | table[k].parts,
                      false,
                      k,
                      table[k].is.key});
  if (!usual)
    list.push_back({{"cage_power", "W", "power dissipated at the cage"},
                    [](F f, int) { return f.cage_loss; },
                    Needs::nothing,
                    couples,
                    true,
                    0,
                    "cage"});
}

void add(std::vector<Figure> &list, std::initializer_list<Figure> more)
{
  list.insert(list.end(), more);
}

std::vector<Figure> of_record()
{
  std::vector<Figure> list = {
      {{"contacts", "", "number of contacts between balls and raceways", has_none, as_whole},
       contacts},
      {{"loaded_balls", "", "number of balls in contact with both raceways", has_none, as_whole},
       loaded_balls},
      {{"load_inner", "N", "largest elastic contact load on the inner raceway"}, load_inner},
      {{"load_outer", "N", "largest elastic contact load on the outer raceway"}, load_outer},
      {{"pressure_inner", "Pa", "largest Hertz pressure on the inner raceway"},
       [](F f, int) { return f.pressure[0]; }},
      {{"pressure_outer", "Pa", "largest Hertz pressure on the outer raceway"},
       [](F f, int) { return f.pressure[1]; }},
      {{"h_min", "m", "smallest film thickness of all contacts"},
       [](F f, int) { return f.contacts > 0.0 ? f.h_min : NAN; },
       Needs::film},
      {{"lambda", "", "smallest lambda ratio of all contacts"},
       [](F f, int) { return f.contacts > 0.0 ? f.lambda : NAN; },
       Needs::film},
      {{"cage_speed", "rad/s", "mean speed of the balls about the axis of the outer ring"},
       cage_speed}};
  add_losses(list, true);
  add(list,
      {{{"entrainment_top", "m/s", "entrainment speed at the largest load on the inner raceway"},
        [](F f, int) { return f.entrainment; }},
       {{"h_min_top", "m", "smallest film thickness at the largest load on the inner raceway"},
        [](F f, int) { return f.film[0]; },
        Needs::film},
       {{"lambda_top", "", "lambda ratio at the largest load on the inner raceway"},
        [](F f, int) { return f.film[1]; },
        Needs::film},
       {{"h_c_top", "m", "central film thickness at the largest load on the inner raceway"},
        [](F f, int) { return f.film[2]; },
        Needs::capacitance},
       {{"capacitance", "F", "capacitance of the bearing, without background"},
        [](F f, int) { return f.capacitance; },
        Needs::capacitance},
       {{"capacitance_top", "F", "largest capacitance of one ball with its two contacts in series"},
        [](F f, int) { return f.capacitance_top; },
        Needs::capacitance}});
  add_losses(list, false);
  add(list,
      {cage_force,
       {{"asperity_share_top", "",
         "fraction of the load on asperities at the largest load on the inner raceway"},
        [](F f, int) { return f.asperity_share; },
        Needs::nothing,
        parts_with(&raceway::LawFacts::asperities)},
       {{"capacitance_total", "F",
         "capacitance of all balls with their surroundings, without background"},
        [](F f, int) { return f.whole; },
        Needs::surroundings},
       {{"capacitance_total_top", "F", "largest capacitance of one ball with its surroundings"},
        [](F f, int) { return f.whole_top; },
        Needs::surroundings}});
  return list;
}

std::vector<Figure> of_ring()
{
  std::vector<Figure> list = {
      {{"contacts", "", "number of contacts between balls and the ring", has_none, as_whole},
       contacts},
      {{"balls", "", "number of balls on the ring in contact with both raceways", has_none,
        as_whole},
       loaded_balls},
      {{"load", "N", "largest elastic contact load"},
       [](F f, int) { return std::max(f.load[0], f.load[1]); }},
      {{"pressure", "Pa", "largest Hertz pressure"}, pressure},
      {{"h_min", "m", "smallest minimum film thickness of all contacts"}, thinnest, Needs::film},
      {{"lambda", "", "smallest lambda ratio of all contacts"}, smallest_lambda, Needs::film},
      {{"orbit", "rad/s", "mean speed of the balls about the ring's axis"}, cage_speed}};
  add_losses(list, true);
  add_losses(list, false);
  list.pop_back();    // removes the loss of the cage
  add(list, {{{"capacitance", "F",
               "sum over balls that touch both raceways, with both contacts in series"},
              [](F f, int) { return f.capacitance; },
              Needs::capacitance},
             {{"capacitance_total", "F",
               "sum over all balls with their surroundings, with both contacts in series"},
              [](F f, int) { return f.whole; },
              Needs::surroundings}});
  return list;
}

std::vector<Figure> of_total()
{
  std::vector<Figure> list = {
      {{"contacts", "", "number of contacts between balls and raceways", has_none, as_whole},
       contacts},
      {{"loaded_balls", "", "number of balls in contact with both raceways", has_none, as_whole},
       loaded_balls},
      {{"load_inner", "N", "largest elastic contact load on the inner raceway"}, load_inner},
      {{"load_outer", "N", "largest elastic contact load on the outer raceway"}, load_outer},
      {{"pressure", "Pa", "largest Hertz pressure"}, pressure},
      {{"h_min", "m", "smallest minimum film thickness of all contacts; 0 when dry"}, thinnest},
      {{"lambda", "", "smallest lambda ratio of all contacts; 0 when dry"}, smallest_lambda},
      {{"cage_speed", "rad/s", "mean speed of the balls about the axis of their ring"},
       cage_speed}};
  add_losses(list, true);
  list.push_back(cage_force);
  add_losses(list, false);
  return list;
}

}    // namespace

const std::vector<Figure> &record_figures()
{
  static const std::vector<Figure> list = of_record();
  return list;
}

const std::vector<Figure> &ring_figures()
{
  static const std::vector<Figure> list = of_ring();
  return list;
}

const std::vector<Figure> &total_figures()
{
  static const std::vector<Figure> list = of_total();
  return list;
}

}    // namespace bearing
