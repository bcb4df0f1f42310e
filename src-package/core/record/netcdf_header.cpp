// SPDX-License-Identifier: GPL-2.0-or-later
#include "netcdf_header.h"

#include "../numbers/checksum.h"

#include <algorithm>
#include <cstdio>

namespace bearing {

namespace {

using Header = NetcdfHeader;

enum Tag { no_list = 0, dimension_list = 0x0A, variable_list = 0x0B, attribute_list = 0x0C };

size_t width(Header::Type t) { return t == Header::text ? 1 : t == Header::real ? 8 : 4; }

// Returns n rounded up, because every item of a header or record begins at a multiple of four
// bytes.
size_t padded(size_t n) { return (n + 3) / 4 * 4; }

size_t bytes_of(const Header::Variable &v) { return padded(v.size * width(v.type)); }

void add_4(std::string &s, size_t x)
{
  for (int shift = 24; shift >= 0; shift -= 8) s += static_cast<char>(x >> shift & 0xff);
}

void add_8(std::string &s, uint64_t x)
{
  add_4(s, x >> 32);
  add_4(s, x & 0xffffffff);
}

void add_padding(std::string &s, size_t written) { s.append(padded(written) - written, '\0'); }

void add_text(std::string &s, const std::string &text)
{
  s += text;
  add_padding(s, text.size());
}

void add_name(std::string &s, const std::string &name)
{
  add_4(s, name.size());
  add_text(s, name);
}

void add_numbers(std::string &s, Header::Type type, const std::vector<double> &values)
{
  std::string bytes(values.size() * width(type), '\0');
  put_netcdf(reinterpret_cast<unsigned char *>(&bytes[0]), type, values.data(), values.size());
  add_text(s, bytes);
}

void add_list(std::string &s, Tag tag, size_t n)
{
  add_4(s, n ? tag : no_list);
  add_4(s, n);
}

// Adds attributes to `s`. `changing` receives the positions of values that may change.
void add_attributes(std::string &s, const Header::Attributes &list, std::vector<size_t> &changing)
{
  add_list(s, attribute_list, list.size());
  for (const Header::Attribute &a : list) {
    add_name(s, a.name);
    add_4(s, a.type);
    if (a.type == Header::text) {
      add_name(s, a.words);
    } else {
      add_4(s, a.of.size());
      if (a.changes) changing.push_back(s.size());
      add_numbers(s, a.type, a.of);
    }
  }
}

}    // namespace

void put_netcdf(unsigned char *to, Header::Type type, const double *values, size_t n)
{
  for (size_t k = 0; k < n; ++k) {
    if (type == Header::real) {
      put_real(to + 8 * k, values[k]);
    } else if (type == Header::single) {
      put_single(to + 4 * k, values[k]);
    } else {
      const uint32_t b = __builtin_bswap32(static_cast<uint32_t>(static_cast<int32_t>(values[k])));
      memcpy(to + 4 * k, &b, 4);
    }
  }
}

static const std::string mark = "sum ", blank_sum = mark + "00000000 of 0000000000 header bytes";

NetcdfHeader::NetcdfHeader() { add({"checksum", blank_sum}); }

void NetcdfHeader::add_new(Attributes &list, const Attribute &one)
{
  if (std::none_of(list.begin(), list.end(), [&](const auto &a) { return a.name == one.name; }))
    list.push_back(one);
}

int NetcdfHeader::dimension(const std::string &name, size_t length)
{
  dimensions_.push_back({name, length});
  return static_cast<int>(dimensions_.size()) - 1;
}

int NetcdfHeader::variable(const Variable &v)
{
  variables_.push_back(v);
  return static_cast<int>(variables_.size()) - 1;
}

void NetcdfHeader::layout()
{
  variable({"checksum",
            {0},
            integer,
            {{"units", "1"},
             {"long_name",
              "checksum of the sample's other values, see src-package/core/numbers/checksum.h"}},
            "",
            {}});
  record_bytes_ = 0;
  for (Variable &v : variables_) {
    v.size = 1;
    for (int d : v.dimensions)
      if (d != 0) v.size *= dimensions_[d].length;
    if (v.in_record()) record_bytes_ += bytes_of(v);
  }
  const size_t head = written(0).size();
  size_t fixed = head, record = 0;
  for (Variable &v : variables_) {
    size_t &at = v.in_record() ? record : fixed;
    v.at = at;
    at += bytes_of(v);
  }
  bytes_ = written(fixed);
  for (const Variable &v : variables_) {
    if (v.in_record()) continue;
    if (v.type == text) add_text(bytes_, v.words);
    else add_numbers(bytes_, v.type, v.of);
  }
  char length[11];
  snprintf(length, sizeof length, "%010zu", bytes_.size());
  bytes_.replace(sum_at() + 8 + strlen(" of "), 10, length);
  sum(bytes_);
}

size_t NetcdfHeader::sum_at() const { return bytes_.find(mark) + mark.size(); }

void NetcdfHeader::sum(std::string &bytes) const
{
  const size_t at = sum_at();
  const std::string count = bytes.substr(count_at, 4);
  bytes.replace(count_at, 4, 4, '\0').replace(at, 8, 8, '0');
  char digits[9];
  snprintf(digits, sizeof digits, "%08x",
           static_cast<unsigned>(checksum(bytes.data(), bytes.size())));
  bytes.replace(count_at, 4, count).replace(at, 8, digits);
}

void NetcdfHeader::sum(unsigned char *record, size_t number) const
{
  const size_t at = record_bytes_ - 4;
  const uint32_t sum = __builtin_bswap32(checksum(record, at, number));
  memcpy(record + at, &sum, 4);
}

std::vector<unsigned char> NetcdfHeader::blank_record() const
{
  std::vector<unsigned char> record(record_bytes_, 0);
  for (const Variable &v : variables_) {
    if (!v.in_record()) continue;
    const std::vector<double> cells(v.size, v.blank);
    put_netcdf(record.data() + v.at, v.type, cells.data(), cells.size());
  }
  return record;
}

std::string NetcdfHeader::written(size_t records_at)
{
  std::string s = "CDF\2";
  add_4(s, 0);    // number of records
  add_list(s, dimension_list, dimensions_.size());
  for (const Dimension &d : dimensions_) {
    add_name(s, d.name);
    add_4(s, d.length);
  }
  changing_.clear();
  add_attributes(s, attributes_, changing_);
  add_list(s, variable_list, variables_.size());
  for (const Variable &v : variables_) {
    add_name(s, v.name);
    add_4(s, v.dimensions.size());
    for (int d : v.dimensions) add_4(s, d);
    add_attributes(s, v.attributes, changing_);
    add_4(s, v.type);
    add_4(s, bytes_of(v));
    add_8(s, v.in_record() ? records_at + v.at : v.at);
  }
  return s;
}

}    // namespace bearing
