// SPDX-License-Identifier: GPL-2.0-or-later
// A part of the contact law is a struct with the following members:
//
//   name         one word, for tables and messages
//   when         always, with a film, or only on request by a keyword
//   slot         parts with the same slot exclude each other; "" for none
//   needs_film   true if the part requires a film
//   needs        name of another required part; "" for none
//   Parameters   its parameters with their defaults; has a function prepare(raceway) if some of
//                them are computed, and reach(raceway) if the gap (m) at which its contacts begin
//                is not 0
//   keywords()   the keywords that set its Parameters, with unit and range (Keyword below)
//   states       number of state variables per contact that are kept between steps
//   couples      true if it sets couple_n, couple_t, couple_w
//   explicit_step   true if it is not available in an implicit step
//   columns()    output columns of a contact
//   misses()     true if there is no contact although the overlap exceeds -reach; sets the input
//                for beyond() and act()
//   beyond()     overlap beyond the onset of the load, m; required with misses()
//   act()        its effect on a contact: reads motions and results of earlier parts and writes
//                its own results
//   Losses       its losses (loss.h): power taken from the motion
//   energy()     stored energy, J
//
// PartBase defines the defaults. docs/extend explains how to add a part.
#pragma once

#include "../numbers/column.h"
#include "../raceway/contact_state.h"
#include "../raceway/raceway.h"
#include "loss.h"

#include <vector>

namespace raceway {

enum class When { always, with_film, asked };

// One value of a keyword. It is a number that is stored in the raceway or in the part's Parameters,
// or one of several words. `unset` describes a default that is not a number.
template <class Own> struct Parameter {
  using Number = double &(*)(Raceway &, Own &);
  using Choose = void (*)(Raceway &, Own &, int);

  const char *symbol;     // symbol in lists of allowed words, "MU"
  const char *meaning;    // meaning with the unit, for messages and tables
  double least, most;
  bool open;              // `least` itself is not allowed
  const char *choices;    // "a|b|c", where the first is the default, or null
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
// keyword with `chooses` enables its part.
template <class Own> struct Keyword {
  const char *name, *form;
  bool chooses;
  std::vector<Parameter<Own>> parameters;
  const char *(*wrong)(const double *values) = nullptr;    // returns the error in a combination of
                                                           // values, or null
  const char *note = "";                                   // text for the command's documentation
};

// The value of a column: a member of the contact's state, which is read without a call, or a
// function of it.
class StateValue {
 public:
  StateValue(double ContactState::*member = nullptr) : member_(member) {}
  template <class F> StateValue(F of, decltype(+of) = nullptr) : of_(of) {}
  double operator()(const Raceway &p, const ContactState &s) const
  {
    return member_ ? s.*member_ : of_(p, s);
  }

 private:
  double ContactState::*member_ = nullptr;
  double (*of_)(const Raceway &, const ContactState &) = nullptr;
};

// An output column that is computed from the state of a contact.
struct StateColumn {
  Column is;
  StateValue value;
  Needs needs = Needs::nothing;
  bool usual = true;    // included in records by default
};

// State variables of a contact before and after a time dt; if dt = 0, they do not change. For
// motions that are constant over dt, decay at the rate r is exact, e^-(r dt). In a stage of an
// implicit method the factor is 1/(1 + r dt), as in backward Euler, because the order of the method
// depends on it.
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
