// SPDX-License-Identifier: GPL-2.0-or-later
// Finds the variables that a user sets with -var and the variables that a deck defines.
#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace bearing {

typedef std::set<std::string> Names;

// Returns the words that follow either of the two options on the command line of the program.
Names words_after(const char *option, const char *other);

// Variables of a deck.
struct DeckNames {
  Names settable;    // variables that -var can set, and words after `vars`
  Names index;       // variables defined by lines `variable NAME index VALUE`
  Names passed;      // variables passed to a command after `vars`, or as `NAME ${NAME}` or `NA
                     // ${NA_ME}`
};

// Adds the variables of the deck in a file. Returns false if the file cannot be read.
bool collect(const std::filesystem::path &, DeckNames &);

// Returns the variables defined by lines `variable NAME index VALUE` in the deck with which the
// program was started.
Names set_by_deck();

// Collects the variables that can be set in any of the files and tables in a folder.
void collect_folder(const std::string &folder, Names &);

// Returns the name of the file that the host reads, or an empty string if it reads standard input.
std::string deck_name(FILE *infile);

// Adds the variables of the deck `infile` (or null) that the host reads, and of the decks given by
// -in, which may include that deck.
void collect_deck(FILE *infile, DeckNames &);

// Returns an error message if a value given with -var is empty or is followed by a unit, and an
// empty string otherwise.
std::string wrong_with(const std::string &value);

}    // namespace bearing

// Sets the command line of a run whose process was not started with it (host/run_server.h).
extern "C" __attribute__((visibility("default"))) void raceway_set_command_line(int argc,
                                                                                char **argv);
