// SPDX-License-Identifier: GPL-2.0-or-later
#include "bearing_instants.h"

#include "../bodies/shaft_ring.h"
#include "../numbers/cubic.h"
#include "../numbers/lanes_apart.h"

namespace raceway {

void BearingInstants::want(const Instants &i)
{
  if (i == instants_) return;
  instants_ = i;
  if (i.number < 2) return;
  looks_.resize(b_.n_contacts);
  models_.clear();
  bool any = false, surrounded = false;
  for (const BearingBodies::Track &t : b_.tracks) {
    models_.push_back(i.capacitors[t.ring]);
    any = any || models_.back().permittivity > 0.0;
    surrounded = surrounded || models_.back().surrounded();
  }
  capacitors_.resize(any ? b_.n_contacts : 0);
  surrounded_.clear();
  if (surrounded)
    for (size_t t = 0; t < b_.tracks.size(); ++t)
      surrounded_.push_back(models_[t].surrounded()
                                ? SurroundedRaceway(*b_.tracks[t].physics, models_[t])
                                : SurroundedRaceway());
  end_.resize(b_.groups.size());
}

void BearingInstants::write_to(std::vector<BearingAtInstant> &to)
{
  to_ = &to;
  to.resize(instants_.number < 2 ? 0 : instants_.number - 1);
  for (BearingAtInstant &one : to) {
    one.contacts.resize(b_.contact_at.size());
    one.bodies.resize(b_.slot.size());
    one.rings.resize(b_.rings.size());
  }
}

Failure BearingInstants::pass(double h, double s0, double s1)
{
  const int n = instants_.number;
  if (n < 2) return Failure::none;
  if (s0 == 0.0) next_ = 1;
  const auto passed = [&] { return next_ < n && (s1 == 1.0 || next_ <= s1 * n); };
  if (!passed()) return Failure::none;
  keep();
  Failure failure = Failure::none;
  for (; failure == Failure::none && passed(); ++next_) {
    const double s = (double(next_) / n - s0) / (s1 - s0);
    move(h, s < 1.0 ? s : 1.0);
    failure = look_at(double(next_) / n, (*to_)[next_ - 1]);
  }
  put_back();
  return failure;
}

void BearingInstants::keep()
{
  for (size_t k = 0; k < b_.groups.size(); ++k)
    end_[k] = {b_.groups[k].now, b_.groups[k].v, b_.groups[k].w};
  b_.on_border([](auto &one) { one.keep(); });
  for (BallTurns &t : b_.turns) t.keep();
  kept_end_ = b_.kept;
}

void BearingInstants::put_back()
{
  for (size_t k = 0; k < b_.groups.size(); ++k) {
    BodyGroup &g = b_.groups[k];
    g.now = end_[k].frame;
    g.v = end_[k].v;
    g.w = end_[k].w;
  }
  b_.on_border([](auto &one) { one.put_back(); });
  for (BallTurns &t : b_.turns) t.put_back();
  std::swap(b_.kept, kept_end_);
}

// Moves all bodies to their positions at the fraction s of the internal step.
RACEWAY_LANES void BearingInstants::move(double h, double s)
{
  const Cubic at(s, h);
  for (size_t k = 0; k < b_.groups.size(); ++k) {
    BodyGroup &g = b_.groups[k];
    const Motion &end = end_[k];
    g.now.r = at(g.from.r, g.v_from.x, end.frame.r, end.v.x);
    g.now.z = at(g.from.z, g.v_from.z, end.frame.z, end.v.z);
    g.now.turn_from(g.from, at(Lane{}, Lane(g.v_from.y / g.from.r), Lane(g.turned + g.turn),
                               Lane(end.v.y / end.frame.r)));
    g.v = g.v_from + (end.v - g.v_from) * s;
    g.w = g.w_from + (end.w - g.w_from) * s;
  }
  for (BallTurns &t : b_.turns) {
    const Motion &end = end_[t.group];
    t.between(b_.groups[t.group], end.frame, end.v, end.w, h, s);
  }
  b_.on_border([h, s](auto &one) { one.between(h, s); });
  b_.carry();
  for (size_t k = 0; k < b_.kept.size(); ++k)
    for (int m = 0; m < b_.states(); ++m)
      b_.kept[k].now[m] = b_.kept[k].from[m] + (kept_end_[k].now[m] - b_.kept[k].from[m]) * s;
}

// Evaluates the instant at the fraction s of the host's step.
Failure BearingInstants::look_at(double s, BearingAtInstant &to)
{
  Stage stage;
  stage.looks = looks_.data();
  stage.gaps = !surrounded_.empty();
  const Failure failure = forces_.evaluate(stage);
  if (failure != Failure::none) return failure;
  if (!capacitors_.empty()) capacitors();
  store_contacts(to.contacts);
  store_bodies(to.bodies);
  store_rings(s, to.rings);
  return failure;
}

RACEWAY_LANES void BearingInstants::store_contacts(std::vector<BearingAtInstant::Contact> &to)
{
  BearingAtInstant::Contact nobody;    // used for lanes without a ball or without a state
  int group = 0;
  for (size_t t = 0; t < b_.tracks.size(); ++t)
    for (int g = b_.tracks[t].first; g < b_.tracks[t].end; ++g, ++group) {
      const ContactLook &look = looks_[group];
      BearingAtInstant::Contact *one[lanes], *live[lanes];
      for (int i = 0; i < lanes; ++i) {
        const int groove = b_.groove_at[lanes * group + i];
        one[i] = groove < 0 ? &nobody : &to[groove];
        live[i] = look.live[i] ? one[i] : &nobody;
      }
      const bool capacitor = models_[t].permittivity > 0.0;
      if (capacitor)
        lanes_apart(capacitors_[group].of, {&one[0]->capacitor, &one[1]->capacitor,
                                            &one[2]->capacitor, &one[3]->capacitor});
      if (instants_.states && any(look.live))
        lanes_apart(look.state,
                    {&live[0]->state, &live[1]->state, &live[2]->state, &live[3]->state});
      for (int i = 0; i < lanes; ++i) {
        BearingAtInstant::Contact &c = *one[i];
        c.orbit = look.orbit[i];
        c.live = look.live[i];
        c.load = c.live ? look.state.load[i] : 0.0;
        if (!capacitor || (!c.live && !models_[t].surrounded())) c.capacitor = {};
      }
    }
}

RACEWAY_LANES void BearingInstants::store_bodies(std::vector<BearingAtInstant::Body> &to)
{
  BearingAtInstant::Body nobody;    // used for padding
  for (size_t k = 0; k < b_.groups.size(); ++k) {
    const BodyGroup &g = b_.groups[k];
    const Vec3L x = g.now.place();
    const Bodies of = {
        {x.x + b_.centre.x, x.y + b_.centre.y, x.z + b_.centre.z}, g.now.lab(g.v), g.now.lab(g.w)};
    BearingAtInstant::Body *one[lanes];
    for (int i = 0; i < lanes; ++i) {
      const int body = b_.body_at[lanes * k + i];
      one[i] = body < 0 ? &nobody : &to[body];
    }
    lanes_apart(of, one);
  }
}

void BearingInstants::store_rings(double s, std::vector<BearingAtInstant::Ring> &to)
{
  for (size_t k = 0; k < b_.rings.size(); ++k) {
    const RingBody &r = b_.rings[k];
    const Vec3 push = r.loose ? b_.force_on(r, s) : Vec3();
    to[k] = {r.now, r.force, r.moment, r.program.acceleration(push)};
  }
  for (const BearingBodies::Carried &c : b_.on_shafts) {
    const RingBody &shaft = b_.rings[c.shaft];
    to[c.ring].acceleration = carried_acceleration(shaft.program, shaft.now, b_.rings[c.ring].at,
                                                   b_.force_on(shaft, s), b_.moment_on(shaft, s));
  }
  for (ShaftBend &b : b_.bends) {
    const RingBody &shaft = b_.rings[b.shaft];
    const Vec3 push = b_.force_on(shaft, s),
               moment = b_.moment_on(shaft, s) + moment_of_modes(*b.modes, b.now, shaft.now.spin);
    const std::vector<double> &forces = b.forces(shaft.program, shaft.now, s);
    for (const ShaftBend::Seat &seat : b.seats)
      to[seat.ring].acceleration =
          carried_acceleration(shaft.program, shaft.now, seat.at, push, moment) +
          bending_acceleration(*b.modes, *seat.station, forces);
  }
}

RACEWAY_LANES void BearingInstants::capacitors()
{
  int contact = 0;    // index of the contact group
  for (size_t t = 0; t < b_.tracks.size(); ++t) {
    const BearingBodies::Track &track = b_.tracks[t];
    const CapacitorModel &model = models_[t];
    const bool plates = model.permittivity > 0.0 && track.physics->facts().film;
    for (int g = track.first; g < track.end; ++g, ++contact) {
      const ContactLook &look = looks_[contact];
      if (model.surrounded()) {
        // lanes without a ball count as live if any lane is live, so that all lanes are of the same
        // kind
        const LaneMask spare = any(look.live) ? ~b_.groups[g].used : LaneMask{};
        capacitors_[contact].of =
            surrounded_[t].capacitor(look.state, look.live | spare, look.orbit);
      } else if (plates && any(look.live)) {
        capacitors_[contact].of = film_capacitor(*track.physics, look.state, model);
      }
    }
  }
}

}    // namespace raceway
