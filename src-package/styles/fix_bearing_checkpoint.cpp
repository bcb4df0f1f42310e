// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_checkpoint.h"

#include "../core/numbers/number_list.h"
#include "../core/settings/arguments.h"
#include "../core/settings/deck_words.h"
#include "../core/settings/restart_sum.h"
#include "../core/settings/written.h"
#include "../deck/different_lines.h"
#include "../deck/formulas.h"
#include "deck_notes.h"
#include "disk.h"
#include "fix_bearing_ring.h"
#include "fixes.h"
#include "output.h"
#include "pair_bearing_hertz.h"
#include "print_line.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <limits>
#include <set>
#include <sstream>
#include <sys/stat.h>
#include <unistd.h>

using namespace LAMMPS_NS;
using namespace FixConst;
using bearing::Arguments;
using bearing::StopSignal;
namespace fs = std::filesystem;

namespace {

std::string whole(double n) { return std::to_string(static_cast<long long>(n)); }

}    // namespace

// fix ID group bearing/checkpoint [N] FILE [restart M] [keep K] [resume yes|no] [last yes|no]
// [balance RING] [dumps yes|no] [files F1 F2 ...]
FixBearingCheckpoint::FixBearingCheckpoint(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), command_(bearing::name_of(*this))
{
  Arguments args(lmp, command_, narg, arg, 3);
  nevery = 1;
  if (args.more() && args.next_is_number())
    nevery = args.integer("steps between samples", 1, 1000000000);
  else wait();
  last_ = waits();
  file_ = args.word("restart file");
  part_ = file_ + ".part";
  bool dumps = false;
  int keep = 0;
  while (args.more()) {
    if (args.integer("restart", every_restart_, "steps between restart files", 0, 2000000000) ||
        (waits() && args.variable("keep", keep)) || args.yes("resume", resume_) ||
        args.yes("last", last_) || args.word("balance", ring_id_, "ID of a fix bearing/ring") ||
        (waits() && args.yes("dumps", dumps)))
      continue;
    if (!args.take("files")) args.unknown();
    while (args.more()) files_.push_back(args.word("file"));
  }
  keep_ = keep;
  if (dumps)
    for (const char *name : {"contacts.dump", "balls.dump", "rings.dat"})
      files_.push_back((fs::path(file_).parent_path() / name).string());
  for (int k = 0; k < modify->nfix; ++k)
    if (const Fix *f = modify->fix[k])
      if (f != this && dynamic_cast<const FixBearingCheckpoint *>(f))
        args.fail(std::string("fix ") + f->id +
                  " already has this style: the host writes only one series of restart files");
  length_.assign(files_.size(), 0.0);
  seen_.assign(files_.size(), -1.0);
  restart_global = 1;
  bearing::provide_values(*this, 0);
  write_every(every_restart_);
}

// The host writes to a temporary name, and publish() renames the complete file. If `steps` is 0, a
// restart file is written only when the run is stopped.
void FixBearingCheckpoint::write_every(int steps)
{
  const std::string n = std::to_string(steps ? steps : std::numeric_limits<int>::max());
  bearing::pass_words({n, part_, part_},
                      [this](int n, char **words) { output->create_restart(n, words); });
}

// Restart files are also written while the bearing settles, because this may take longer than the
// measurement.
void FixBearingCheckpoint::settle(const bearing::Sampling &sampling)
{
  if (every_restart_ == 0)
    write_every(
        static_cast<int>(std::min(2e9, std::ceil(keep_ / sampling.within) * sampling.every)));
}

void FixBearingCheckpoint::begin(const bearing::Sampling &sampling)
{
  nevery = sampling.every;
  settle(sampling);
}

int FixBearingCheckpoint::setmask() { return INITIAL_INTEGRATE | END_OF_STEP | POST_RUN; }

void FixBearingCheckpoint::init()
{
  if (waits()) refuse_plain_run(lmp, command_);
  if (!ring_id_.empty()) find_ring();
  if (resume_ && !resumed_)
    BRG_ALL(command_ + ": nothing to resume: the restart file has no state of a fix " + id +
            " of this style");
  check_deck();
  if (comm->me == 0 && !begun_) remove_replaced_files();
  begun_ = true;
}

// Removes what this run replaces: the restart file of an earlier run or, in a continued run, the
// files that did not exist yet when its restart file was written. `run_bearing` begins its dumps
// after this.
void FixBearingCheckpoint::remove_replaced_files()
{
  if (!resumed_) unlink(file_.c_str());
  for (size_t k = 0; k < files_.size(); ++k)
    if (length_[k] < 0.0) unlink(files_[k].c_str());
}

