// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_record.h"

#include "../ranks/gather.h"
#include "contact_context.h"
#include "find_record_layout.h"
#include "fix_bearing_implicit.h"
#include "fix_bearing_state.h"
#include "fixes.h"
#include "pair_bearing_hertz.h"
#include "ring_values.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <map>

using namespace LAMMPS_NS;
using namespace FixConst;
using bearing::Arguments;
using bearing::BallShare;
using bearing::NetcdfHeader;
using bearing::RacewayContact;
using bearing::RecordFile;
using raceway::ContactState;
using raceway::Side;
using raceway::Vec3;
namespace fs = std::filesystem;
namespace of_ring = bearing::of_ring;

static constexpr size_t batch_bytes = 1 << 20, most_in_batch = 256;

// fix ID group bearing/record N FOLDER [content all|summary|none] [contacts all|usual|none|NAME
// ...] [single yes|no] [overwrite yes|no] [number NAME VALUE] [text NAME VALUE]
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
    } else if (args.take("single")) {
      single_ = args.choice("single", {"no", "yes"}) == 1;
    } else if (args.take("overwrite")) {
      overwrite_ = args.choice("overwrite", {"no", "yes"}) == 1;
    } else if (args.take("number")) {
      const std::string name = args.word("name of a number");
      notes_.push_back(NetcdfHeader::attribute(name, args.number(name)));
    } else if (args.take("text")) {
      const std::string name = args.word("name of a text");
      notes_.push_back(NetcdfHeader::attribute(name, args.word(name)));
    } else {
      args.unknown("contacts, content, single, overwrite, number, text");
    }
  }
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
  if (!context_.capacitor && bearing::offer_of(lmp, *pair_).capacitance)
    context_.capacitor = bearing::capacitor_of(lmp, command_, "a capacitance");
}

// At the start of every run: the first sample, unless the run before ended with it.
void FixBearingRecord::setup(int)
{
  if (open_ && update->dt != step_length_)
    BRG_ALL(command_ + ": the time step was " + bearing::text(step_length_) + " s and is now " +
            bearing::text(update->dt) + " s; samples of a record are even in time");
  step_length_ = update->dt;
  if (!open_) open();
  began_ = MPI_Wtime();
  running_ = true;
  if (file_) refuse(file_->file().put_fixed(file_->finished(), 0.0));
  if (update->ntimestep % nevery == 0) sample();
}

void FixBearingRecord::end_of_step() { sample(); }

// From the first sample on, s.
double FixBearingRecord::time_of(double step) const { return (step - first_step_) * step_length_; }

void FixBearingRecord::open()
{
  layout_ = bearing::find_record_layout(lmp, *pair_, groupbit, command_);
  if (layout_.bearings.empty()) BRG_ALL(command_ + ": there is no bearing in its group");
  double top = 0.0;
  for (const auto &p : layout_.balls) top = std::max(top, p.tag);
  for (const auto &p : layout_.cage) top = std::max(top, p.tag);
  for (const auto &p : layout_.rings) top = std::max(top, p.tag);
  places_.assign(static_cast<size_t>(top) + 1, {RecordFile::END, 0});
  const auto place = [this](const auto &list, Kind kind) {
    for (size_t k = 0; k < list.size(); ++k)
      places_[static_cast<size_t>(list[k].tag)] = {kind, static_cast<int>(k)};
  };
  place(layout_.balls, RecordFile::BALL);
  place(layout_.cage, RecordFile::CAGE);
  place(layout_.rings, RecordFile::RING);
  shares_.assign(layout_.balls.size(), BallShare());
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
  content.about = about_ = about();
  std::unique_ptr<RecordFile> file(new RecordFile(layout_, content));
  for (Kind k : {RecordFile::BALL, RecordFile::CONTACT, RecordFile::CAGE, RecordFile::RING})
    widths_[k] = file->width(k);
  batch_ = std::min(most_in_batch, std::max<size_t>(1, batch_bytes / file->record_bytes()));
  said_.reserve(batch_ * (file->record_bytes() / sizeof(double) + 3 * layout_.parts()));
  open_ = true;
  if (comm->me != 0) return;
  std::string why;
  if (!resumed_ && !overwrite_ && holds_finished_run())
    BRG_ONE(command_ + ": " + folder_ +
            " holds a finished run: name another folder, or give 'overwrite yes'");
  if (!sampled_) {
    fs::remove(path_);
  } else {
    file_ = std::move(file);
    why = resumed_ ? file_->file().go_on(path_, file_->header(), batch_,
                                         static_cast<size_t>(samples_), file_->finished())
                   : file_->file().create(path_, file_->header(), batch_);
  }
  if (!why.empty()) BRG_ONE(command_ + ": cannot write " + path_ + ": " + why);
  write_settings(false);
}

