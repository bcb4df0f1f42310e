// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_record.h"

#include "../contacts/fix_columns.h"
#include "../ranks/gather.h"
#include "contact_context.h"
#include "find_record_layout.h"
#include "fix_bearing_capacitance.h"
#include "fix_bearing_implicit.h"
#include "fixes.h"
#include "pair_bearing_hertz.h"
#include "record_settings.h"
#include "ring_values.h"

#include <algorithm>
#include <cctype>
#include <ctime>
#include <filesystem>

using namespace LAMMPS_NS;
using namespace FixConst;
using bearing::Arguments;
using bearing::NetcdfHeader;
using bearing::RacewayContact;
using bearing::RecordFile;
using raceway::Vec3;
namespace fs = std::filesystem;
namespace of_ring = bearing::of_ring;

static constexpr size_t batch_bytes = 1 << 20, most_in_batch = 256;

// s, of this process
static double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// A note becomes an attribute of the file. Names that scipy's reader of netCDF has for itself would
// break it.
static std::string note_name(Arguments &args, const char *what)
{
  static const char *const taken[] = {
      "filename",  "fp",    "use_mmap", "mode", "version_byte",    "maskandscale",  "dimensions",
      "variables", "close", "flush",    "sync", "createDimension", "createVariable"};
  const std::string name = args.word(what);
  const bool word = std::isalpha(static_cast<unsigned char>(name[0])) &&
                    std::all_of(name.begin(), name.end(),
                                [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  if (!word)
    args.fail(std::string(what) + " is '" + name +
              "': it begins with a letter and has letters, digits and '_' only");
  if (std::find(std::begin(taken), std::end(taken), name) != std::end(taken))
    args.fail(std::string(what) + " is '" + name +
              "', which readers of netCDF keep for themselves");
  return name;
}

// fix ID group bearing/record N FOLDER [content all|summary|none] [contacts all|usual|none|NAME
// ...] [within M] [single yes|no] [overwrite yes|no] [number NAME VALUE] [goal NAME VALUE]
// [text NAME VALUE]
FixBearingRecord::FixBearingRecord(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), pair_(PairBearingHertz::find(lmp, "fix bearing/record")),
    command_(std::string("fix ") + id + " bearing/record")
{
  Arguments args(lmp, command_, narg, arg, 3);
  nevery = args.integer("steps between samples", 1, 1000000000);
  folder_ = args.word("folder");
  read_options(args);
  if (!atom->map_style) args.fail("needs 'atom_modify map array'");
  restart_global = 1;
  scalar_flag = 1;
  extscalar = 0;
  global_freq = 1;
  path_ = (fs::path(folder_) / "record.nc").string();
  check_path();
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
    } else if (args.take("content")) {
      const int content = args.choice("content", {"none", "summary", "all"});
      sampled_ = content > 0;
      motion_ = content == 2;
      if (motion_) continue;
      chosen = true;
      columns_.clear();
    } else if (args.take("within")) {
      within_ = args.integer("samples a step", 1, 100000);
    } else if (args.take("single")) {
      single_ = args.choice("single", {"no", "yes"}) == 1;
    } else if (args.take("overwrite")) {
      overwrite_ = args.choice("overwrite", {"no", "yes"}) == 1;
    } else if (args.take("number")) {
      const std::string name = note_name(args, "name of a number");
      notes_.push_back(NetcdfHeader::attribute(name, args.number(name)));
    } else if (args.take("goal")) {
      const std::string name = note_name(args, "name of a number");
      notes_.push_back(NetcdfHeader::attribute(name, args.number(name)));
      notes_.back().changes = true;
    } else if (args.take("text")) {
      const std::string name = note_name(args, "name of a text");
      notes_.push_back(NetcdfHeader::attribute(name, args.word(name)));
    } else {
      args.unknown("contacts, content, within, single, overwrite, number, goal, text");
    }
  }
  if (within_ > 1 && nevery != 1)
    args.fail("'within' takes samples evenly within every step: N must be 1, not " +
              std::to_string(nevery));
  if (!chosen) bearing::select_columns(args, "usual", offer, columns_);
  // what is one value for all samples of a contact is a coordinate, not a column
  columns_.erase(std::remove_if(columns_.begin(), columns_.end(),
                                [](const bearing::ContactColumn *c) { return c->names_it; }),
                 columns_.end());
}

int FixBearingRecord::setmask() { return END_OF_STEP | POST_RUN; }

