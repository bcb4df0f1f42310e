// SPDX-License-Identifier: GPL-2.0-or-later
// Collects the rows of one rank for RecordFile (record_file.h), sample by sample. The contacts of a
// ball come before the ball itself. This code does not depend on the host.
#pragma once

#include "record_file.h"

#include <cstdint>

namespace bearing {

class RecordRows {
 public:
  using Tag = std::int64_t;
  using Columns = std::vector<const ContactColumn *>;

  // Prepares to collect samples for a file in batches of `batch` samples.
  void begin(const RecordLayout &, const RecordFile &, const Columns &, size_t batch);

  // Returns the index of a ball in the layout, or -1 if it is not in the record.
  int ball(Tag tag) const
  {
    const Place p = place(tag);
    return p.kind == RecordFile::BALL ? p.at : -1;
  }
  // Returns true if orbit() must be called. The orbital speed of a ball (rad/s) is measured about
  // the axis of the outer ring or, if the ball has only one ring, of that ring.
  bool needs_orbit(int ball, raceway::Side s) const
  {
    return s == raceway::Side::outer || shares_[ball].orbit == 0.0;
  }
  void orbit(int ball, double value) { shares_[ball].orbit = value; }
  void contact(int ball, const ContactView &);    // adds an active contact
  // Adds two surfaces that are not in contact; only their surroundings have values.
  void gap(int ball, const ContactView &);
  // Adds a contact with a cage ball or another ball. The loss (W) is the part that is assigned to
  // this ball; the force is in N.
  void cage(int ball, double loss, double force) { shares_[ball].cage(loss, force); }
  void rail(Tag cage_ball, double loss);    // W
  void land(Tag cage, double loss);         // W, loss of a one-piece cage at its land and by
                                            // churning
  // Adds a ball or cage ball. Must be called after all of its contacts have been added.
  void body(Tag, const raceway::Vec3 &x, const raceway::Vec3 &v, const raceway::Vec3 &w);
  void ring(const double *of);    // values are the columns from of_ring::RING on; must be called
                                  // after land()
  // Ends a sample. The temperatures are in the order used in a row of RecordFile.
  void end(double time, double step, const std::vector<double> &temperatures);

  bool full() const { return samples_ == batch_; }
  size_t samples() const { return samples_; }
  const std::vector<double> &said()
  {
    said_.resize(used_);
    return said_;
  }
  void clear();
  size_t bytes() const { return said_.capacity() * sizeof(double); }

 private:
  using Kind = RecordFile::Kind;
  struct Place {
    Kind kind;
    int at;
  };
  Place place(Tag t) const
  {
    return static_cast<size_t>(t) < places_.size() ? places_[t] : Place{RecordFile::END, 0};
  }
  double *row(Kind, int at);
  double *contact_row(int ball, const ContactView &);
  double *room(size_t numbers)
  {
    if (used_ + numbers > said_.size()) said_.resize(2 * (used_ + numbers));
    double *to = &said_[used_];
    used_ += numbers;
    return to;
  }

  Columns columns_;
  int grooves_ = 1;              // per ring
  std::vector<Place> places_;    // sorted by tag
  size_t widths_[4] = {};
  size_t batch_ = 1, samples_ = 0;
  std::vector<double> said_;    // only the first used_ values are valid
  size_t used_ = 0;
  // values of the current sample
  std::vector<BallFigures> shares_;    // for each ball
  std::vector<double> rails_;          // W, for each cage ball
  std::vector<double> lands_;          // W, for each ring
};

}    // namespace bearing
