// SPDX-License-Identifier: GPL-2.0-or-later
#include "result_folder.h"

#include "../core/settings/folder_lock.h"
#include "../core/settings/restart_sum.h"
#include "print_line.h"
#include "record_settings.h"

#include <filesystem>
#include <fstream>

using namespace LAMMPS_NS;

namespace bearing {

void claim_result_folder(LAMMPS *lmp, const Arguments &args, const std::string &folder)
{
  // these characters have a meaning in the host's commands
  if (folder.find_first_of("%*\"'$&#") != std::string::npos)
    args.fail("the folder's name '" + folder + "' may not contain any of % * \" ' $ & #");
  FolderClaim claim;
  if (is_first_rank(lmp)) {
    std::error_code ec;
    std::filesystem::create_directories(folder, ec);
    if (ec) claim.complaint = "cannot make output folder '" + folder + "': " + ec.message();
    else claim = claim_folder(folder);
    if (!claim.warning.empty())
      lmp->error->warning(FLERR, BRG_TEXT(args.command() + ": " + claim.warning));
  }
  claim.complaint = of_first_rank(lmp, claim.complaint);
  if (!claim.complaint.empty()) args.fail(claim.complaint);
}

// Returns true if the restart file was written by this host. Those of LAMMPS begin with certain
// letters, unlike those of LIGGGHTS.
static bool is_of_this_host(const std::string &file)
{
  char start[7] = "";
  std::ifstream(file).read(start, 6);
  return (std::string(start) == "LammpS") == !BEARING_IS_LIGGGHTS;
}

bool goes_on(LAMMPS *lmp, const Arguments &args, const ResumeRequest &ask)
{
  const std::string &file = ask.file;
  const std::string folder = std::filesystem::path(file).parent_path().string();
  std::error_code ec;
  int there = is_first_rank(lmp) && std::filesystem::is_regular_file(file, ec) ? 1 : 0;
  std::string complaint;
  if (there && ask.resume && !has_right_sum(file))
    complaint = file + " is damaged: its checksum is wrong. Remove it and start the run anew";
  else if (there && ask.resume && !is_of_this_host(file))
    complaint =
        file + " is from another host: LIGGGHTS and LAMMPS cannot continue each other's runs";
  if (!ask.overwrite && is_first_rank(lmp) && !(there && ask.resume) && holds_finished_run(folder))
    complaint = folder + " holds a finished run: give another -var out or -var overwrite yes" +
                (there ? ", or more passes with -var resume yes" : "");
  complaint = of_first_rank(lmp, complaint);
  if (!complaint.empty()) args.fail(complaint);
  MPI_Bcast(&there, 1, MPI_INT, 0, lmp->world);
  if (ask.resume)
    print_line(lmp, there ? "Continuing from " + file
                          : "There is no " + file + ": starting from the beginning");
  return ask.resume && there;
}

}    // namespace bearing