// Returns the commands that determine a run: the bearings (first line), the pair style, the data of
// named bearings, the fixes of the package except for those that only write output or monitor the
// run, and the formulas of the variables used in these commands.
std::vector<std::string> FixBearingCheckpoint::deck() const
{
  std::vector<std::string> lines = {bearing::noted_words(lmp, "create_bearing")};
  if (const auto *pair = dynamic_cast<const PairBearingHertz *>(force->pair))
    for (const std::vector<std::string> &words : pair->commands()) {
      lines.emplace_back(lines.size() == 1 ? "pair_style" : "pair_coeff");
      for (const std::string &w : words) lines.back() += " " + w;
    }
  const std::vector<std::string> data = bearing::data_lines(lmp);
  lines.insert(lines.end(), data.begin(), data.end());
  static const std::set<std::string> idle = {"bearing/record", "bearing/checkpoint",
                                             "bearing/progress", "bearing/run", "bearing/timestep"};
  for (int k = 0; k < modify->nfix; ++k)
    if (!idle.count(modify->fix[k]->style))
      lines.push_back(bearing::noted_words(lmp, bearing::name_of(*modify->fix[k])));
  const std::vector<std::string> formulas = bearing::formulas(lmp, lines);
  lines.insert(lines.end(), formulas.begin(), formulas.end());
  return lines;
}

// Stops with an error if the data in the deck of a continued run differ from those in the restart
// file. The deck does not have to repeat create_bearing.
void FixBearingCheckpoint::check_deck()
{
  if (deck_.empty()) return;
  std::vector<std::string> now = deck(), then;
  std::istringstream in(deck_);
  for (std::string line; std::getline(in, line);) then.push_back(line);
  deck_.clear();
  if (now[0].empty() || then[0].empty()) now[0] = then[0] = "";
  const auto [old, own] = bearing::different_lines(then, now);
  if (!old.empty() || !own.empty())
    BRG_ALL(command_ + ": " + file_ + " belongs to another run, " +
            (old.empty() ? "without '" + own + "'"
                         : "with '" + old + "', this one " +
                               (own.empty() ? "without it" : "with '" + own + "'")) +
            ". Remove it, or resume with its data");
}

void FixBearingCheckpoint::find_ring()
{
  const int k = modify->find_fix(ring_id_.c_str());
  ring_ = k < 0 ? nullptr : dynamic_cast<FixBearingRing *>(modify->fix[k]);
  if (!ring_)
    BRG_ALL(command_ + ": balance: there is no fix bearing/ring or bearing/shaft '" + ring_id_ +
            "'");
}

// Before the first step of a continued run, removes the output of its set-up, which the files
// already contain. In later steps, publishes the restart file of the previous step, which is now
// complete.
void FixBearingCheckpoint::initial_integrate(int)
{
  if (resumed_ && !cut_) cut_files();
  if (written_) publish();
}

void FixBearingCheckpoint::end_of_step()
{
  if (!waits()) take_sample();
  int signal = StopSignal::caught();
  if (comm->nprocs > 1)
    MPI_Allreduce(MPI_IN_PLACE, &signal, 1, MPI_INT, MPI_MAX, world);    // on all ranks
  if (!signal) return;
  StopSignal::set(signal);
  bearing::end_run_after_this_step(lmp);
}

void FixBearingCheckpoint::take_sample()
{
  if (ring_) {
    const FixBearingRing::Balance now = ring_->balance();
    sum_.load += now.load;
    sum_.left += now.left;
  }
  samples_ += 1.0;
  if (comm->me == 0) watch_files();
}

void FixBearingCheckpoint::post_run()
{
  // a signal received after the last sample may have reached only some of the ranks, so all ranks
  // must agree on one value
  int signal = StopSignal::caught();
  if (comm->nprocs > 1) MPI_Allreduce(MPI_IN_PLACE, &signal, 1, MPI_INT, MPI_MAX, world);
  StopSignal::set(signal);
  if (resumed_ && !cut_) cut_files();    // this happens in a run of zero steps
  if (signal) stop();
  if (last_ && !waits()) output->write_restart(update->ntimestep);
  if (written_) publish();
  if (comm->me == 0 && !files_.empty()) {    // no later sample could detect a full disk
    const std::string room = bearing::disk_is_full(file_);
    if (!room.empty()) BRG_ONE(command_ + ": the last output may be lost: " + room);
  }
}