// The folder is there.
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
  pair_ = PairBearingHertz::find(lmp, command_);
  context_ = bearing::context_of(lmp, *pair_, columns_, command_);
  // sums over bearings need it whatever the columns
  const bearing::Offer offer = bearing::offer_of(lmp, *pair_);
  if (!context_.capacitor && offer.capacitance)
    context_.capacitor = bearing::capacitor_of(lmp, command_, "a capacitance");
  context_.surroundings = offer.surroundings;
}

// At the start of every run: the first sample, unless the run before ended with it.
void FixBearingRecord::setup(int)
{
  if (open_) {
    check_time_step();
    check_flaws();
  }
  step_length_ = update->dt;
  if (!open_) open();
  if (within_ > 1 && sampled_) find_integrators();
  clocks_.wall = MPI_Wtime();
  clocks_.processor = processor_time();
  running_ = true;
  if (file_) refuse(file_->file().put_fixed(file_->finished(), 0.0));
  if (update->ntimestep % nevery == 0) sample(false);
}

void FixBearingRecord::end_of_step() { sample(true); }

void FixBearingRecord::check_time_step() const
{
  if (update->dt != step_length_)
    BRG_ALL(command_ + ": the time step was " + bearing::text(step_length_) + " s and is now " +
            bearing::text(update->dt) + " s; samples of a record are even in time");
}

// A fix bearing/profile that came, went or changed between two runs.
void FixBearingRecord::check_flaws() const
{
  std::string noted;
  for (const NetcdfHeader::Attribute &a : about_)
    if (a.name == "flaws") noted = a.words;
  const std::string now = bearing::flaws_of(lmp, *pair_, layout_);
  const auto shown = [](const std::string &f) { return f.empty() ? "none" : "'" + f + "'"; };
  if (now != noted)
    BRG_ALL(command_ + ": flaws of its raceways were " + shown(noted) + " and are now " +
            shown(now) + "; begin another record");
}

// Those whose steps the samples lie within, and which balls have a capacitance there.
void FixBearingRecord::find_integrators()
{
  integrators_ = bearing::fixes_of<FixBearingImplicit>(lmp);
  for (int i = 0; i < atom->nlocal; ++i)
    if (rows_.ball(atom->tag[i]) >= 0 &&
        std::none_of(integrators_.begin(), integrators_.end(),
                     [&](const Fix *f) { return atom->mask[i] & f->groupbit; }))
      BRG_ONE(command_ + ": 'within " + std::to_string(within_) +
              "' needs fix bearing/implicit, which knows what happens within a step; it does not "
              "move ball " +
              std::to_string(atom->tag[i]) + ". With other integrators sample every step");
  const std::vector<FixBearingCapacitance *> fixes = bearing::fixes_of<FixBearingCapacitance>(lmp);
  std::vector<bearing::tag_t> balls;
  for (const FixBearingCapacitance *c : fixes)
    for (bearing::tag_t ball : c->find_members()) balls.push_back(ball);
  capacitors_ = bearing::TagSet(balls);
  for (FixBearingImplicit *f : integrators_) {
    f->want_instants({within_, {}}, command_);
    for (const FixBearingCapacitance *c : fixes) f->want_instants(c->instants(within_), command_);
  }
}

// From the first sample on, s.
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
  content.film = pair_->lubricated();
  content.capacitance = static_cast<bool>(context_.capacitor);
  content.surroundings = context_.surroundings;
  raceway::with_law(pair_->law(), [&](auto law) { content.couples = decltype(law)::couples; });
  content.asperities = pair_->law() & raceway::Parts::bit<raceway::MixedFrictionPart>();
  about_ = bearing::record_settings(lmp, *pair_, layout_, notes_,
                                    {nevery * update->dt / within_, start_});
  content.about = about_;
  std::unique_ptr<RecordFile> file(new RecordFile(layout_, content));
  const size_t batch =
      std::min(most_in_batch, std::max<size_t>(1, batch_bytes / file->record_bytes()));
  // ranks wait for each other once a batch; alone, a sample is written while it is at hand
  rows_.begin(layout_, *file, columns_, pair_->lubricated(), comm->nprocs > 1 ? batch : 1);
  open_ = true;
  if (comm->me != 0) return;
  std::string why;
  if (!resumed_ && !overwrite_ && bearing::holds_finished_run(folder_))
    BRG_ONE(command_ + ": " + folder_ +
            " holds a finished run: name another folder, or give 'overwrite yes'");
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

