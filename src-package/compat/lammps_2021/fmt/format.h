// SPDX-License-Identifier: GPL-2.0-or-later
// Debian's liblammps-dev of 29Sep2021 does not contain fmt, which its headers include. Declarations
// are sufficient, because this package calls no LAMMPS function with an argument of an fmt type.
#ifndef BEARING_FMT_FORMAT_H
#define BEARING_FMT_FORMAT_H

#include <string>

namespace fmt {
class string_view {
 public:
  string_view(const char *);
  string_view(const std::string &);
};
class format_args {
 public:
  format_args();
};
template <class Text, class... Args> format_args make_args_checked(const Text &, Args &&...)
{
  return format_args();
}
template <class... Args> format_args make_format_args(Args &&...) { return format_args(); }
}    // namespace fmt

#endif