// Called when the run has ended after a complete step and its output has been written. Saves the
// state and exits.
void FixBearingCheckpoint::stop()
{
  output->write_restart(update->ntimestep);
  if (comm->me == 0 && !written_)
    BRG_ONE(command_ + ": stopped without a restart file: a 'restart' command after this fix has " +
            "replaced it");
  publish();
  bearing::print_line(lmp, std::string("Stopped by signal ") + strsignal(StopSignal::caught()) +
                               " after step " + std::to_string(update->ntimestep) +
                               "; -var resume yes continues from " + file_);
  MPI_Finalize();
  exit(128 + StopSignal::caught());    // the exit code that a shell uses to report a signal
}

void FixBearingCheckpoint::publish()
{
  written_ = false;
  if (comm->me != 0) return;
  for (const std::string &f : files_) bearing::flush_to_disk(f);
  // the host does not check its writes; they are assumed to have succeeded if the disk accepts more
  // data
  const bool summed = bearing::write_sum(part_);
  std::string why = bearing::flush_with_room(part_);
  if (why.empty() && !summed) why = "its checksum cannot be added";
  if (why.empty() && rename(part_.c_str(), file_.c_str()) != 0) why = strerror(errno);
  if (why.empty()) return;
  unlink(part_.c_str());
  BRG_ONE(command_ + ": cannot write restart file " + file_ + " at step " +
          std::to_string(update->ntimestep) + ": " + why +
          ". The previous one, if any, is intact: make room and continue from it");
}

// Checks that no output file is shorter than it was when the restart file was written, and stops
// with the `advice` otherwise. Files may have grown since then.
void FixBearingCheckpoint::check_files(const std::string &advice)
{
  if (comm->me != 0) return;
  for (size_t k = 0; k < files_.size(); ++k) {
    const double now = bearing::file_size(files_[k]);
    if (now < length_[k])
      BRG_ONE(command_ + ": " + files_[k] +
              (now < 0.0 ? " is gone" : " has " + whole(now) + " bytes") + ", it had " +
              whole(length_[k]) + " when " + file_ + " was written: " + advice);
  }
}

void FixBearingCheckpoint::cut_files()
{
  cut_ = true;
  if (comm->me != 0) return;
  check_files("the deck has replaced it, because the command that writes it does not append");
  for (size_t k = 0; k < files_.size(); ++k) {
    if (length_[k] >= 0.0 && truncate(files_[k].c_str(), static_cast<off_t>(length_[k])) != 0)
      BRG_ONE(command_ + ": cannot cut " + files_[k] + ": " + strerror(errno));
    seen_[k] = -1.0;    // the next sample of a dump is written after the next check of its length
  }
}

// Detects a full disk by looking for a file that has stopped growing, because the host does not
// check its writes.
void FixBearingCheckpoint::watch_files()
{
  for (size_t k = 0; k < files_.size(); ++k) {
    const double now = bearing::file_size(files_[k]);
    if (now <= seen_[k]) {
      const std::string room = bearing::disk_is_full(file_);
      BRG_ONE(command_ + ": " + files_[k] + " has stopped growing at step " +
              std::to_string(update->ntimestep) + ": " +
              (room.empty() ? "it must grow every " + std::to_string(nevery) +
                                  " steps. Is it written less often, does another run write it, "
                                  "or was the disk full for a while?"
                            : room + '.') +
              " Make room and continue from the last restart file, or start again");
    }
    seen_[k] = now;
  }
}

// Returns the mean residual force on the ring as a fraction of the mean load, over all parts of an
// interrupted run.
double FixBearingCheckpoint::compute_scalar()
{
  if (ring_id_.empty() || samples_ == 0.0) return 0.0;
  const auto length = [](const raceway::Vec3 &v) { return std::hypot(v.x, v.y, v.z); };
  return length(sum_.left) / length(sum_.load);
}

void FixBearingCheckpoint::write_restart(FILE *fp)
{
  bearing::NumberWriter list;
  list(samples_, files_.size(), sum_);
  if (comm->me != 0) return;
  // a deck may also write its own restart files, which this fix ignores
  struct stat theirs, ours;
  written_ = fstat(fileno(fp), &theirs) == 0 && stat(part_.c_str(), &ours) == 0 &&
             theirs.st_dev == ours.st_dev && theirs.st_ino == ours.st_ino;
  for (const std::string &f : files_) list(bearing::file_size(f));
  std::string words;
  for (const std::string &line : deck()) words += line + '\n';
  list.write(fp, words + '\0' + bearing::empty_sum());
}

void FixBearingCheckpoint::restart(char *buf)
{
  bearing::NumberReader list(buf);
  size_t files;
  list(samples_, files, sum_);
  if (files != files_.size())
    BRG_ALL(command_ + ": the restart file was written with " + std::to_string(files) +
            " files, not " + std::to_string(files_.size()));
  list(length_);
  deck_ = list.rest();
  resumed_ = true;
  check_files("start the run anew");
}