void FixBearingRecord::sample(bool between)
{
  const double step = static_cast<double>(update->ntimestep);
  if (step == last_step_) return;
  if (step < last_step_)
    BRG_ALL(command_ + ": step " + bearing::text(step) + " comes after step " +
            bearing::text(last_step_) + "; start a record after reset_timestep, not before");
  check_time_step();
  if (between && within_ > 1) {
    if (sampled_) sample_instants();
    samples_ += within_ - 1;
  }
  if (sampled_) {
    sample_contacts();
    sample_cage();
    sample_parts();
    end_sample(step);
  }
  last_step_ = step;
  samples_ += 1.0;
}

// What the bearings at home here did within the step.
void FixBearingRecord::sample_instants()
{
  bearing::InstantReader tell = {true, {}, {}, {}};
  tell.contact = [this](const bearing::InstantContact &c) {
    const int ball = rows_.ball(c.ball);
    if (ball < 0) return;
    if (rows_.needs_orbit(ball, c.raceway.groove.side)) rows_.orbit(ball, c.orbit);
    if (!c.live && !context_.surroundings) return;
    const bool capacitor = capacitors_.has(c.ball);
    const bearing::ContactView view = {
        double(c.ball), double(c.ring),
        c.raceway,      c.state,
        context_.axis,  capacitor ? c.capacitor : raceway::FilmCapacitorT<double>{}};
    if (c.live) rows_.contact(ball, view);
    else sample_gap(ball, view);
  };
  tell.body = [this](const bearing::InstantBody &b) {
    const int ball = rows_.ball(b.tag);
    if (ball >= 0) rows_.cage(ball, NAN, NAN);    // known at the ends of steps only
    rows_.body(b.tag, b.x, b.v, b.w);
  };
  tell.ring = [this](const bearing::InstantRing &r) { rows_.ring(r.of); };
  for (int k = 1; k < within_; ++k) {
    for (const FixBearingImplicit *f : integrators_) f->read_instant(k, tell);
    end_sample(static_cast<double>(update->ntimestep) - double(within_ - k) / within_);
  }
}

// Contacts of the balls of this rank.
void FixBearingRecord::sample_contacts()
{
  for (const RacewayContact &c : pair_->table().raceway) {
    const int ball = rows_.ball(c.ball);
    if (ball < 0) continue;
    if (rows_.needs_orbit(ball, c.side())) rows_.orbit(ball, bearing::orbit_of(*atom, *pair_, c));
    if (c.live) rows_.contact(ball, context_.view(c));
    else if (context_.surroundings) sample_gap(ball, context_.view(c));
  }
}

// Of a ball for which a fix gives surroundings.
void FixBearingRecord::sample_gap(int ball, const bearing::ContactView &view)
{
  if (view.capacitor.separation > 0.0) rows_.gap(ball, view);
}

// A ball has half of what it loses to other balls, and all that it loses to cage balls.
void FixBearingRecord::sample_cage()
{
  for (const bearing::SphereContact &s : pair_->table().sphere) {
    const int i = rows_.ball(s.tag_i), j = rows_.ball(s.tag_j);
    const double share = i >= 0 && j >= 0 ? 0.5 * s.loss : s.loss;
    if (i >= 0 && s.i < atom->nlocal) rows_.cage(i, share, s.force);
    if (j >= 0 && s.j < atom->nlocal) rows_.cage(j, share, s.force);
  }
}

// Balls, cage balls and rings of this rank.
void FixBearingRecord::sample_parts()
{
  for (int i = 0; i < atom->nlocal; ++i)
    rows_.body(atom->tag[i], Vec3::from(atom->x[i]), Vec3::from(atom->v[i]),
               Vec3::from(atom->omega[i]));
  double of[of_ring::N];
  for (int n = 0; n < pair_->ring_sum().rings(); ++n) {
    bearing::ring_values(*atom, *pair_, n, of);
    rows_.ring(of);
  }
}

void FixBearingRecord::end_sample(double step)
{
  rows_.end(time_of(step), step);
  if (rows_.full()) flush();
}

// All ranks.
void FixBearingRecord::flush()
{
  const size_t samples = rows_.samples();
  if (samples == 0) return;
  const std::vector<double> &said = rows_.said();
  std::string why;
  if (comm->nprocs == 1) {
    const double *row = said.data(), *const end = row + said.size();
    for (size_t k = 0; why.empty() && k < samples; ++k) {
      bool whole;
      row = file_->take(row, end, whole);
      why = file_->end_sample(row[1], row[2]);
      row += 3;
    }
  } else {
    why = gather(said, samples);
  }
  rows_.clear();
  if (!why.empty()) BRG_ONE(command_ + ": " + path_ + ": " + why);
}

