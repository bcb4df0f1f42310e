// SPDX-License-Identifier: GPL-2.0-or-later
// Named numbers and words, for laws that derive some of the values from others. Numbers are stored
// as text with fifteen digits, as are the results of formulas in the hosts.
#pragma once

#include "../core/settings/arguments.h"
#include "../core/settings/written.h"

#include <map>

namespace bearing {

class DataValues {
 public:
  typedef std::map<std::string, std::string> Map;

  // Uses the values of `map`. In messages the data are described by `whose`, e.g. "'6208' of
  // 'inputs/bearings'".
  DataValues(const Arguments &args, Map &map, const std::string &whose) :
      args_(args), map_(map), whose_(whose)
  {
  }

  bool has(const std::string &name) const { return map_.count(name) > 0; }
  std::string word(const std::string &name) const
  {
    const auto at = map_.find(name);
    if (at == map_.end()) fail(whose_ + " has no variable " + name + " that is one number");
    return at->second;
  }
  double number(const std::string &name) const { return args_.number_in(word(name), name); }
  // Stops with an error unless the number is 0. The message gives the reason `why`.
  void zero(const std::string &name, const std::string &why) const
  {
    if (number(name) != 0.0) fail(name + " is " + text(number(name)) + ", must be 0 (" + why + ")");
  }
  // Sets a value unless there is already a value with that name.
  void suggest(const std::string &name, double value) { map_.emplace(name, digits(value)); }
  void set(const std::string &name, double value) { map_[name] = digits(value); }
  void set(const std::string &name, const std::string &words) { map_[name] = words; }
  [[noreturn]] void fail(const std::string &why) const { args_.fail(why); }

 private:
  const Arguments &args_;
  Map &map_;
  std::string whose_;
};

}    // namespace bearing
