// SPDX-License-Identifier: GPL-2.0-or-later
// The header of a netCDF classic file with 64-bit offsets (CDF-2): dimensions, attributes,
// variables, and the values of variables that have no time dimension. All numbers are big-endian
// (OGC 10-092r3). This code depends neither on the host nor on any library.
//
// The first attribute, `checksum`, contains the length of the header and a checksum of it. The
// checksum is computed with zeros in place of the number of records and of the checksum itself. The
// last variable of a record, `checksum`, covers the bytes before it; its seed is the number of the
// record (core/numbers/checksum.h).
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace bearing {

class NetcdfHeader {
 public:
  enum Type { text = 2, integer = 4, single = 5, real = 6 };
  struct Attribute {
    Attribute(const std::string &called, const std::string &value) :
        name(called), type(text), words(value)
    {
    }
    Attribute(const std::string &called, double value) : name(called), type(real), of{value} {}
    std::string name;
    Type type;
    std::string words;         // value if the type is text
    std::vector<double> of;    // values if the type is any other
    bool changes = false;      // true if the number may change when a run is continued
  };
  using Attributes = std::vector<Attribute>;
  struct Variable {
    std::string name;
    std::vector<int>
        dimensions;    // indices of the dimensions; 0, the record dimension, comes first if there
                       // is a value per record
    Type type = real;
    Attributes attributes;
    std::string words;         // values of a fixed variable of type text
    std::vector<double> of;    // values of a fixed variable of any other type
    double blank = 0.0;        // value stored in empty cells of a record
    // set by layout()
    size_t size = 1;    // number of values in a record or, if the variable is fixed, in the file
    size_t at = 0;      // position in bytes from the start of the record or of the file
    bool in_record() const { return !dimensions.empty() && dimensions[0] == 0; }
  };

  // Adds an attribute unless the list has one of that name.
  static void add_new(Attributes &, const Attribute &);

  // The functions below return the index of the new item. The record dimension comes first and has
  // length 0.
  NetcdfHeader();
  int dimension(const std::string &name, size_t length);
  int variable(const Variable &);
  void add(const Attribute &a) { attributes_.push_back(a); }

  void layout();                         // must be called after the last variable
  void sum(std::string &bytes) const;    // writes the checksum to a copy of bytes()
  void sum(unsigned char *record, size_t number) const;
  const Variable &variable(int k) const { return variables_[k]; }
  const std::string &bytes() const { return bytes_; }    // includes fixed values, but no records
  size_t record_bytes() const { return record_bytes_; }
  std::vector<unsigned char> blank_record() const;
  // Positions of the attributes that may change. Each occupies 8 bytes.
  const std::vector<size_t> &changing() const { return changing_; }
  static constexpr size_t count_at = 4;    // position of the number of records (4 bytes)

 private:
  struct Dimension {
    std::string name;
    size_t length;
  };
  std::string written(size_t records_at);
  size_t sum_at() const;    // position of the digits of the checksum in bytes_

  std::vector<Dimension> dimensions_;
  Attributes attributes_;
  std::vector<Variable> variables_;
  std::string bytes_;
  std::vector<size_t> changing_;
  size_t record_bytes_ = 0;
};

// Write values in the byte order and with the width used in the file.
inline void put_real(unsigned char *to, double value)
{
  uint64_t b;
  memcpy(&b, &value, 8);
  b = __builtin_bswap64(b);
  memcpy(to, &b, 8);
}
inline void put_single(unsigned char *to, double value)
{
  const float x = static_cast<float>(value);
  uint32_t b;
  memcpy(&b, &x, 4);
  b = __builtin_bswap32(b);
  memcpy(to, &b, 4);
}
void put_netcdf(unsigned char *to, NetcdfHeader::Type, const double *values, size_t n);

}    // namespace bearing
