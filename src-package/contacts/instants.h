// SPDX-License-Identifier: GPL-2.0-or-later
// Bearings between the steps of the host, as fix bearing/implicit knows them; vectors are in the
// lab.
#ifndef BEARING_INSTANTS_H
#define BEARING_INSTANTS_H

#include "../core/electric/film_capacitor.h"
#include "../core/figures/bearing_columns.h"
#include "../core/numbers/tag.h"

#include <functional>
#include <string>

namespace bearing {

// What is wanted: everything at the shares k/number of a host's step, k = 1 to number - 1. number
// 0: nothing; permittivity 0: no capacitances.
struct Instants {
  int number = 0;
  raceway::CapacitorModel capacitor;
  bool states = false;    // of contacts
};

// A ball and a groove that may touch.
struct InstantContact {
  tag_t ball, ring;
  const raceway::RacewayPhysics &raceway;
  double orbit;    // rad/s, of the ball about the ring's axis
  bool live;
  double load;                                         // N
  const raceway::FilmCapacitorT<double> &capacitor;    // 0 where none is wanted
  const raceway::ContactState &state;                  // if anybody wants states, and live
};

struct InstantBody {
  tag_t tag;
  raceway::Vec3 x, v, w;
};

struct InstantRing {
  double of[of_ring::AZ + 1];    // from of_ring::RING on
};

// Who is told of the parts of a bearing; contacts come ball by ball, and before the bodies.
struct InstantReader {
  std::function<void(const InstantContact &)> contact;
  std::function<void(const InstantBody &)> body;    // or none
  std::function<void(const InstantRing &)> ring;    // or none
};

// A fix that makes steps of its own within those of the host (fix bearing/implicit).
class InstantSource {
 public:
  // Asked for in another fix's setup(), there after every step; `command` is named in errors.
  virtual void want_instants(const Instants &, const std::string &command) = 0;
  // The k-th instant, from 1, of the bearings at home here.
  virtual void read_instant(int k, const InstantReader &) const = 0;

 protected:
  ~InstantSource() = default;
};

}    // namespace bearing

#endif
