// SPDX-License-Identifier: GPL-2.0-or-later
#include "orbit_balls.h"

#include "../ranks/gather.h"
#include "fix_bearing_state.h"
#include "pair_bearing_hertz.h"

#include <algorithm>

using namespace LAMMPS_NS;
using raceway::Vec3;

namespace bearing {

OrbitBalls::OrbitBalls(LAMMPS *lmp) : lmp_(lmp)
{
  PairBearingHertz &pair = *PairBearingHertz::find(lmp, "run_bearing");
  const Atom &atom = *lmp->atom;
  axes_.along = pair.coefficients().axis_index();
  for (const RacewayContact &c : pair.table().raceway) {
    const double tag = static_cast<double>(c.ball);
    if (balls_.empty() || balls_.back().tag != tag)
      balls_.push_back({tag, 0.0, axes_.third(Vec3::from(atom.x[c.i_ball])),
                        axes_.third(Vec3::from(atom.v[c.i_ball])),
                        axes_.third(Vec3::from(atom.omega[c.i_ball]))});
    if (c.live) balls_.back().load += c.state.load;
  }
  balls_ = gather_all(balls_, lmp->world);
  const auto by_tag = [](const auto &a, const auto &b) { return a.tag < b.tag; };
  std::sort(balls_.begin(), balls_.end(), by_tag);
  struct Ring {
    double tag;
    Vec3 origin;
  };
  std::vector<Ring> rings;
  for (int i = 0; i < atom.nlocal; ++i)
    if (pair.coefficients().is_ring(atom.type[i]))
      rings.push_back(
          {static_cast<double>(atom.tag[i]), axes_.third(pair.state()->ring(i).origin)});
  rings = gather_all(rings, lmp->world);
  const Vec3 centre = std::min_element(rings.begin(), rings.end(), by_tag)->origin;
  for (Ball &b : balls_) b.x -= centre;
  const double first = balls_.front().azimuth();
  const auto after = [first](const Ball &b) {
    const double angle = b.azimuth() - first;
    return angle < 0.0 ? angle + 2.0 * M_PI : angle;
  };
  std::sort(balls_.begin() + 1, balls_.end(),
            [&after](const Ball &a, const Ball &b) { return after(a) < after(b); });
}

Vec3 OrbitBalls::Ball::place(const Vec3 &u) const
{
  const double c = x.x / radius(), s = x.y / radius();
  return {u.x * c + u.y * s, u.y * c - u.x * s, u.z};
}

Vec3 OrbitBalls::Ball::lab(const Vec3 &u) const
{
  const double c = x.x / radius(), s = x.y / radius();
  return {u.x * c - u.y * s, u.x * s + u.y * c, u.z};
}

int OrbitBalls::sense() const
{
  double sum = 0.0;
  for (const Ball &b : balls_) sum += b.place(b.v).y;
  return sum < 0.0 ? -1 : 1;
}

int OrbitBalls::slot(int ball, double passes) const
{
  const int shift = static_cast<int>(std::fmod(passes, size()));
  return (ball + sense() * shift + size()) % size();
}

std::vector<double> OrbitBalls::by_slot(double passes) const
{
  std::vector<double> all(static_cast<size_t>(numbers) * size());
  for (int k = 0; k < size(); ++k) {
    const Ball &b = balls_[k];
    double *to = &all[static_cast<size_t>(numbers) * slot(k, passes)];
    to[0] = b.azimuth();
    to[1] = b.place(b.v).y / b.radius();
    b.place(b.w).to(to + 2);
  }
  return all;
}

std::vector<double> OrbitBalls::weights(double passes) const
{
  double load = 0.0, orbit = 0.0, spin = 0.0;
  for (const Ball &b : balls_) {
    const double speed = b.place(b.v).y / b.radius();
    load += b.load;
    orbit += speed * speed / size();
    spin = std::max(spin, dot(b.w, b.w));
  }
  std::vector<double> all(static_cast<size_t>(numbers) * size());
  for (int k = 0; k < size(); ++k) {
    double *to = &all[static_cast<size_t>(numbers) * slot(k, passes)];
    const double share = load > 0.0 ? balls_[k].load / load * std::sqrt(size()) : 1.0;
    to[1] = share / std::sqrt(orbit);
    for (int j = 2; j < numbers; ++j) to[j] = share / std::sqrt(spin);
  }
  return all;
}

void OrbitBalls::put(double passes, const std::vector<double> &by_slot) const
{
  Atom &atom = *lmp_->atom;
  for (int k = 0; k < size(); ++k) {
    const int i = atom.map(static_cast<tag_t>(balls_[k].tag));
    if (i < 0 || i >= atom.nlocal) continue;
    const Ball &b = balls_[k];
    const double *from = &by_slot[static_cast<size_t>(numbers) * slot(k, passes)];
    Vec3 v = b.place(b.v);
    v.y = from[1] * b.radius();
    axes_.lab(b.lab(v)).to(atom.v[i]);
    axes_.lab(b.lab(Vec3::from(from + 2))).to(atom.omega[i]);
  }
}

double OrbitBalls::advance(const std::vector<double> &before, const std::vector<double> &now) const
{
  double sum = 0.0;
  for (size_t k = 0; k < now.size(); k += numbers)
    sum += std::remainder(now[k] - before[k], 2.0 * M_PI);
  return sense() * spacing() + sum / size();
}

}    // namespace bearing
