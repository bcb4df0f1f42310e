// SPDX-License-Identifier: GPL-2.0-or-later
// The state of an object as a list of doubles, for restart files and for messages between ranks. A
// class names its values once, in a function that is called with a NumberWriter or a NumberReader.
#pragma once

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace bearing {

class NumberWriter {
 public:
  // Values are integers, structs of doubles, or vectors of these, whose lengths are not written.
  template <class... T> void operator()(const T &...values) { (put(values), ...); }
  const std::vector<double> &numbers() const { return numbers_; }
  int copy_to(double *buf) const
  {
    std::copy(numbers_.begin(), numbers_.end(), buf);
    return static_cast<int>(numbers_.size());
  }
  // Writes the numbers and a text in the form in which the hosts store the data of a fix.
  void write(FILE *fp, const std::string &words = "") const
  {
    const size_t bytes = numbers_.size() * sizeof(double);
    const int size = static_cast<int>(bytes + words.size());
    fwrite(&size, sizeof size, 1, fp);
    fwrite(numbers_.data(), 1, bytes, fp);
    fwrite(words.data(), 1, words.size(), fp);
  }

 private:
  template <class T> void put(const T &value)
  {
    static_assert(std::is_integral<T>::value || sizeof(T) % sizeof(double) == 0, "doubles only");
    if constexpr (std::is_integral<T>::value) {
      numbers_.push_back(static_cast<double>(value));
    } else {
      const auto *const from = reinterpret_cast<const double *>(&value);
      numbers_.insert(numbers_.end(), from, from + sizeof value / sizeof(double));
    }
  }
  template <class T> void put(const std::vector<T> &list)
  {
    for (const T &value : list) put(value);
  }

  std::vector<double> numbers_;
};

class NumberReader {
 public:
  explicit NumberReader(const void *from) : from_(static_cast<const char *>(from)), at_(from_) {}
  template <class... T> void operator()(T &...values) { (take(values), ...); }
  int count() const { return static_cast<int>((at_ - from_) / sizeof(double)); }    // numbers read
  const char *rest() const { return at_; }    // what follows them

 private:
  template <class T> void take(T &value)
  {
    if constexpr (std::is_integral<T>::value) {
      double number;
      take(number);
      value = static_cast<T>(number);
    } else {
      memcpy(static_cast<void *>(&value), at_, sizeof value);
      at_ += sizeof value;
    }
  }
  template <class T> void take(std::vector<T> &list)
  {
    for (T &value : list) take(value);
  }

  const char *from_, *at_;
};

}    // namespace bearing
