// SPDX-License-Identifier: GPL-2.0-or-later
// Variables of the deck, for commands that derive some of them from others.
#ifndef BEARING_DECK_VALUES_H
#define BEARING_DECK_VALUES_H

#include "../deck/data_values.h"

namespace bearing {

class DeckValues : public DataValues {
 public:
  DeckValues(LAMMPS_NS::LAMMPS *lmp, const Arguments &args) : DataValues(lmp, args) {}

  // Value with all digits; word() has fifteen
  double formula(const std::string &name) const
  {
    const int k = input->variable->find(letters(name));
    return k >= 0 && input->variable->equalstyle(k) ? input->variable->compute_equal(k)
                                                    : number(name);
  }

 private:
  static char *letters(const std::string &name) { return const_cast<char *>(name.c_str()); }
  std::optional<std::string> find(const std::string &name) const override
  {
    if (input->variable->find(letters(name)) < 0) return std::nullopt;
    const char *value = input->variable->retrieve(letters(name));
    if (!value) args_.fail("the deck has no variable " + name + " that is one number");
    return value;
  }
  void make(const std::string &name, const std::string &style, const std::string &value) override
  {
    char *words[] = {letters(name), letters(style), letters(value)};
    input->variable->set(3, words);
  }
};

}    // namespace bearing

#endif
