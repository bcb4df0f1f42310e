// SPDX-License-Identifier: GPL-2.0-or-later
// What a test library offers, described to Python (exports.py) in the words of its own source: the
// parameters of every EXPORT by name, the fields of every RECORD by name and size. So nothing is
// passed by a position that the other side only believes in.
#ifndef RACEWAY_TESTS_EXPORTS_H
#define RACEWAY_TESTS_EXPORTS_H
#include <string>

// hidden: two test libraries in one process keep their own texts
__attribute__((visibility("hidden"))) inline std::string &exported_text()
{
  static std::string text;
  return text;
}

struct ExportedLine {
  explicit ExportedLine(const std::string &line) { exported_text() += line + "\n"; }
};

// A C function. Arrays say their size, `double out[3]`, where it does not depend on the call.
#define EXPORT(result, name, parameters)                                                    \
  extern "C" result name parameters;                                                        \
  static const ExportedLine exported_##name("function|" #result "|" #name "|" #parameters); \
  extern "C" result name parameters

// A struct of doubles and vectors of them: RECORD(Motion, double x[3], v[3];)
#define RECORD(Name, ...)                                                                        \
  struct Name {                                                                                  \
    __VA_ARGS__                                                                                  \
  };                                                                                             \
  static const ExportedLine exported_##Name("record|" #Name "|" + std::to_string(sizeof(Name)) + \
                                            "|" #__VA_ARGS__);

// once in a library
#define EXPORTS \
  extern "C" const char *exports() { return exported_text().c_str(); }
#endif
