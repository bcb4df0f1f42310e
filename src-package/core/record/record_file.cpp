// SPDX-License-Identifier: GPL-2.0-or-later
#include "record_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace bearing {

using Header = NetcdfHeader;

static Header::Attributes said(const Column &c)
{
  return {{"units", *c.unit ? c.unit : "1"}, {"long_name", c.meaning}};
}

RecordFile::RecordFile(const RecordLayout &layout, const Content &content) :
    layout_(layout), content_(content)
{
  const size_t n = layout_.balls.size(), m = layout_.cage.size();
  const bool one_groove = layout_.grooves == 1;
  const int time = header_.dimension("time", 0),
            raceway = header_.dimension("raceway", 2 * layout_.grooves),
            ball = header_.dimension("ball", n), cage = m ? header_.dimension("cage_ball", m) : -1,
            ring = header_.dimension("ring", layout_.rings.size()),
            bearing = header_.dimension("bearing", layout_.bearings.size()),
            letters = header_.dimension("letters", one_groove ? 5 : 7);
  for (const Header::Attribute &a : content_.about) header_.add(a);
  header_.variable({"raceway",
                    {raceway, letters},
                    Header::text,
                    {{"_Encoding", "utf-8"}},
                    one_groove ? "innerouter" : "inner 0inner 1outer 0outer 1",
                    {}});
  finished_ = header_.variable({"finished",
                                {},
                                Header::integer,
                                said({"", "", "1 if the run has reached its end"}),
                                "",
                                {0}});
  const auto fix = [&](const Column &c, int dimension, Header::Type type,
                       const std::vector<double> &values) {
    header_.variable({c.name, {dimension}, type, said(c), "", values});
  };
  const auto each = [](const auto &list, auto value) {
    std::vector<double> values;
    for (const auto &item : list) values.push_back(value(item));
    return values;
  };
  const auto tag = [](const auto &part) { return part.tag; };
  const auto number = [](const auto &part) { return part.bearing + 1.0; };
  fix({"ball", "", "atom number of a ball"}, ball, Header::integer, each(layout_.balls, tag));
  fix({"ball_bearing", "", "its bearing"}, ball, Header::integer, each(layout_.balls, number));
  if (m) {
    fix({"cage_ball", "", "atom number of a cage ball"}, cage, Header::integer,
        each(layout_.cage, tag));
    fix({"cage_ball_bearing", "", "its bearing"}, cage, Header::integer,
        each(layout_.cage, number));
  }
  fix({"ring", "", "atom number of a ring"}, ring, Header::integer, each(layout_.rings, tag));
  fix({"ring_bearing", "", "its bearing"}, ring, Header::integer, each(layout_.rings, number));
  fix({"ring_raceway", "", "0 inner, 1 outer, 2 one-piece cage"}, ring, Header::integer,
      each(layout_.rings, [](const auto &r) { return double(r.raceway); }));
  const char *const origin[] = {"ring_origin_x", "ring_origin_y", "ring_origin_z"};
  for (int k = 0; k < 3; ++k)
    fix({origin[k], "m", "position of the ring at the start"}, ring, Header::real,
        each(layout_.rings, [k](const auto &r) { return r.origin[k]; }));
  if (layout_.pockets()) {
    fix({"ring_pocket_play", "m", "play of a cage's pockets along the pitch circle"}, ring,
        Header::real, each(layout_.rings, [](const auto &r) { return r.play; }));
    fix({"ring_cage_guide", "",
         "guidance of a cage: 0 by balls, 1 by the inner ring, 2 by the outer ring"},
        ring, Header::real, each(layout_.rings, [](const auto &r) { return r.guide; }));
    fix({"ring_pocket_phase", "rad", "azimuth of a cage's first pocket at an angle of 0"}, ring,
        Header::real, each(layout_.rings, [](const auto &r) { return r.phase; }));
  }
  std::vector<double> numbers;
  for (size_t b = 0; b < layout_.bearings.size(); ++b) numbers.push_back(b + 1.0);
  fix({"bearing", "", "number of a bearing"}, bearing, Header::integer, numbers);
  for (int k = 0; k < of_kind::N; ++k)
    if (!one_groove || !of_kind::of_two_grooves(k))
      fix(of_kind::list[k], bearing, Header::real,
          each(layout_.bearings, [k](const auto &b) { return b.of[k]; }));

  // The indices of the variables are stored until their positions in a sample are known.
  const auto add = [&](const std::string &prefix, const Column &c, std::vector<int> dimensions,
                       Header::Type type = Header::real) -> size_t {
    return header_.variable(
        {prefix + c.name, std::move(dimensions), type, said(c), "", {}, c.absent});
  };
  time_ = add("", {"time", "s", "time since the start of the record"}, {time});
  step_ = add("", {"step", "", "step of the host"}, {time});
  for (const Column &c : content_.contact)
    contact_.push_back(
        add("", c, {time, raceway, ball}, content_.single ? Header::single : Header::real));
  if (content_.motion)
    for (int k = 0; k < MOTION; ++k) {
      const Column &c = of_atom::list[of_atom::MOTION + k];
      ball_.push_back(add("ball_", c, {time, ball}));
      if (m) cage_.push_back(add("cage_", c, {time, cage}));
    }
  if (layout_.pockets())
    pocket_ = add(
        "ball_",
        {"pocket_force", "N", "force of the ball on its pocket; known only at the ends of steps"},
        {time, ball});
  for (int k = 0; k < RING_VALUES; ++k)
    ring_.push_back(add("ring_", of_ring::list[FIRST_OF_RING + k], {time, ring}));
  for (const Figure &f : record_figures()) {
    const bool given = f.given(content_.film, content_.capacitance, content_.surroundings,
                               content_.law, content_.spheres);
    bearing_.push_back(given ? add("bearing_", f.is, {time, bearing}) : nowhere);
  }
  if (content_.heat)
    for (int k = 0; k < TEMPERATURES; ++k)
      heat_.push_back(add("bearing_", of_fix_heat::list[of_fix_heat::INNER + k], {time, bearing}));
  header_.layout();
  const auto place = [this](size_t &k) {
    if (k != nowhere) k = header_.variable(static_cast<int>(k)).at;
  };
  place(time_);
  place(step_);
  place(pocket_);
  for (std::vector<size_t> *list : {&contact_, &ball_, &cage_, &ring_, &bearing_, &heat_})
    std::for_each(list->begin(), list->end(), place);
  for (size_t k = 0; k < layout_.rings.size(); ++k)
    if (layout_.rings[k].raceway == RecordLayout::cage_ring) cage_rings_.push_back(k);
  std::stable_sort(cage_rings_.begin(), cage_rings_.end(), [this](size_t a, size_t b) {
    return layout_.rings[a].bearing < layout_.rings[b].bearing;
  });
  shares_.resize(n);
  rails_.resize(m);
  lands_.resize(layout_.rings.size());
}

