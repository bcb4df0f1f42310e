// SPDX-License-Identifier: GPL-2.0-or-later
// State of the bearings at instants within a host step, as provided by fix bearing/implicit.
// Vectors refer to the lab frame.
#pragma once

#include "../core/electric/film_capacitor.h"
#include "../core/figures/bearing_columns.h"
#include "../core/numbers/tag.h"

#include <functional>
#include <string>
#include <vector>

namespace bearing {

// Requested instants at the fractions k/number of a host step, with k = 1 to number - 1. If number
// is 0, no instants are requested; if the permittivity is 0, no capacitances are requested.
struct Instants {
  int number = 0;
  raceway::CapacitorModel capacitor;
  bool states = false;         // true if contact states are also requested
  std::vector<tag_t> balls;    // balls of all ranks whose capacitances are requested
};

// A possible contact between a ball and a groove.
struct InstantContact {
  tag_t ball, ring;
  const raceway::RacewayPhysics &raceway;
  double orbit;    // rad/s, orbital speed of the ball about the ring's axis
  bool live;
  double load;                                         // N
  const raceway::FilmCapacitorT<double> &capacitor;    // 0 if it was not requested
  const raceway::ContactState &state;                  // valid if live and requested
};

struct InstantBody {
  tag_t tag;
  raceway::Vec3 x, v, w;
};

struct InstantRing {
  double of[of_ring::AZ + 1];    // values from of_ring::RING onwards
};

// Functions that are called for the parts of a bearing, first for the contacts, ball by ball, and
// then for the bodies.
struct InstantReader {
  std::function<void(const InstantContact &)> contact;
  std::function<void(const InstantBody &)> body;    // may be null
  std::function<void(const InstantRing &)> ring;    // may be null
};

// A fix that performs separate substeps within the host step (fix bearing/implicit).
class InstantSource {
 public:
  // Must be called in the setup() of another fix. The instants are then available after every step.
  // Error messages contain the name `command`.
  virtual void want_instants(const Instants &, const std::string &command) = 0;
  // Reads the k-th instant (counted from 1) of the bearings whose home is on this rank.
  virtual void read_instant(int k, const InstantReader &) const = 0;

 protected:
  ~InstantSource() = default;
};

}    // namespace bearing
