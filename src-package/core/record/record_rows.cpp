// SPDX-License-Identifier: GPL-2.0-or-later
#include "record_rows.h"

#include <algorithm>
#include <cstring>

namespace bearing {

using raceway::Side;
using raceway::Vec3;

void RecordRows::begin(const RecordLayout &layout, const RecordFile &file, const Columns &columns,
                       size_t batch)
{
  columns_ = columns;
  grooves_ = layout.grooves;
  batch_ = batch;
  double top = 0.0;
  for (const auto &p : layout.balls) top = std::max(top, p.tag);
  for (const auto &p : layout.cage) top = std::max(top, p.tag);
  for (const auto &p : layout.rings) top = std::max(top, p.tag);
  places_.assign(static_cast<size_t>(top) + 1, {RecordFile::END, 0});
  const auto put = [this](const auto &list, Kind kind) {
    for (size_t k = 0; k < list.size(); ++k)
      places_[static_cast<size_t>(list[k].tag)] = {kind, static_cast<int>(k)};
  };
  put(layout.balls, RecordFile::BALL);
  put(layout.cage, RecordFile::CAGE);
  put(layout.rings, RecordFile::RING);
  shares_.assign(layout.balls.size(), BallFigures());
  rails_.assign(layout.cage.size(), 0.0);
  lands_.assign(layout.rings.size(), 0.0);
  for (Kind k : {RecordFile::BALL, RecordFile::CONTACT, RecordFile::CAGE, RecordFile::RING})
    widths_[k] = file.width(k);
  said_.resize(batch * (file.record_bytes() / sizeof(double) + 3 * layout.bodies()));
  used_ = 0;
}

double *RecordRows::row(Kind kind, int at)
{
  double *to = room(2 + widths_[kind]);
  to[0] = kind;
  to[1] = at;
  return to + 2;
}

double *RecordRows::contact_row(int ball, const ContactView &view)
{
  const int s = view.raceway.groove.side == Side::inner ? 0 : 1;
  const int raceway = s * grooves_ + view.raceway.number;
  return row(RecordFile::CONTACT, raceway * static_cast<int>(shares_.size()) + ball);
}

void RecordRows::contact(int ball, const ContactView &view)
{
  if (!columns_.empty()) {
    double *to = contact_row(ball, view);
    for (const ContactColumn *c : columns_) *to++ = c->value(view);
  }
  shares_[ball].contact(view);
}

void RecordRows::gap(int ball, const ContactView &view)
{
  if (!columns_.empty()) {
    double *to = contact_row(ball, view);
    for (const ContactColumn *c : columns_)
      *to++ = c->needs_surroundings() ? c->value(view) : c->is.absent;
  }
  shares_[ball].gap(view);
}

void RecordRows::rail(Tag cage_ball, double loss)
{
  const Place p = place(cage_ball);
  if (p.kind == RecordFile::CAGE) rails_[p.at] += loss;
}

void RecordRows::land(Tag cage, double loss)
{
  const Place p = place(cage);
  if (p.kind == RecordFile::RING) lands_[p.at] += loss;
}

void RecordRows::body(Tag tag, const Vec3 &x, const Vec3 &v, const Vec3 &w)
{
  const Place p = place(tag);
  if (p.kind != RecordFile::BALL && p.kind != RecordFile::CAGE) return;
  double *to = row(p.kind, p.at);
  x.to(to);
  v.to(to + 3);
  w.to(to + 6);
  if (p.kind == RecordFile::CAGE) {
    to[RecordFile::MOTION] = rails_[p.at];
    rails_[p.at] = 0.0;
    return;
  }
  shares_[p.at].balls = 1.0;
  memcpy(to + RecordFile::MOTION, &shares_[p.at], sizeof(BallFigures));
  shares_[p.at] = BallFigures();
}

void RecordRows::ring(const double *of)
{
  const Place p = place(static_cast<Tag>(of[of_ring::RING]));
  if (p.kind != RecordFile::RING) return;
  double *to = row(p.kind, p.at);
  std::copy(of + RecordFile::FIRST_OF_RING,
            of + RecordFile::FIRST_OF_RING + RecordFile::RING_VALUES, to);
  to[RecordFile::RING_VALUES] = lands_[p.at];
  lands_[p.at] = 0.0;
}

void RecordRows::end(double time, double step, const std::vector<double> &temperatures)
{
  double *to = room(3 + temperatures.size());
  to[0] = RecordFile::END;
  to[1] = time;
  to[2] = step;
  std::copy(temperatures.begin(), temperatures.end(), to + 3);
  ++samples_;
}

void RecordRows::clear()
{
  used_ = 0;
  samples_ = 0;
}

}    // namespace bearing
