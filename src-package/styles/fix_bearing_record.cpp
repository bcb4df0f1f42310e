// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_record.h"

#include "bearing_compat.h"
#include "contact_context.h"
#include "deck_notes.h"
#include "find_record_layout.h"
#include "fix_bearing_cage.h"
#include "fix_bearing_heat.h"
#include "fixes.h"
#include "pair_bearing_hertz.h"
#include "record_settings.h"
#include "ring_values.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

using namespace LAMMPS_NS;
using namespace FixConst;
using bearing::Arguments;
using bearing::NetcdfHeader;
using bearing::RecordFile;
namespace fs = std::filesystem;

static constexpr size_t batch_bytes = 1 << 20, most_in_batch = 256;

// A note becomes an attribute of the file. Its name must not be one that scipy's netCDF reader uses
// internally, because this would break the reader. The name `checksum` is used in the header.
static std::string name_of_note(Arguments &args, const std::string &what)
{
  static const char *const taken[] = {
      "filename",  "fp",    "use_mmap", "mode", "version_byte",    "maskandscale",   "dimensions",
      "variables", "close", "flush",    "sync", "createDimension", "createVariable", "checksum"};
  const std::string name = args.word(what);
  const bool word = std::isalpha(static_cast<unsigned char>(name[0])) &&
                    std::all_of(name.begin(), name.end(),
                                [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  if (!word)
    args.fail(what + " is '" + name +
              "': it begins with a letter and has letters, digits and '_' only");
  if (std::find(std::begin(taken), std::end(taken), name) != std::end(taken))
    args.fail(what + " is '" + name + "', which readers of netCDF reserve");
  return name;
}

// fix ID group bearing/record N|pass/N FOLDER [content all|summary|none]
// [contacts all|usual|none|NAME ...] [within M] [single yes|no]
// [overwrite yes|no] [number NAME VALUE] [text NAME VALUE]
FixBearingRecord::FixBearingRecord(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), pair_(PairBearingHertz::find(lmp, "fix bearing/record")),
    command_(bearing::name_of(*this))
{
  Arguments args(lmp, command_, narg, arg, 3);
  read_rate(args);
  folder_ = args.word("folder");
  read_options(args);
  if (!atom->map_style) args.fail("needs 'atom_modify map array'");
  restart_global = 1;
  bearing::provide_values(*this, 0);
  path_ = (fs::path(folder_) / "record.nc").string();
  check_path();
}

// Reads N, the number of steps between samples, or pass/N, where N is the number of samples per
// ball pass during the measurement of run_bearing.
void FixBearingRecord::read_rate(Arguments &args)
{
  nevery = 1;
  if (!args.more() || args.next().compare(0, 5, "pass/") != 0) {
    nevery = args.integer("steps between samples", 1, 1000000000);
    return;
  }
  const std::string word = args.word("samples");
  a_pass_ = args.number_in(word.substr(5), "samples in a ball pass");
  if (!(a_pass_ >= 1.0 && a_pass_ <= 1e5 && a_pass_ == std::floor(a_pass_)))
    args.fail("samples in a ball pass is " + word.substr(5) +
              ", must be a whole number from 1 to 100000");
  within_ = 0;
  wait();
}

void FixBearingRecord::read_options(Arguments &args)
{
  const bearing::Offer offer = bearing::offer_of(lmp, *pair_);
  bool chosen = false;
  while (args.more()) {
    if (args.take("contacts")) {
      chosen = true;
      columns_.clear();
      if (args.take("none")) continue;
      do
        bearing::select_columns(args, args.word("a contact attribute, all, usual or none"), offer,
                                columns_);
      while (args.more() && bearing::find_contact_column(args.next()));
    } else if (args.take("content") || args.take("record")) {
      const int content = args.choice("content", {"none", "summary", "all"});
      sampled_ = content > 0;
      motion_ = content == 2;
      if (motion_) continue;
      chosen = true;
      columns_.clear();
    } else if (args.take("number")) {
      const std::string name = name_of_note(args, "name of a number");
      notes_.push_back({name, args.number(name)});
    } else if (args.take("text")) {
      const std::string name = name_of_note(args, "name of a text");
      notes_.push_back({name, args.word(name)});
    } else if (!(args.integer("within", within_, "samples per step", waits() ? 0 : 1, 100000) ||
                 (waits() && args.yes("dumps", dumps_)) || args.yes("single", single_) ||
                 args.yes("overwrite", overwrite_))) {
      args.unknown("contacts, content, within, single, overwrite, number, text");
    }
  }
  if (dumps_ && within_ == 0) within_ = 1;    // dumps are written only at the ends of steps
  bearing::check_within(args, within_, nevery);
  if (!chosen) bearing::select_columns(args, "usual", offer, columns_);
  // values that are constant over the samples of a contact are stored as coordinates, not as
  // columns
  columns_.erase(std::remove_if(columns_.begin(), columns_.end(),
                                [](const bearing::ContactColumn *c) { return c->names_it; }),
                 columns_.end());
}

int FixBearingRecord::setmask() { return END_OF_STEP | POST_RUN; }

// Creates the folder of the record, or stops with an error if that fails.
void FixBearingRecord::check_path()
{
  std::string why;
  if (comm->me == 0) {
    std::error_code ec;
    fs::create_directories(folder_, ec);
    if (ec) why = "cannot make the folder '" + folder_ + "': " + ec.message();
  }
  refuse(why);
}

void FixBearingRecord::init()
{
  if (waits()) {
    refuse_plain_run(lmp, command_);
    return check_finished();
  }
  over_ = a_pass_ > 0.0 && open_ && modify->find_fix(bearing::fix_of_run) < 0;
  pair_ = PairBearingHertz::find(lmp, command_);
  context_ = bearing::context_of(lmp, *pair_, columns_, command_);
  // these data are needed for sums over bearings even if their columns are not selected
  const bearing::Offer offer = bearing::offer_of(lmp, *pair_);
  if (!context_.capacitor && offer.capacitance)
    context_.capacitor = bearing::capacitor_of(lmp, command_, "a capacitance");
  context_.surroundings = offer.surroundings;
}

// Distributes the samples of a ball pass over the steps chosen by run_bearing.
void FixBearingRecord::begin(const bearing::Sampling &sampling)
{
  nevery = sampling.every;
  within_ = sampling.within;
  note({"samples_per_pass", a_pass_});
  if (dumps_) begin_dumps();
}

// Starts the host's text dumps of contacts, balls and rings, which are written at the ends of steps
// to the folder of the record. The columns of the dumps are listed in run.yaml.
void FixBearingRecord::begin_dumps()
{
  const std::string every = std::to_string(nevery), resumed = resumed_ ? "yes" : "no";
  const std::string columns = "id type x y z vx vy vz omegax omegay omegaz";
  for (const std::string &line :
       {std::string("compute contact balls bearing/contact usual"),
        "bearing_dump contacts balls " + every + " " + folder_ + "/contacts.dump contact append " +
            resumed + " columns b_contact_columns",
        "dump balls all custom " + every + " " + folder_ + "/balls.dump " + columns,
        "dump_modify balls append " + resumed +
            " " BRG_LINE_FORMAT
            " \"%d %d %.12g %.12g %.12g %.12g %.12g %.12g %.12g %.12g %.12g\" sort id",
        "bearing_dump rings all " + every + " " + folder_ + "/rings.dat inner append " + resumed})
    input->one(line.c_str());
  char name[] = "b_contact_columns";
  note({"contact_columns", std::string(input->variable->retrieve(name))});
  note({"ball_columns", columns});
}

void FixBearingRecord::note(NetcdfHeader::Attribute one, bool changes)
{
  one.changes = changes;
  notes_.erase(std::remove_if(notes_.begin(), notes_.end(),
                              [&](const NetcdfHeader::Attribute &a) { return a.name == one.name; }),
               notes_.end());
  notes_.push_back(one);
}

// Takes the first sample at the start of every run unless it was already taken at the end of the
// previous run.
void FixBearingRecord::setup(int)
{
  if (waits() || over_) return;
  check_step();
  if (open_) {
    check_time_step();
    check_flaws();
  }
  step_length_ = update->dt;
  if (!open_) open();
  if (within_ > 1 && sampled_) find_integrators();
  cages_ = bearing::fixes_of<FixBearingCage>(lmp);
  bearing::note_setup(lmp);
  start_clocks();
  if (file_) refuse(file_->file().put_fixed(file_->finished(), 0.0));
  if (update->ntimestep % nevery == 0) sample(false);
}

void FixBearingRecord::end_of_step()
{
  if (waits() || over_) return;
  sample(true);
  if (update->ntimestep == update->laststep) stop_clocks();
}

void FixBearingRecord::check_time_step() const
{
  if (update->dt != step_length_)
    BRG_ALL(command_ + ": the time step was " + bearing::text(step_length_) + " s and is now " +
            bearing::text(update->dt) + " s; the samples of a record must be evenly spaced");
}

// Stops with an error if the host's step number has changed between two runs, because the record
// would have a gap.
void FixBearingRecord::check_step() const
{
  const double now = static_cast<double>(update->ntimestep);
  if ((open_ || resumed_) && now != left_)
    BRG_ALL(command_ + ": step " + bearing::text(now) + " comes after step " +
            bearing::text(left_) + "; begin a record after reset_timestep, not before");
}

// Stops with an error if a fix bearing/profile has been added, removed or changed between two runs.
void FixBearingRecord::check_flaws() const
{
  std::string noted;
  for (const NetcdfHeader::Attribute &a : about_)
    if (a.name == "flaws") noted = a.words;
  const std::string now = bearing::flaws_of(lmp, *pair_, layout_);
  const auto shown = [](const std::string &f) { return f.empty() ? "none" : "'" + f + "'"; };
  if (now != noted)
    BRG_ALL(command_ + ": flaws of its raceways were " + shown(noted) + " and are now " +
            shown(now) + "; start another record");
}

// Returns the time (s) since the first sample.
double FixBearingRecord::time_of(double step) const { return (step - first_step_) * step_length_; }

void FixBearingRecord::open()
{
  layout_ = bearing::find_record_layout(lmp, *pair_, groupbit, command_);
  if (layout_.bearings.empty()) BRG_ALL(command_ + ": there is no bearing in its group");
  if (!resumed_) {
    first_step_ = static_cast<double>((update->ntimestep + nevery - 1) / nevery * nevery);
    start_ = update->atime + (first_step_ - static_cast<double>(update->atimestep)) * update->dt;
  }

  RecordFile::Content content;
  for (const bearing::ContactColumn *c : columns_) content.contact.push_back(c->is);
  content.single = single_;
  content.motion = motion_;
  content.film = pair_->coefficients().lubricated();
  content.capacitance = static_cast<bool>(context_.capacitor);
  content.surroundings = context_.surroundings;
  content.law = pair_->coefficients().law();
  find_heats();
  content.heat = !heats_.empty();
  if (content.heat) keep_oil();
  content.spheres = pair_->coefficients().any_spheres() || layout_.pockets();
  bearing::add_deck_notes(lmp, *pair_, layout_, within_, notes_);
  about_ = bearing::record_settings(lmp, *pair_, layout_, notes_,
                                    {nevery * update->dt / within_, start_});
  if (content.heat) keep_commands();
  content.about = about_;
  std::unique_ptr<RecordFile> file(new RecordFile(layout_, content));
  const size_t batch =
      std::min(most_in_batch, std::max<size_t>(1, batch_bytes / file->record_bytes()));
  // several ranks communicate once per batch, whereas a single rank writes each sample at once
  rows_.begin(layout_, *file, columns_, comm->nprocs > 1 ? batch : 1);
  open_ = true;
  check_finished();
  if (comm->me != 0) return;
  std::string why;
  if (!sampled_) {
    fs::remove(path_);
  } else {
    file_ = std::move(file);
    why = resumed_ ? file_->file().go_on(path_, file_->header(), batch,
                                         static_cast<size_t>(samples_), file_->finished())
                   : file_->file().create(path_, file_->header(), batch);
  }
  if (!why.empty()) BRG_ONE(command_ + ": cannot write " + path_ + ": " + why);
  refuse(bearing::write_run_yaml(folder_, about_, {}));
}

// Finds the fix bearing/heat of each bearing. The list is empty if there is no such fix.
void FixBearingRecord::find_heats()
{
  heats_.clear();
  const std::vector<int> type = bearing::ball_types(lmp, layout_);
  bool any = false;
  std::vector<FixBearingHeat *> found(type.size(), nullptr);
  for (FixBearingHeat *f : bearing::fixes_of<FixBearingHeat>(lmp))
    for (size_t b = 0; b < type.size(); ++b)
      if (!f->idle() && f->covers_type(type[b])) {
        found[b] = f;
        if (!any) {
          note({"heat_ambient_C", f->ambient()});
          note({"ball_expansion_per_K", f->ball_expansion()});
        }
        any = true;
      }
  if (any) heats_ = found;
}

// A continued run has an oil at another temperature, but writes the same header.
void FixBearingRecord::keep_oil()
{
  const bool known = !oil_.empty();
  size_t place = 0;
  for (bearing::RecordLayout::Bearing &b : layout_.bearings)
    for (const int k : {bearing::of_kind::VISCOSITY, bearing::of_kind::PRESSURE_VISCOSITY})
      if (known) b.of[k] = oil_.at(place++);
      else oil_.push_back(b.of[k]);
}

void FixBearingRecord::keep_commands()
{
  for (NetcdfHeader::Attribute &a : about_) {
    if (a.name != "pair_commands") continue;
    if (commands_.empty()) commands_ = a.words;
    else a.words = commands_;
  }
}

// Before the first step, stops with an error if the folder contains a finished run, unless
// overwriting is allowed.
void FixBearingRecord::check_finished()
{
  if (allowed_) return;
  allowed_ = true;
  if (comm->me == 0 && !overwrite_ && bearing::holds_finished_run(folder_))
    BRG_ONE(command_ + ": " + folder_ +
            " holds a finished run: name another folder, or give 'overwrite yes'");
}

// Returns the number of samples so far.
double FixBearingRecord::compute_scalar() { return samples_; }

void FixBearingRecord::refuse(const std::string &complaint) const
{
  if (!complaint.empty()) BRG_ONE(command_ + ": " + complaint);
}

double FixBearingRecord::memory_usage() { return static_cast<double>(rows_.bytes()); }
