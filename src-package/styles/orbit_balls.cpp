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
    const Vec3 at = axes_.third(Vec3::from(atom.x[c.i_ball]));
    if (balls_.empty() || balls_.back().tag != tag)
      balls_.push_back({0.0, tag, 0.0, 0.0, at, axes_.third(Vec3::from(atom.v[c.i_ball])),
                        axes_.third(Vec3::from(atom.omega[c.i_ball]))});
    Ball &ball = balls_.back();
    const bool outer = c.side() == raceway::Side::outer;
    if (outer) ball.row = static_cast<double>(c.ring);
    if (!c.live) continue;
    ball.load += c.state.load;
    if (!outer) ball.inner += c.state.load;
  }
  balls_ = gather_all(balls_, lmp->world);
  std::sort(balls_.begin(), balls_.end(), [](const Ball &a, const Ball &b) {
    return a.row != b.row ? a.row < b.row : a.tag < b.tag;
  });
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
  for (auto row = balls_.begin(); row != balls_.end(); ++rows_) {
    const double ring = row->row;
    const auto end =
        std::find_if(row, balls_.end(), [ring](const Ball &b) { return b.row != ring; });
    const Vec3 centre = std::find_if(rings.begin(), rings.end(), [ring](const Ring &r) {
                          return r.tag == ring;
                        })->origin;
    for (auto b = row; b != end; ++b) b->x -= centre;
    const double first = row->azimuth();
    const auto after = [first](const Ball &b) {
      const double angle = b.azimuth() - first;
      return angle < 0.0 ? angle + 2.0 * M_PI : angle;
    };
    std::sort(row + 1, end, [&after](const Ball &a, const Ball &b) { return after(a) < after(b); });
    row = end;
  }
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

bool OrbitBalls::all_loaded() const
{
  const auto less = [](const Ball &a, const Ball &b) { return a.inner < b.inner; };
  const auto [least, most] = std::minmax_element(balls_.begin(), balls_.end(), less);
  return least->inner > 0.01 * most->inner;    // an oil film also transmits a small load
}

int OrbitBalls::slot(int ball, double passes) const
{
  const int n = balls_a_row(), shift = static_cast<int>(std::fmod(passes, n)), own = ball % n;
  return ball - own + (own + sense() * shift + n) % n;
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

std::vector<double> OrbitBalls::advance(const std::vector<double> &before,
                                        const std::vector<double> &now) const
{
  const size_t n = static_cast<size_t>(numbers) * balls_a_row();
  std::vector<double> rows(rows_, sense() * spacing());
  for (size_t k = 0; k < now.size(); k += numbers)
    rows[k / n] += std::remainder(now[k] - before[k], 2.0 * M_PI) / balls_a_row();
  return rows;
}

}    // namespace bearing
