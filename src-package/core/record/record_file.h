// SPDX-License-Identifier: GPL-2.0-or-later
// A record as one netCDF file: the variables, the assembly of a sample from the rows of its parts,
// and the sums over each bearing. The order in which the rows arrive does not affect the bytes of
// the file. This code does not depend on the host.
#pragma once

#include "../figures/bearing_figures.h"
#include "../figures/fix_columns.h"
#include "netcdf_file.h"
#include "record_layout.h"

namespace bearing {

class RecordFile {
 public:
  struct Content {
    std::vector<Column> contact;    // columns of the contacts
    bool single = false;            // store contacts in single precision
    bool motion = true;             // include the motion of balls and cage
    bool film = false, capacitance = false, surroundings = false;
    unsigned law = 0;        // parts of the contact law
    bool spheres = false;    // true if balls may touch cage balls or one another
    bool heat = false;       // true if temperatures follow the losses
    NetcdfHeader::Attributes about;
  };
  // A row consists of its kind, its index in the layout and its values. The row that ends a sample
  // contains the time, the step and, if `heat` is true, the temperatures of each bearing (NAN if
  // unknown). The index of a contact is (raceway * grooves + groove) * balls + ball.
  enum Kind { BALL, CONTACT, CAGE, RING, END };
  // number of temperatures per bearing, which are the columns of of_fix_heat from INNER to OIL
  enum { TEMPERATURES = of_fix_heat::OIL + 1 - of_fix_heat::INNER };
  enum { MOTION = 9, FIRST_OF_RING = of_ring::X, RING_VALUES = of_ring::AZ + 1 - of_ring::X };

  RecordFile(const RecordLayout &, const Content &);

  size_t width(Kind) const;    // number of values per row
  size_t record_bytes() const { return header_.record_bytes(); }
  int finished() const { return finished_; }
  const NetcdfHeader &header() const { return header_; }
  NetcdfFile &file() { return file_; }

  // Reads rows up to the end of a sample or of the list, and returns the end of the rows that have
  // been read.
  const double *take(const double *row, const double *end, bool &whole);
  // Writes the sample, including the row that ends it, once all parts have been received. Returns
  // an error message, which is empty on success.
  std::string end_sample(const double *row);

 private:
  void sum_up();

  RecordLayout layout_;
  Content content_;
  NetcdfHeader header_;
  NetcdfFile file_;
  int finished_ = -1;
  static constexpr size_t nowhere = SIZE_MAX;    // position of a column that is not in the record
  // positions of the columns in bytes from the start of a sample
  size_t time_, step_, pocket_ = nowhere;
  std::vector<size_t> contact_, ball_, cage_, ring_, bearing_, heat_;
  unsigned char *sample_ = nullptr;    // the current sample, or null if nothing has been received
                                       // for it yet
  std::vector<BallFigures> shares_;
  std::vector<double> rails_;         // W, for each cage ball
  std::vector<double> lands_;         // W, for each ring
  std::vector<size_t> cage_rings_;    // indices into layout_.rings, ordered by bearing
  size_t reported_ = 0;
};

}    // namespace bearing
