// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers and words by name, for laws that derive some of them from others. Numbers are stored as
// text of fifteen digits, as the hosts write the value of a formula.
#ifndef BEARING_DATA_VALUES_H
#define BEARING_DATA_VALUES_H

#include "../core/settings/arguments.h"
#include "bearing_compat.h"

#include <map>
#include <optional>

namespace bearing {

class DataValues : protected LAMMPS_NS::Pointers {
 public:
  typedef std::map<std::string, std::string> Map;

  // From a map; `whose` names its owner in messages: "'6208' of 'inputs/bearings'".
  DataValues(LAMMPS_NS::LAMMPS *lmp, const Arguments &args, Map &map, const std::string &whose) :
      Pointers(lmp), args_(args), map_(&map), whose_(whose)
  {
  }
  virtual ~DataValues() = default;

  static std::string written(double value)
  {
    char buf[32];
    snprintf(buf, sizeof buf, "%.15g", value);
    return buf;
  }

  bool there(const std::string &name) const { return find(name).has_value(); }
  std::string word(const std::string &name) const
  {
    const std::optional<std::string> value = find(name);
    if (!value) args_.fail(whose_ + " has no variable " + name + " that is one number");
    return *value;
  }
  double number(const std::string &name) const { return args_.number_in(word(name), name); }
  // Stops the run unless the number is 0; the message gives the reason.
  void zero(const std::string &name, const std::string &why) const
  {
    if (number(name) != 0.0)
      fail(name + " is " + text(number(name)) + ", must be from 0 to 0 (" + why + ")");
  }
  // Sets a value unless one of that name exists.
  void suggest(const std::string &name, const std::string &value)
  {
    if (!there(name)) make(name, "index", value);
  }
  void suggest(const std::string &name, double value) { suggest(name, written(value)); }
  void set(const std::string &name, double value) { make(name, "equal", written(value)); }
  void set(const std::string &name, std::string words) { make(name, "string", words); }
  [[noreturn]] void fail(const std::string &why) const { args_.fail(why); }

 protected:
  // Values of the host's variables
  DataValues(LAMMPS_NS::LAMMPS *lmp, const Arguments &args) :
      Pointers(lmp), args_(args), whose_("the deck")
  {
  }
  virtual std::optional<std::string> find(const std::string &name) const
  {
    const auto at = map_->find(name);
    return at == map_->end() ? std::nullopt : std::optional<std::string>(at->second);
  }
  virtual void make(const std::string &name, const std::string &, const std::string &value)
  {
    (*map_)[name] = value;
  }

  const Arguments &args_;

 private:
  Map *map_ = nullptr;
  std::string whose_;
};

}    // namespace bearing

#endif
