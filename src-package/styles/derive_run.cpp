// SPDX-License-Identifier: GPL-2.0-or-later
// Variables derived from loads, speeds and sampling that the user of a deck chooses.
#include "derive_laws.h"

#include <algorithm>

using bearing::DataValues;

namespace {

// The speed, and where the rings start: with a contact angle, or four points and a thrust, balls
// are in contact with both raceways on the side of the thrust. The contact angle is one of the
// usual data of a bearing.
void start(DataValues &deck)
{
  if (deck.number("contact_angle") != 0.0)
    if (!deck.there("b_usual") || deck.word("b_usual") != deck.word("bearing"))
      deck.range("contact_angle", deck.word("contact_angle"),
                 {"0", "0", "advice", "needs a bearing by its usual data, as 7208"});
  deck.set("b_omega", 2 * M_PI * deck.number("rpm") / 60);
  const bool angle = deck.number("contact_angle") > 0.0, four = deck.number("four_point") > 0.0;
  const double axial = deck.number("axial");
  deck.set("b_seat", (angle || four) && axial < 0.0   ? "minus"
                     : angle || (four && axial > 0.0) ? "plus"
                                                      : "none");
}

// The radial load, rounded to 15 digits so that a load along -y has no x component. The ring is
// held along its axis without an axial load, and its tilts are held without a moment.
void loads(DataValues &deck)
{
  const double azimuth = deck.number("load_azimuth"), load = deck.number("load");
  const auto part = [load](double share) {
    return std::floor(1.0e15 * share + 0.5) / 1.0e15 * load;
  };
  deck.set("b_load_x", part(std::cos(azimuth)));
  deck.set("b_load_y", part(std::sin(azimuth)));
  const bool tilts = deck.number("moment_x") != 0.0 || deck.number("moment_y") != 0.0;
  deck.set("b_z", deck.number("axial") != 0.0 ? "free" : "fixed");
  deck.set("b_tilt", tilts ? "free" : "fixed");
}

// Ball pass period, and settling time: the time for the ring to come to rest, or the ramp if
// longer, plus ball passes under full load. The bits of a run depend on both, so the mean diameter
// is rounded as it is written.
void ball_pass(DataValues &deck)
{
  deck.set("b_pitch", 0.5 * (deck.number("inner_radius") + deck.number("b_outer_raceway")));
  const double cosine = std::cos((deck.number("contact_angle") + deck.number("four_point")) * M_PI /
                                 180),
               share = 1 - 0.5 * deck.number("ball_diameter") * cosine / deck.number("b_pitch");
  deck.set("b_pass_time", 2 * M_PI / (deck.number("balls") * 0.5 * deck.number("b_omega") * share));
  deck.set("b_settle_time", deck.number("settle") * deck.number("b_pass_time") +
                                std::max(1.0e-2, deck.number("ramp")));
}

// Samples per host step, unless given: ten, five, two or one, such that a ball pass is a whole
// number of steps and at least twenty. A given step has one sample.
void samples_within(DataValues &deck)
{
  const double asked = deck.number("within"), samples = deck.number("samples");
  double chosen = 1.0;
  for (const double n : {2.0, 5.0, 10.0})
    if (samples >= 20.0 * n && std::fmod(samples, n) == 0.0) chosen = n;
  deck.set("b_within", asked != 0.0 ? asked : deck.number("step") == 0.0 ? chosen : 1.0);
}

// Host steps of the measurement, between restart files, and between rows of the progress table.
// b_sampling and b_housing are stored in a run's notes unless integrator and housing set more.
void measurement(DataValues &deck)
{
  const double within = deck.number("b_within"), every = deck.number("b_every");
  deck.set("b_keep_steps", std::ceil(deck.number("keep") / within) * every);
  deck.suggest("b_sampling", "samples=" + deck.word("samples"));
  deck.suggest("b_housing", "housing=" + deck.word("housing"));
  deck.suggest("b_samples", deck.number("passes") * deck.number("samples"));
  deck.set("b_steps", deck.number("b_samples") * every / within);
  deck.range("host steps of the measurement", deck.word("b_steps"),
             {"1", "2.0e9", "whole", "advice", "fewer passes or samples; within must divide them"});
  deck.set("b_rows", std::ceil(deck.number("b_steps") / 20));
}

// Kind number b_q of the `kinds` of bearings: its four atom types, and b_wanted, 1 if it is built.
void kind(DataValues &deck)
{
  const int kinds = static_cast<int>(deck.number("kinds")),
            q = static_cast<int>(deck.number("b_q")), only = static_cast<int>(deck.number("only"));
  for (int k = 1; k <= 4; ++k) deck.set("b_t" + std::to_string(k), 4.0 * (q - 1) + k);
  deck.set("b_wanted", only == 0 || (only - 1) % kinds + 1 == q ? 1.0 : 0.0);
}

}    // namespace

bearing::DeriveLaws bearing::run_laws()
{
  return {{"ball_pass", ball_pass},
          {"kind", kind},
          {"loads", loads},
          {"measurement", measurement},
          {"samples_within", samples_within},
          {"start", start}};
}
