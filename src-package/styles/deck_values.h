// SPDX-License-Identifier: GPL-2.0-or-later
// Variables of the deck, for commands that derive some of them from others.
#ifndef BEARING_DECK_VALUES_H
#define BEARING_DECK_VALUES_H

#include "../deck/variable_table.h"

namespace bearing {

class DeckValues : protected LAMMPS_NS::Pointers {
 public:
  DeckValues(LAMMPS_NS::LAMMPS *lmp, const Arguments &args) : Pointers(lmp), args_(args) {}

  // Text of a value as the host writes that of a formula
  static std::string written(double value)
  {
    char buf[32];
    snprintf(buf, sizeof buf, "%.15g", value);
    return buf;
  }

  bool there(const std::string &name) const { return input->variable->find(letters(name)) >= 0; }
  std::string word(const std::string &name) const
  {
    const char *value = there(name) ? input->variable->retrieve(letters(name)) : nullptr;
    if (!value) args_.fail("the deck has no variable " + name + " that is one number");
    return value;
  }
  double number(const std::string &name) const { return args_.number_in(word(name), name); }
  // Value with all digits; word() has fifteen
  double formula(const std::string &name) const
  {
    const int k = input->variable->find(letters(name));
    return k >= 0 && input->variable->equalstyle(k) ? input->variable->compute_equal(k)
                                                    : number(name);
  }
  // Stops the run unless the value is in the range; syntax as in bearing_range.
  void range(const std::string &label, const std::string &value,
             const std::vector<std::string> &range) const
  {
    Arguments words(lmp, "bearing_derive", range);
    check_range(words, label, value);
  }
  // Sets an index variable unless a variable of that name exists.
  void suggest(const std::string &name, const std::string &value)
  {
    if (!there(name)) make(name, "index", value);
  }
  void suggest(const std::string &name, double value) { suggest(name, written(value)); }
  void set(const std::string &name, double value) { make(name, "equal", written(value)); }
  void set(const std::string &name, std::string words) { make(name, "string", words); }
  [[noreturn]] void fail(const std::string &why) const { args_.fail(why); }

 private:
  const Arguments &args_;

  static char *letters(const std::string &name) { return const_cast<char *>(name.c_str()); }
  void make(const std::string &name, const std::string &style, const std::string &value)
  {
    char *words[] = {letters(name), letters(style), letters(value)};
    input->variable->set(3, words);
  }
};

}    // namespace bearing

#endif
