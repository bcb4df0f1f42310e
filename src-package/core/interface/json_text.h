// SPDX-License-Identifier: GPL-2.0-or-later
// Builds the text of a JSON file piece by piece. The texts of the tables contain no quotes,
// backslashes or control characters.
#pragma once

#include <cstdarg>
#include <cstdio>
#include <string>

struct JsonText {
  std::string text;

  // Appends text that is formatted as by printf.
  __attribute__((format(printf, 2, 3))) void add(const char *format, ...)
  {
    va_list all, again;
    va_start(all, format);
    va_copy(again, all);
    std::string piece(std::vsnprintf(nullptr, 0, format, all) + 1, '\0');
    std::vsnprintf(&piece[0], piece.size(), format, again);
    va_end(again);
    va_end(all);
    piece.pop_back();
    text += piece;
  }
};
