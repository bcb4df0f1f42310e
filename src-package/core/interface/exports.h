// SPDX-License-Identifier: GPL-2.0-or-later
// Defines the C interface of a library and a description of it for Python
// (raceway/core/exports.py). The description is generated from the source of the library. It
// contains the names of the parameters of every EXPORT and FORMULA, and the names and sizes of the
// fields of every RECORD. Python passes arguments by name, so their positions never have to be
// repeated there.
#pragma once
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>

// this is hidden so that two libraries in one process have separate texts
__attribute__((visibility("hidden"))) inline std::string &exported_text()
{
  static std::string text;
  return text;
}

struct ExportedLine {
  explicit ExportedLine(const std::string &line) { exported_text() += line + "\n"; }
};

// Declares a C function. The size of an array is stated, as in `double out[3]`, if it does not
// depend on the call.
#define EXPORT(result, name, parameters)                                                    \
  extern "C" result name parameters;                                                        \
  static const ExportedLine exported_##name("function|" #result "|" #name "|" #parameters); \
  extern "C" result name parameters

// Declares a struct of doubles and vectors of doubles, e.g. RECORD(Motion, double x[3], v[3];)
#define RECORD(Name, ...)                                                                        \
  struct Name {                                                                                  \
    __VA_ARGS__                                                                                  \
  };                                                                                             \
  static const ExportedLine exported_##Name("record|" #Name "|" + std::to_string(sizeof(Name)) + \
                                            "|" #__VA_ARGS__);

// Declares a scalar function that Python calls with arrays. It returns a double or a RECORD of
// doubles; its parameters are double, int or bool.
#define FORMULA(result, name, parameters)                                                  \
  static result name##_of_one parameters;                                                  \
  extern "C" void name(long n, const double *in, double *out)                              \
  {                                                                                        \
    formula_over_arrays(&name##_of_one, n, in, out);                                       \
  }                                                                                        \
  static const ExportedLine exported_##name("formula|" #result "|" #name "|" #parameters); \
  static result name##_of_one parameters

template <class Result, class... Numbers, std::size_t... k>
void formula_at(Result (*one)(Numbers...), long n, long i, const double *in, double *out,
                std::index_sequence<k...>)
{
  static_assert(std::is_trivially_copyable<Result>::value && sizeof(Result) % sizeof(double) == 0,
                "a formula returns a double or a RECORD of doubles");
  constexpr long outputs = sizeof(Result) / sizeof(double);
  const Result found = one(static_cast<Numbers>(in[long(k) * n + i])...);
  double numbers[outputs];
  std::memcpy(numbers, &found, sizeof found);
  for (long j = 0; j < outputs; ++j) out[j * n + i] = numbers[j];
}

// Parameter k of call i is in[k n + i], and value j of the result of call i is out[j n + i].
template <class Result, class... Numbers>
void formula_over_arrays(Result (*one)(Numbers...), long n, const double *in, double *out)
{
  for (long i = 0; i < n; ++i)
    formula_at(one, n, i, in, out, std::index_sequence_for<Numbers...>());
}

// must be used exactly once per library
#define EXPORTS \
  extern "C" const char *exports() { return exported_text().c_str(); }
