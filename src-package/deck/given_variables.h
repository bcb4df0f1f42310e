// SPDX-License-Identifier: GPL-2.0-or-later
// Variables that a user sets with -var, and variables that a deck defines.
#ifndef BEARING_GIVEN_VARIABLES_H
#define BEARING_GIVEN_VARIABLES_H

#include <filesystem>
#include <set>
#include <string>

namespace bearing {

typedef std::set<std::string> Names;

// Words that follow either of two options on the program's command line
Names words_after(const char *option, const char *other);

// Variables of a deck
struct DeckNames {
  Names settable;    // with -var: variables of styles that store such a value, words after `vars`
  Names index;       // variables of lines `variable NAME index VALUE`
  Names passed;      // passed to a command: after `vars`, or as `NAME ${NAME}`, `NA ${NA_ME}`
};

// Adds the variables of a deck in a file. False if the file cannot be read.
bool collect(const std::filesystem::path &, DeckNames &);

// Variables of lines `variable NAME index VALUE` in the deck with which the program was started
Names set_by_deck();

// Collects the settable variables of all files and tables in a folder.
void collect_folder(const std::string &folder, Names &);

// Name of the file that the host reads; empty for the standard input
std::string deck_name(FILE *infile);

// Adds the variables of the deck that the host reads, `infile` (or null), and of the decks given by
// -in, which may include that deck.
void collect_deck(FILE *infile, DeckNames &);

std::string nearest(const std::string &name, const Names &);

// Error message if a value of -var is empty or has a unit after its number; otherwise empty
std::string wrong_with(const std::string &value);

}    // namespace bearing

#endif
