// SPDX-License-Identifier: GPL-2.0-or-later
#include "bearing_instants.h"

#include "../bodies/shaft_ring.h"
#include "../numbers/cubic.h"
#include "../numbers/lanes_apart.h"

namespace raceway {

void BearingInstants::want(const Instants &i)
{
  if (i.number == instants_.number && i.capacitors == instants_.capacitors) return;
  instants_ = i;
  if (i.number < 2) return;
  const size_t n = i.number - 1;
  looks_.resize(n * b_.n_contacts);
  models_.clear();
  bool any = false, surrounded = false;
  for (const BearingBodies::Track &t : b_.tracks) {
    models_.push_back(i.capacitors[t.ring]);
    any = any || models_.back().permittivity > 0.0;
    surrounded = surrounded || models_.back().surrounded();
  }
  capacitors_.resize(any ? n * b_.n_contacts : 0);
  surrounded_.clear();
  if (surrounded)
    for (size_t t = 0; t < b_.tracks.size(); ++t)
      surrounded_.push_back(models_[t].surrounded()
                                ? SurroundedRaceway(*b_.tracks[t].physics, models_[t])
                                : SurroundedRaceway());
  bodies_.resize(n * b_.groups.size());
  rings_.resize(n * b_.rings.size());
  end_.resize(b_.groups.size());
}

RACEWAY_LANES void BearingInstants::contacts(int k, bool whole_states,
                                             std::vector<ContactAtInstant> &to) const
{
  to.resize(b_.contact_at.size());
  ContactAtInstant nobody;    // used for lanes without a ball
  int group = 0;
  for (size_t t = 0; t < b_.tracks.size(); ++t)
    for (int g = b_.tracks[t].first; g < b_.tracks[t].end; ++g, ++group) {
      const int at = (k - 1) * b_.n_contacts + group;
      const ContactLook &look = looks_[at];
      ContactAtInstant *one[lanes];
      for (int i = 0; i < lanes; ++i) {
        const int groove = b_.groove_at[lanes * group + i];
        one[i] = groove < 0 ? &nobody : &to[groove];
      }
      const bool any_capacitor = models_[t].permittivity > 0.0;
      if (any_capacitor)
        lanes_apart(capacitors_[at].of, {&one[0]->capacitor, &one[1]->capacitor, &one[2]->capacitor,
                                         &one[3]->capacitor});
      if (whole_states && any(look.live))
        lanes_apart(look.state, {&one[0]->state, &one[1]->state, &one[2]->state, &one[3]->state});
      for (int i = 0; i < lanes; ++i) {
        ContactAtInstant &c = *one[i];
        c.orbit = look.orbit[i];
        c.live = look.live[i];
        c.load = c.live ? look.state.load[i] : 0.0;
        if (!any_capacitor || (!c.live && !models_[t].surrounded())) c.capacitor = {};
      }
    }
}

BodyPose BearingInstants::body(int k, int body) const
{
  const int slot = b_.slot[body], lane = slot % lanes;
  const Bodies &of = bodies_[(k - 1) * b_.groups.size() + slot / lanes];
  const auto pick = [lane](const Vec3L &v) { return Vec3{v.x[lane], v.y[lane], v.z[lane]}; };
  return {pick(of.x), pick(of.v), pick(of.w), {}};
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
    failure = look_at(next_, double(next_) / n);
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

// Evaluates instant k, which is at the fraction s of the host's step.
RACEWAY_LANES Failure BearingInstants::look_at(int k, double s)
{
  Stage stage;
  stage.looks = looks_.data() + (k - 1) * b_.n_contacts;
  stage.gaps = !surrounded_.empty();
  const Failure failure = forces_.evaluate(stage);
  if (failure != Failure::none) return failure;
  Bodies *body = bodies_.data() + (k - 1) * b_.groups.size();
  for (const BodyGroup &g : b_.groups) {
    const Vec3L x = g.now.place();
    body->x = {x.x + b_.centre.x, x.y + b_.centre.y, x.z + b_.centre.z};
    body->v = g.now.lab(g.v);
    body->w = g.now.lab(g.w);
    ++body;
  }
  RingAtInstant *ring = rings_.data() + (k - 1) * b_.rings.size();
  for (const RingBody &r : b_.rings) {
    const Vec3 push = r.loose ? b_.force_on(r, s) : Vec3();
    *ring++ = {r.now, r.force, r.moment, r.program.acceleration(push)};
  }
  for (const BearingBodies::Carried &c : b_.on_shafts) {
    const RingBody &shaft = b_.rings[c.shaft];
    rings_[(k - 1) * b_.rings.size() + c.ring].acceleration =
        carried_acceleration(shaft.program, shaft.now, b_.rings[c.ring].at, b_.force_on(shaft, s),
                             b_.moment_on(shaft, s));
  }
  for (ShaftBend &b : b_.bends) {
    const RingBody &shaft = b_.rings[b.shaft];
    const Vec3 push = b_.force_on(shaft, s),
               moment = b_.moment_on(shaft, s) + moment_of_modes(*b.modes, b.now, shaft.now.spin);
    const std::vector<double> &forces = b.forces(shaft.program, shaft.now, s);
    for (const ShaftBend::Seat &seat : b.seats)
      rings_[(k - 1) * b_.rings.size() + seat.ring].acceleration =
          carried_acceleration(shaft.program, shaft.now, seat.at, push, moment) +
          bending_acceleration(*b.modes, *seat.station, forces);
  }
  if (!capacitors_.empty()) capacitors(k);
  return failure;
}

RACEWAY_LANES void BearingInstants::capacitors(int k)
{
  const ContactLook *look = looks_.data() + (k - 1) * b_.n_contacts;
  Capacitors *to = capacitors_.data() + (k - 1) * b_.n_contacts;
  for (size_t t = 0; t < b_.tracks.size(); ++t) {
    const BearingBodies::Track &track = b_.tracks[t];
    const CapacitorModel &model = models_[t];
    for (int g = track.first; g < track.end; ++g, ++look, ++to)
      if (model.surrounded()) {
        // lanes without a ball count as live if any lane is live, so that all lanes are of the same
        // kind
        const LaneMask spare = any(look->live) ? ~b_.groups[g].used : LaneMask{};
        to->of = surrounded_[t].capacitor(look->state, look->live | spare, look->orbit);
      } else if (model.permittivity > 0.0 && any(look->live) && track.physics->facts().film)
        to->of = film_capacitor(*track.physics, look->state, model);
  }
}

}    // namespace raceway