static bool has(const NetcdfHeader::Attributes &list, const std::string &name)
{
  return std::any_of(list.begin(), list.end(),
                     [&](const NetcdfHeader::Attribute &a) { return a.name == name; });
}

bool FixBearingRecord::holds_finished_run() const
{
  std::ifstream from(fs::path(folder_) / "run.yaml");
  for (std::string line; std::getline(from, line);)
    if (line.compare(0, 7, "wall_s:") == 0) return true;
  return false;
}

// What the one bearing of a record is: names with units, as in the decks' data files.
void FixBearingRecord::add_bearing(NetcdfHeader::Attributes &list) const
{
  static const std::map<std::string, const char *> suffix = {
      {"", ""}, {"m", "_m"}, {"kg", "_kg"}, {"Pa", "_Pa"}, {"Pa s", "_Pa_s"}, {"1/Pa", "_per_Pa"}};
  const double *of = layout_.bearings.front().of;
  const auto add = [&list](const std::string &name, double value) {
    if (!has(list, name) && !std::isnan(value))
      list.push_back(NetcdfHeader::attribute(name, value));
  };
  namespace of_kind = bearing::of_kind;
  for (int k = 0; k < of_kind::N; ++k) {
    const raceway::Column &c = of_kind::list[k];
    // that of a bearing without clearance, which stands beside it
    const double outside = k == of_kind::OUTER_RADIUS ? 0.5 * of[of_kind::CLEARANCE] : 0.0;
    add(c.name + std::string(suffix.at(c.unit)), of[k] - outside);
  }
  add("roughness_m", std::hypot(of[of_kind::RING_ROUGHNESS], of[of_kind::BALL_ROUGHNESS]));
  const char *const ring[] = {"inner_ring", "outer_ring"};
  for (const auto &r : layout_.rings) add(ring[r.raceway], r.tag);
}

NetcdfHeader::Attributes FixBearingRecord::about() const
{
  NetcdfHeader::Attributes list = notes_;
  list.insert(list.begin(), NetcdfHeader::attribute("title", "ball bearing run"));
  const bool implicit = !bearing::fixes_of<FixBearingImplicit>(lmp).empty();
  if (!has(list, "integrator"))
    list.push_back(NetcdfHeader::attribute("integrator", implicit ? "implicit" : "verlet"));
  if (layout_.bearings.size() == 1) add_bearing(list);
  list.push_back(NetcdfHeader::attribute("source", "Raceway 0.1.0, fix bearing/record"));
  list.push_back(NetcdfHeader::attribute("host", BRG_HOST_NAME));
  list.push_back(NetcdfHeader::attribute("axis", std::string(1, "xyz"[pair_->axis_index()])));
  list.push_back(NetcdfHeader::attribute("sample_s", nevery * update->dt));
  list.push_back(NetcdfHeader::attribute("start_s", start_));
  std::string commands = std::string("pair_style ") + force->pair_style;
  for (const std::vector<std::string> &words : pair_->said()) {
    if (&words != &pair_->said().front()) commands += "\npair_coeff";
    for (const std::string &w : words) commands += " " + w;
  }
  list.push_back(NetcdfHeader::attribute("pair_commands", commands));
  return list;
}

