// SPDX-License-Identifier: GPL-2.0-or-later
#include "given_variables.h"

#include "../core/settings/data_table.h"
#include "../core/settings/written.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace fs = std::filesystem;

namespace bearing {

static std::vector<std::string> own_words;    // empty unless they have been set

// Returns the command line of the program. The host does not store a copy of it.
static std::vector<std::string> command_line()
{
  if (!own_words.empty()) return own_words;
  std::ifstream file("/proc/self/cmdline");
  std::vector<std::string> words;
  for (std::string word; std::getline(file, word, '\0');) words.push_back(word);
  return words;
}

Names words_after(const char *option, const char *other)
{
  Names found;
  const std::vector<std::string> words = command_line();
  for (size_t k = 0; k + 1 < words.size(); ++k)
    if (words[k] == option || words[k] == other) found.insert(words[k + 1]);
  return found;
}

// Returns the words of a command without its comment, including those on lines that are continued
// by `&`.
static std::vector<std::string> command_words(std::istream &file, std::string line)
{
  std::vector<std::string> words;
  do {
    std::istringstream in(line);
    for (std::string word; in >> word && word[0] != '#';) words.push_back(word);
    if (words.empty() || words.back() != "&") return words;
    words.pop_back();
  } while (std::getline(file, line));
  return words;
}

// Returns NAME if the word ends with ${NAME}, and an empty string otherwise.
static std::string named_in(const std::string &word)
{
  const size_t at = word.find("${");
  return at == std::string::npos || word.back() != '}' ? ""
                                                       : word.substr(at + 2, word.size() - at - 3);
}

// Collects the variables that are passed to a command under the names that they have in the table.
static void collect_passed(const std::vector<std::string> &words, Names &passed)
{
  std::string keyword;
  for (const std::string &word : words) {
    const std::string name = named_in(word);
    if (name.empty() && std::isalpha(static_cast<unsigned char>(word[0]))) keyword = word;
    if (name.empty()) continue;
    const bool style = word == "pass/${" + name + "}" || word == "bearing/${" + name + "}";
    if (style || name == keyword || name.compare(0, keyword.size() + 1, keyword + "_") == 0)
      passed.insert(name);
  }
}

bool collect(const fs::path &path, DeckNames &names)
{
  static const Names styles = {"index", "string", "loop", "uloop", "universe", "world"};
  std::ifstream file(path);
  if (!file) return false;
  for (std::string line; std::getline(file, line);) {
    const std::vector<std::string> words = command_words(file, line);
    if (words.size() > 2 && words[0] == "variable") {
      if (styles.count(words[2])) names.settable.insert(words[1]);
      if (words[2] == "index") names.index.insert(words[1]);
      continue;
    }
    const auto vars = std::find(words.begin(), words.end(), "vars");
    if (vars != words.end()) {
      names.settable.insert(vars + 1, words.end());
      names.passed.insert(vars + 1, words.end());
    }
    collect_passed(words, names.passed);
  }
  return true;
}

Names set_by_deck()
{
  DeckNames found;
  for (const std::string &deck : words_after("-in", "-i")) collect(deck, found);
  return found.index;
}

void collect_folder(const std::string &folder, Names &names)
{
  DeckNames files;
  std::error_code ec;
  for (fs::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec))
    if (it->path().extension() != ".csv") collect(it->path(), files);
  names.merge(files.settable);
  for (const DataTable &table : tables_of(folder)) names.merge(table.variables());
}

static std::string link_of(FILE *file) { return "/proc/self/fd/" + std::to_string(fileno(file)); }

std::string deck_name(FILE *infile)
{
  std::error_code ec;
  return infile ? fs::read_symlink(link_of(infile), ec).filename().string() : "";
}

void collect_deck(FILE *infile, DeckNames &names)
{
  if (infile) collect(link_of(infile), names);
  for (const std::string &deck : words_after("-in", "-i")) collect(deck, names);
}

static bool is_number(const std::string &word)
{
  char *end = nullptr;
  std::strtod(word.c_str(), &end);
  return end != word.c_str() && *end == '\0';
}

std::string wrong_with(const std::string &value)
{
  const std::vector<std::string> words = words_of(value);
  if (words.empty()) return " is empty";
  if (is_number(words[0]) && !std::all_of(words.begin(), words.end(), is_number))
    return " is '" + value + "': give a number alone, in the unit of the deck";
  return "";
}

}    // namespace bearing

extern "C" void raceway_set_command_line(int argc, char **argv)
{
  bearing::own_words.assign(argv, argv + argc);
}