size_t RecordFile::width(Kind kind) const
{
  switch (kind) {
    case BALL: return MOTION + BallFigures::numbers();
    case CONTACT: return content_.contact.size();
    case CAGE: return MOTION + 1;
    case RING: return RING_VALUES + 1;
    case END: return 2 + heat_.size() * layout_.bearings.size();
  }
  return 0;
}

const double *RecordFile::take(const double *row, const double *end, bool &whole)
{
  whole = false;
  if (!sample_) sample_ = file_.start_record();
  while (row != end) {
    const Kind kind = static_cast<Kind>(row[0]);
    if (kind == END) {
      whole = true;
      return row;
    }
    const size_t place = static_cast<size_t>(row[1]);
    const double *value = row + 2;
    const std::vector<size_t> &at = kind == BALL   ? ball_
                                    : kind == CAGE ? cage_
                                    : kind == RING ? ring_
                                                   : contact_;
    // local copies are used because the compiler must assume that the bytes written may alias any
    // variable
    const size_t *const column = at.data(), columns = at.size();
    const bool single = kind == CONTACT && content_.single;
    unsigned char *const to = sample_ + (single ? 4 : 8) * place;
    if (single)
      for (size_t k = 0; k < columns; ++k) put_single(to + column[k], value[k]);
    else
      for (size_t k = 0; k < columns; ++k) put_real(to + column[k], value[k]);
    if (kind == BALL) {
      memcpy(static_cast<void *>(&shares_[place]), value + MOTION, sizeof(BallFigures));
      if (pocket_ != nowhere) put_real(sample_ + pocket_ + 8 * place, shares_[place].cage_force);
    }
    if (kind == CAGE) rails_[place] = value[MOTION];
    if (kind == RING) lands_[place] = value[RING_VALUES];
    reported_ += kind != CONTACT;
    row = value + width(kind);
  }
  return row;
}

std::string RecordFile::end_sample(const double *row)
{
  const double time = row[1], step = row[2];
  if (reported_ != layout_.bodies())
    return "at step " + std::to_string(static_cast<long long>(step)) + " " +
           std::to_string(reported_) + " of " + std::to_string(layout_.bodies()) +
           " balls, cage balls and rings are present";
  reported_ = 0;
  put_real(sample_ + time_, time);
  put_real(sample_ + step_, step);
  const double *temperature = row + 3;
  for (size_t b = 0; b < (heat_.empty() ? 0 : layout_.bearings.size()); ++b)
    for (const size_t at : heat_) put_real(sample_ + at + 8 * b, *temperature++);
  sum_up();
  sample_ = nullptr;
  return file_.full() ? file_.flush() : "";
}

void RecordFile::sum_up()
{
  const std::vector<Figure> &figures = record_figures();
  size_t ball = 0, cage = 0;
  auto ring = cage_rings_.begin();
  for (size_t b = 0; b < layout_.bearings.size(); ++b) {
    BearingFigures sum;
    for (; ball < shares_.size() && layout_.balls[ball].bearing == static_cast<int>(b); ++ball)
      sum.add(shares_[ball]);
    for (; cage < rails_.size() && layout_.cage[cage].bearing == static_cast<int>(b); ++cage)
      sum.cage_loss += rails_[cage];
    for (; ring != cage_rings_.end() && layout_.rings[*ring].bearing == static_cast<int>(b); ++ring)
      sum.cage_loss += lands_[*ring];
    for (size_t k = 0; k < figures.size(); ++k)
      if (bearing_[k] != nowhere) put_real(sample_ + bearing_[k] + 8 * b, figures[k].value(sum));
  }
}

}    // namespace bearing
