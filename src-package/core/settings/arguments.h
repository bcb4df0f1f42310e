// SPDX-License-Identifier: GPL-2.0-or-later
// Reads the words of one command. Every mistake is reported before the run starts, on all ranks, as
// an error that states the command, the value and the allowed range.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace bearing {

// Functions of the host that are needed to read a command. They are declared without the host's
// headers (arguments_host.cpp). They are collective, so they must be called on all ranks.
[[noreturn]] void stop_run(LAMMPS_NS::LAMMPS *, const std::string &why);    // with an error message
bool is_first_rank(LAMMPS_NS::LAMMPS *);
std::string of_first_rank(LAMMPS_NS::LAMMPS *, const std::string &);    // returns the string of the
                                                                        // first rank on all ranks
std::optional<std::string> host_variable(LAMMPS_NS::LAMMPS *, const std::string &name);

// Returns a number as a user would write it ("6.3e-3"), for use in messages.
std::string text(double value);

// `vars K ...` at the end of a command stands for `K VALUE` for every K that is a variable of the
// host and is accepted by the command (core/settings/deck_variable_table.h).
class Arguments {
 public:
  Arguments(LAMMPS_NS::LAMMPS *lmp, const std::string &command, int narg, char **arg, int first);
  Arguments(LAMMPS_NS::LAMMPS *lmp, const std::string &command,
            const std::vector<std::string> &words);

  const std::string &command() const { return command_; }
  bool more() const { return next_ < words_.size(); }
  size_t left() const { return words_.size() - next_; }
  bool take(const char *keyword);    // true if `keyword` is the next word, which is then consumed
  bool next_is_number() const;
  const std::string &next() const { return words_[next_]; }    // the word is not consumed and must
                                                               // exist
  std::vector<std::string> rest() const { return {words_.begin() + next_, words_.end()}; }
  std::string word(const std::string &what);    // next word; it is an error if there is none
  double number(const std::string &what);
  double number_in(const std::string &word, const std::string &what) const;    // value of a word
  double positive(const std::string &what);                                    // > 0
  double non_negative(const std::string &what);                                // >= 0
  double within(const std::string &what, double lo, double hi);
  int integer(const std::string &what, int lo, int hi);
  // Reads the value of a deck variable, which must be within the range stated in the table of
  // variables.
  std::string value_of(const char *variable);
  double number_of(const char *variable);
  int choice(const std::string &what, const std::vector<std::string> &allowed);
  // Options: each of these reads `keyword` and its value if that keyword is the next word, and
  // returns whether it is.
  bool word(const char *keyword, std::string &to, const std::string &what)
  {
    return take(keyword) && set(to, word(what));
  }
  bool number(const char *keyword, double &to, const std::string &what)
  {
    return take(keyword) && set(to, number(what));
  }
  bool positive(const char *keyword, double &to, const std::string &what)
  {
    return take(keyword) && set(to, positive(what));
  }
  bool non_negative(const char *keyword, double &to, const std::string &what)
  {
    return take(keyword) && set(to, non_negative(what));
  }
  bool within(const char *keyword, double &to, const std::string &what, double lo, double hi)
  {
    return take(keyword) && set(to, within(what, lo, hi));
  }
  bool integer(const char *keyword, int &to, const std::string &what, int lo, int hi)
  {
    return take(keyword) && set(to, integer(what, lo, hi));
  }
  bool yes(const char *keyword, bool &to)    // `keyword yes` or `keyword no`
  {
    return take(keyword) && set(to, choice(keyword, {"no", "yes"}) == 1);
  }
  bool variable(const char *name, double &to) { return take(name) && set(to, number_of(name)); }
  bool variable(const char *name, int &to)
  {
    return take(name) && set(to, static_cast<int>(number_of(name)));
  }
  bool variable(const char *name, std::string &to) { return take(name) && set(to, value_of(name)); }
  // Reads any of the variables that belong to `of` in the table of variables.
  bool variable_of(const std::string &of, std::map<std::string, std::string> &to);
  void skip_rest() { next_ = words_.size(); }
  // Stops with an error: the next word is none of the keywords that take() has looked for there, or
  // none of the `allowed` ones.
  [[noreturn]] void unknown() { unknown(asked_); }
  [[noreturn]] void unknown(const std::string &allowed);
  [[noreturn]] void fail(const std::string &why) const;
  // Returns the text of a file on all ranks, or no value if the file is unreadable. Only rank 0
  // reads the file.
  std::optional<std::string> content(const std::string &file) const;

 private:
  LAMMPS_NS::LAMMPS *lmp_;
  std::string command_;
  std::vector<std::string> words_;
  size_t next_ = 0;
  std::string asked_;      // keywords that take() has looked for at one word, "a, b, c"
  size_t asked_at_ = 0;    // index of that word

  void take_variables();
  template <class T> static bool set(T &to, const T &value)
  {
    to = value;
    return true;
  }
};

}    // namespace bearing
