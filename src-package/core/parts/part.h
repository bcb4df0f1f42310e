// SPDX-License-Identifier: GPL-2.0-or-later
// A part of the contact law: a struct with
//
//   name         one word, for tables and messages
//   when         always, with a film, or only on request by a keyword
//   slot         parts with the same slot exclude each other; "" for none
//   needs_film   true if it has no meaning without a film
//   needs        name of another required part; "" for none
//   Parameters   its own numbers, with their defaults; prepare(raceway) where it derives some, and
//                reach(raceway), the gap (m) at which its contacts begin, where that is not 0
//   keywords()   the words that set them, with unit and range (Keyword below)
//   states       how many numbers a contact keeps for it from step to step
//   couples      true if it sets couple_n, couple_t, couple_w
//   explicit_step   true if an implicit step cannot take it
//   columns()    what of it can be read from a contact
//   misses()     tells that there is no contact although the overlap is above -reach; writes what
//                beyond() and act() take from it
//   beyond()     overlap past the place where the load begins, m; a part has it that has misses()
//   act()        what it does to a contact: reads motions and what earlier parts left, writes its
//                own
//   Losses       the losses that it makes (loss.h): power that it takes out of the motion
//   energy()     what it stores, J
//
// PartBase has the defaults. docs/extend says how to add a part.
#ifndef RACEWAY_PART_H
#define RACEWAY_PART_H

#include "../numbers/column.h"
#include "../raceway/contact_state.h"
#include "../raceway/raceway.h"
#include "loss.h"

#include <vector>

namespace raceway {

enum class When { always, with_film, asked };

// One value of a keyword: a number that lies somewhere in the raceway or in the part's own
// Parameters, or a word out of several. `unset` says in words what holds without it, where that is
// no number.
template <class Own> struct Parameter {
  using Number = double &(*)(Raceway &, Own &);
  using Choose = void (*)(Raceway &, Own &, int);

  const char *symbol;     // in the list of what may follow, "MU"
  const char *meaning;    // with its unit, for messages and tables
  double least, most;
  bool open;              // `least` itself is not allowed
  const char *choices;    // "a|b|c", the first is the default; or null
  Number number;
  Choose choose;
  const char *unset;

  static Parameter positive(const char *symbol, const char *meaning, Number at,
                            const char *unset = nullptr)
  {
    return {symbol, meaning, 0.0, HUGE_VAL, true, nullptr, at, nullptr, unset};
  }
  static Parameter non_negative(const char *symbol, const char *meaning, Number at,
                                const char *unset = nullptr)
  {
    return {symbol, meaning, 0.0, HUGE_VAL, false, nullptr, at, nullptr, unset};
  }
  static Parameter within(const char *symbol, const char *meaning, double least, double most,
                          Number at, const char *unset = nullptr)
  {
    return {symbol, meaning, least, most, false, nullptr, at, nullptr, unset};
  }
  static Parameter one_of(const char *meaning, const char *choices, Choose choose,
                          const char *unset = nullptr)
  {
    return {choices, meaning, 0.0, 0.0, false, choices, nullptr, choose, unset};
  }
};

// A keyword of pair_style and pair_coeff. `form` is the word that must follow it, "" for none; a
// keyword that `chooses` switches its part on.
template <class Own> struct Keyword {
  const char *name, *form;
  bool chooses;
  std::vector<Parameter<Own>> parameters;
  const char *(*wrong)(const double *values) = nullptr;    // what is wrong with them together
  const char *note = "";                                   // for the page of the command
};

// An output column that the state of a contact gives.
struct StateColumn {
  Column is;
  double (*value)(const Raceway &, const ContactState &);
  Needs needs = Needs::nothing;
  bool usual = true;    // part of a record unless more is asked for
};

// The numbers that a contact keeps: before and at the end of a time dt. dt = 0 changes nothing.
// What decays at the rate r: exact, e^-(r dt), under motions that are constant over dt; in a stage
// of an implicit method by 1/(1 + r dt), as backward Euler has it. The order of the method rests on
// that.
template <class T> struct LawStates {
  double dt = 0.0;
  const Value<T> *before = nullptr;
  T *after = nullptr;
  bool stage = false;
};

struct PartBase {
  static constexpr When when = When::asked;
  static constexpr const char *slot = "", *needs = "";
  static constexpr int states = 0;
  static constexpr bool couples = false, explicit_step = false, needs_film = false;
  struct Parameters {};
  using Losses = LossList<>;
  static std::vector<Keyword<Parameters>> keywords() { return {}; }
  static std::vector<StateColumn> columns() { return {}; }
  template <class Own, class T>
  static RACEWAY_INLINE Value<T> energy(const Own &, const Raceway &, const ContactStateT<T> &)
  {
    return Value<T>();
  }
};

}    // namespace raceway

#endif