double *FixBearingRecord::row(Kind kind, int place)
{
  const size_t at = said_.size();
  said_.resize(at + 2 + widths_[kind]);
  said_[at] = kind;
  said_[at + 1] = place;
  return &said_[at + 2];
}

void FixBearingRecord::sample()
{
  const double step = static_cast<double>(update->ntimestep);
  if (step == last_step_) return;
  if (step < last_step_)
    BRG_ALL(command_ + ": step " + bearing::text(step) + " comes after step " +
            bearing::text(last_step_) + "; start a record after reset_timestep, not before");
  if (update->dt != step_length_)
    BRG_ALL(command_ + ": the time step was " + bearing::text(step_length_) + " s and is now " +
            bearing::text(update->dt) + " s; samples of a record are even in time");
  if (sampled_) {
    report_contacts();
    report_parts();
    end_sample(step);
  }
  last_step_ = step;
  samples_ += 1.0;
}

// Contacts of the balls of this rank, and their share in the sums.
void FixBearingRecord::report_contacts()
{
  const bool film = pair_->lubricated();
  const int n = static_cast<int>(layout_.balls.size());
  double side[2] = {0.0, 0.0};    // capacitance
  bearing::tag_t ball = -1;
  BallShare *share = nullptr;
  for (const RacewayContact &c : pair_->table().raceway) {
    if (static_cast<size_t>(c.ball) >= places_.size() || places_[c.ball].kind != RecordFile::BALL)
      continue;
    const int at = places_[c.ball].at, s = c.side() == Side::inner ? 0 : 1;
    if (c.ball != ball) {
      ball = c.ball;
      share = &shares_[at];
      side[0] = side[1] = 0.0;
    }
    // seen from the outer ring where there is one
    if (s == 1 || share->orbit == 0.0) share->orbit = bearing::orbit_of(*atom, *pair_, c);
    if (!c.live) continue;
    const bearing::ContactView view = context_.view(c);
    if (!columns_.empty()) {
      double *to = row(RecordFile::CONTACT, s * n + at);
      for (const bearing::ContactColumn *a : columns_) *to++ = a->value(view);
    }
    const ContactState &state = c.state;
    share->contacts += 1.0;
    share->load[s] = state.load;
    share->pressure[s] = c.raceway->law.at(state.cos_angle).p * state.root;
    share->friction_power += friction_power(state);
    share->damping_power += raceway::NormalForcePart::loss(state);
    side[s] = view.capacitor.capacitance;
    share->capacitance = raceway::series_capacitance(side[0], side[1]);
    if (s == 0) share->entrainment = state.entrainment;
    if (!film) continue;
    share->h_min = std::min(share->h_min, state.h_min);
    share->lambda = std::min(share->lambda, state.lambda);
    if (s == 0) {
      share->film[0] = state.h_min;
      share->film[1] = state.lambda;
      share->film[2] = view.capacitor.h_c;
    }
  }
}

// Balls, cage balls and rings of this rank.
void FixBearingRecord::report_parts()
{
  const auto motion = [this](int i, double *to) {
    for (int k = 0; k < 3; ++k) {
      to[k] = atom->x[i][k];
      to[3 + k] = atom->v[i][k];
      to[6 + k] = atom->omega[i][k];
    }
  };
  for (int i = 0; i < atom->nlocal; ++i) {
    const size_t tag = static_cast<size_t>(atom->tag[i]);
    if (tag >= places_.size()) continue;
    const Place p = places_[tag];
    if (p.kind == RecordFile::BALL) {
      double *to = row(p.kind, p.at);
      motion(i, to);
      memcpy(to + RecordFile::MOTION, &shares_[p.at], sizeof(BallShare));
      shares_[p.at] = BallShare();
    } else if (p.kind == RecordFile::CAGE) {
      motion(i, row(p.kind, p.at));
    }
  }
  double of[of_ring::N];
  for (int n = 0; n < pair_->ring_sum().rings(); ++n) {
    bearing::ring_values(*atom, *pair_, n, of);
    const size_t tag = static_cast<size_t>(of[of_ring::RING]);
    if (tag >= places_.size() || places_[tag].kind != RecordFile::RING) continue;
    std::copy(of + RecordFile::FIRST_OF_RING,
              of + RecordFile::FIRST_OF_RING + RecordFile::RING_VALUES,
              row(RecordFile::RING, places_[tag].at));
  }
}

