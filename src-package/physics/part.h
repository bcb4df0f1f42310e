// SPDX-License-Identifier: GPL-2.0-or-later
// What a part of the contact law says of itself. A part is a struct with
//
//   name         one word, for tables and messages
//   when         always, with a film, or only when a keyword asks for it
//   slot         parts with the same slot exclude each other; "" for none
//   Parameters   its own numbers, with their defaults; prepare(raceway) where it derives some, and
//                reach(raceway), the gap (m) at which its contacts begin, where that is not 0
//   keywords()   the words that set them, with unit and range (Keyword below)
//   states       how many numbers a contact keeps for it from step to step
//   couples      true if it sets couple_n, couple_t, couple_w
//   explicit_step   true if an implicit step cannot take it
//   columns()    what of it can be read from a contact
//   act()        what it does to a contact: reads motions and what earlier parts left, writes its
//   own loss()       the power that it takes out of the motion, W
//
// PartBase has the defaults. docs/extend says how to add a part.
#ifndef RACEWAY_PART_H
#define RACEWAY_PART_H

#include "column.h"
#include "contact_state.h"
#include "raceway.h"

#include <vector>

namespace raceway {

enum class When { always, with_film, asked };

// One value of a keyword.
struct Parameter {
  const char *symbol;     // in the list of what may follow, "MU"
  const char *meaning;    // with its unit, for messages and tables
  double least, most;
  bool open;              // `least` itself is not allowed
  const char *choices;    // "a|b|c": a word instead of a number, its place is the value; or null
};

inline Parameter positive(const char *symbol, const char *meaning)
{
  return {symbol, meaning, 0.0, HUGE_VAL, true, nullptr};
}
inline Parameter non_negative(const char *symbol, const char *meaning)
{
  return {symbol, meaning, 0.0, HUGE_VAL, false, nullptr};
}
inline Parameter within(const char *symbol, const char *meaning, double least, double most)
{
  return {symbol, meaning, least, most, false, nullptr};
}
inline Parameter one_of(const char *meaning, const char *choices)
{
  return {choices, meaning, 0.0, 0.0, false, choices};
}

// A keyword of pair_style and pair_coeff. `form` is the word that must follow it, "" for none; a
// keyword that `chooses` switches its part on.
template <class Own> struct Keyword {
  const char *name, *form;
  bool chooses;
  std::vector<Parameter> parameters;
  void (*set)(Raceway &, Own &, const double *values);
  const char *(*wrong)(const double *values) = nullptr;    // what is wrong with them together
};

// An output column that the state of a contact gives.
struct StateColumn {
  Column is;
  double (*value)(const Raceway &, const ContactState &);
  Needs needs = Needs::nothing;
  bool usual = true;    // part of a record unless more is asked for
};

// The numbers that a contact keeps: before and at the end of a time dt. dt = 0 changes nothing.
template <class T> struct LawStates {
  double dt = 0.0;
  const Value<T> *before = nullptr;
  T *after = nullptr;
};

struct PartBase {
  static constexpr When when = When::asked;
  static constexpr const char *slot = "";
  static constexpr int states = 0;
  static constexpr bool couples = false, explicit_step = false;
  struct Parameters {};
  static std::vector<Keyword<Parameters>> keywords() { return {}; }
  static std::vector<StateColumn> columns() { return {}; }
  template <class T> static RACEWAY_INLINE Value<T> loss(const ContactStateT<T> &)
  {
    return Value<T>();
  }
};

}    // namespace raceway

#endif
