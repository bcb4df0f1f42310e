// SPDX-License-Identifier: GPL-2.0-or-later
#include "restart_sum.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>

namespace bearing {

namespace {

const std::string mark = "bearing/checkpoint CRC-32 ";
constexpr size_t digits = 8;

uint32_t crc32(const std::string &bytes)
{
  static const std::array<uint32_t, 256> table = []() {
    std::array<uint32_t, 256> t{};
    for (uint32_t n = 0; n < 256; ++n) {
      uint32_t c = n;
      for (int k = 0; k < 8; ++k) c = c & 1 ? 0xedb88320u ^ (c >> 1) : c >> 1;
      t[n] = c;
    }
    return t;
  }();
  uint32_t c = 0xffffffffu;
  for (const char b : bytes) c = table[(c ^ static_cast<unsigned char>(b)) & 0xff] ^ (c >> 8);
  return c ^ 0xffffffffu;
}

// The file with zeros instead of the sum, and the position of the sum; npos: none.
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
    if (at == std::string::npos || at + mark.size() + digits > bytes.size()) return;
    place = at + mark.size();
    sum = bytes.substr(place, digits);
    bytes.replace(place, digits, digits, '0');
  }

  std::string right_sum() const
  {
    char text[digits + 1];
    snprintf(text, sizeof text, "%08x", static_cast<unsigned>(crc32(bytes)));
    return text;
  }
};

}    // namespace

std::string empty_sum() { return mark + std::string(digits, '0'); }

bool write_sum(const std::string &file)
{
  const Content content(file);
  if (content.place == std::string::npos) return false;
  std::fstream out(file, std::ios::binary | std::ios::in | std::ios::out);
  out.seekp(static_cast<std::streamoff>(content.place));
  out << content.right_sum() << std::flush;
  return out.good();
}

Sum check_sum(const std::string &file)
{
  const Content content(file);
  if (!content.read) return Sum::unreadable;
  if (content.place == std::string::npos) return Sum::none;
  return content.sum == content.right_sum() ? Sum::right : Sum::wrong;
}

}    // namespace bearing