void FixBearingRecord::end_sample(double step)
{
  said_.push_back(RecordFile::END);
  said_.push_back(time_of(step));
  said_.push_back(step);
  if (++in_batch_ == batch_) flush();
}

// All ranks.
void FixBearingRecord::flush()
{
  if (in_batch_ == 0) return;
  std::vector<double> all;
  std::vector<size_t> begin = {0}, end = {said_.size()};
  const double *rows = said_.data();
  if (comm->nprocs > 1) {
    begin = bearing::gather_to_first(said_, all, world);
    rows = all.data();
    end.assign(begin.begin() + (comm->me == 0), begin.end());
    if (comm->me == 0) begin.pop_back();
  }
  std::string why;
  for (size_t k = 0; file_ && why.empty() && k < in_batch_; ++k) {
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
  in_batch_ = 0;
  said_.clear();
  if (!why.empty()) BRG_ONE(command_ + ": " + path_ + ": " + why);
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
  if (done) write_settings(true);
}

// What was run, for people and scripts; what it took once it is done.
void FixBearingRecord::write_settings(bool done) const
{
  const fs::path file = fs::path(folder_) / "run.yaml";
  std::ofstream to(file);
  to << std::setprecision(15);
  for (const NetcdfHeader::Attribute &a : about_)
    if (a.type == NetcdfHeader::real) to << a.name << ": " << a.of[0] << "\n";
    else if (a.words.find('\n') == std::string::npos) to << a.name << ": " << a.words << "\n";
  if (done)
    to << "step_s: " << time_of(last_step_) / std::max(spent_.steps, 1.0)
       << "\nsimulated_s: " << time_of(last_step_) << "\nwall_s: " << spent_.wall << "\n";
  to << std::flush;
  if (!to) BRG_ONE(command_ + ": cannot write " + file.string() + ": " + strerror(errno));
}

// Steps of the integrators since the start of the present run; all ranks.
double FixBearingRecord::steps_made() const
{
  const std::vector<FixBearingImplicit *> implicit = bearing::fixes_of<FixBearingImplicit>(lmp);
  if (implicit.empty()) return static_cast<double>(update->ntimestep - update->firststep);
  double substeps = 0.0;
  for (FixBearingImplicit *f : implicit) substeps += f->compute_vector(2);
  return substeps / std::max<double>(1.0, layout_.bearings.size());
}

// What the run has taken up to now; all ranks.
FixBearingRecord::Spent FixBearingRecord::spent_now() const
{
  if (!running_) return spent_;
  return {spent_.wall + MPI_Wtime() - began_, spent_.steps + steps_made()};
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
  const double data[] = {samples_, first_step_, start_, last_step_, spent.wall, spent.steps};
  if (comm->me != 0) return;
  const int size = sizeof data;
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(data, 1, size, fp);
}

void FixBearingRecord::restart(char *buf)
{
  double data[6];
  memcpy(data, buf, sizeof data);
  samples_ = data[0];
  first_step_ = data[1];
  start_ = data[2];
  last_step_ = data[3];
  spent_ = {data[4], data[5]};
  resumed_ = samples_ > 0.0;
}

double FixBearingRecord::memory_usage() { return double(said_.capacity()) * sizeof(double); }
