// SPDX-License-Identifier: GPL-2.0-or-later
// Variables that a user sets with -var, and variables that a deck defines.
#ifndef BEARING_GIVEN_VARIABLES_H
#define BEARING_GIVEN_VARIABLES_H

#include <filesystem>
#include <set>
#include <string>

namespace bearing {

typedef std::set<std::string> Names;

// Words of the program's command line that follow either of two options
Names words_after(const char *option, const char *other);

// Variables of a deck
struct DeckNames {
  Names settable;    // with -var: variables of styles that store such a value, words after `vars`
  Names index;       // variables of lines `variable NAME index VALUE`
  Names passed;      // passed to a command: after `vars`, or as `NAME ${NAME}`, `NA ${NA_ME}`
};

// False if the file cannot be read.
bool collect(const std::filesystem::path &, DeckNames &);

// Lines `variable NAME index VALUE` of the deck that the program was started with
Names set_by_deck();

// Collects the settable variables of all files and tables in a folder.
void collect_folder(const std::string &folder, Names &);

// Name of the file that the host reads; empty for the standard input
std::string deck_name(FILE *infile);

// Adds the variables of the deck that the host reads, `infile` or null, and of the decks after -in,
// which may include that deck.
void collect_deck(FILE *infile, DeckNames &);

std::string nearest(const std::string &name, const Names &);

// Error message about a value of -var that is empty or has a unit after its number; empty if it is
// neither
std::string wrong_with(const std::string &value);

}    // namespace bearing

#endif
