// SPDX-License-Identifier: GPL-2.0-or-later
#include "restart_sum.h"

#include "../numbers/checksum.h"

#include <cstdio>
#include <fstream>
#include <iterator>

namespace bearing {

namespace {

const std::string mark = "bearing/checkpoint sum ";
constexpr size_t hex_digits = 8;

// The content of the file with zeros in place of the sum, and the position of the sum, which is
// npos if the file contains none.
struct Content {
  std::string bytes, sum;
  size_t place = std::string::npos;
  bool read = false;

  explicit Content(const std::string &file)
  {
    std::ifstream in(file, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    read = in.good() || in.eof();
    const size_t at = bytes.find(mark);
    if (at == std::string::npos || at + mark.size() + hex_digits > bytes.size()) return;
    place = at + mark.size();
    sum = bytes.substr(place, hex_digits);
    bytes.replace(place, hex_digits, hex_digits, '0');
  }

  std::string right_sum() const
  {
    char text[hex_digits + 1];
    snprintf(text, sizeof text, "%08x",
             static_cast<unsigned>(checksum(bytes.data(), bytes.size())));
    return text;
  }
};

}    // namespace

std::string empty_sum() { return mark + std::string(hex_digits, '0'); }

bool write_sum(const std::string &file)
{
  const Content content(file);
  if (content.place == std::string::npos) return false;
  std::fstream out(file, std::ios::binary | std::ios::in | std::ios::out);
  out.seekp(static_cast<std::streamoff>(content.place));
  out << content.right_sum() << std::flush;
  return out.good();
}

bool has_right_sum(const std::string &file)
{
  const Content content(file);
  return content.read && content.place != std::string::npos && content.sum == content.right_sum();
}

}    // namespace bearing