// What the ranks know of the same samples, put together by the first.
std::string FixBearingRecord::gather(const std::vector<double> &said, size_t samples)
{
  std::vector<double> all;
  std::vector<size_t> begin = bearing::gather_to_first(said, all, world);
  if (!file_) return "";
  const double *rows = all.data();
  const std::vector<size_t> end(begin.begin() + 1, begin.end());
  begin.pop_back();
  std::string why;
  for (size_t k = 0; why.empty() && k < samples; ++k) {
    double time = 0.0, step = 0.0;
    for (size_t p = 0; p < end.size(); ++p) {
      bool whole;
      const double *row = file_->take(rows + begin[p], rows + end[p], whole);
      if (whole) {
        time = row[1];
        step = row[2];
      }
      begin[p] = static_cast<size_t>(row - rows) + 3;
    }
    why = file_->end_sample(time, step);
  }
  return why;
}

void FixBearingRecord::post_run()
{
  flush();
  spent_ = spent_now();
  running_ = false;
  if (comm->me != 0) return;
  const bool done = update->ntimestep == update->laststep;    // not stopped by a signal
  std::string why;
  if (file_) {
    why = file_->file().put_fixed(file_->finished(), done);
    if (why.empty()) why = file_->file().settle();
  }
  if (!why.empty()) BRG_ONE(command_ + ": " + path_ + ": " + why);
  const double time = time_of(last_step_);
  if (done)
    refuse(bearing::write_run_yaml(
        folder_, about_,
        {NetcdfHeader::attribute("step_s", time / std::max(spent_.steps, 1.0)),
         NetcdfHeader::attribute("evaluations", spent_.evaluations),
         NetcdfHeader::attribute("processor_s", spent_.processor),
         NetcdfHeader::attribute("simulated_s", time),
         NetcdfHeader::attribute("wall_s", spent_.wall)}));
}

// All ranks. Velocity Verlet evaluates the forces once a step.
FixBearingRecord::Spent FixBearingRecord::made() const
{
  using namespace bearing::of_fix_implicit;
  Spent s;
  s.wall = MPI_Wtime() - clocks_.wall;
  s.processor = processor_time() - clocks_.processor;
  const std::vector<FixBearingImplicit *> implicit = bearing::fixes_of<FixBearingImplicit>(lmp);
  if (implicit.empty())
    s.steps = s.evaluations = static_cast<double>(update->ntimestep - update->firststep);
  const double bearings = std::max<double>(1.0, layout_.bearings.size());
  for (FixBearingImplicit *f : implicit) {
    const double steps = f->compute_vector(STEPS) / bearings;
    s.steps += steps;
    s.evaluations += steps * f->compute_vector(CORRECTIONS);
  }
  return s;
}

// What the run has taken up to now; all ranks.
FixBearingRecord::Spent FixBearingRecord::spent_now() const
{
  if (!running_) return spent_;
  const Spent now = made();
  Spent sum;
  sum.wall = spent_.wall + now.wall;
  sum.processor = spent_.processor + now.processor;
  sum.steps = spent_.steps + now.steps;
  sum.evaluations = spent_.evaluations + now.evaluations;
  return sum;
}

// Samples so far
double FixBearingRecord::compute_scalar() { return samples_; }

void FixBearingRecord::refuse(const std::string &complaint) const
{
  if (!complaint.empty()) BRG_ONE(command_ + ": " + complaint);
}

// All ranks: what the restart file counts is in the file.
void FixBearingRecord::write_restart(FILE *fp)
{
  flush();
  if (file_) refuse(file_->file().settle());
  const Spent spent = spent_now();
  const double data[] = {samples_,   first_step_,     start_,      last_step_,
                         spent.wall, spent.processor, spent.steps, spent.evaluations};
  if (comm->me != 0) return;
  const int size = sizeof data;
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(data, 1, size, fp);
}

void FixBearingRecord::restart(char *buf)
{
  double data[8];
  memcpy(data, buf, sizeof data);
  samples_ = data[0];
  first_step_ = data[1];
  start_ = data[2];
  last_step_ = data[3];
  spent_.wall = data[4];
  spent_.processor = data[5];
  spent_.steps = data[6];
  spent_.evaluations = data[7];
  resumed_ = samples_ > 0.0;
}

double FixBearingRecord::memory_usage() { return static_cast<double>(rows_.bytes()); }
