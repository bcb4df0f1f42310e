// SPDX-License-Identifier: GPL-2.0-or-later
// Exports the writer of a netCDF file with one dimension and one variable of each kind, for the
// tests.
#include "../../src-package/core/record/netcdf_file.cpp"
#include "../../src-package/core/record/netcdf_header.cpp"

#include <cmath>

using bearing::NetcdfFile;
using bearing::NetcdfHeader;

namespace {

struct Sample {
  NetcdfHeader header;
  NetcdfFile file;
  int time, wide, narrow, finished;
  std::string why;
};

constexpr int balls = 3;

void define(Sample &s, double temperature)
{
  using H = NetcdfHeader;
  const int time = s.header.dimension("time", 0), ball = s.header.dimension("ball", balls),
            side = s.header.dimension("raceway", 2), letters = s.header.dimension("letters", 5);
  s.header.add({"title", "a test"});
  s.header.add({"temperature", temperature});
  s.header.variable(
      {"raceway", {side, letters}, H::text, {{"_Encoding", "utf-8"}}, "innerouter", {}});
  s.header.variable({"ball", {ball}, H::integer, {}, "", {4, 5, 70000}});
  s.header.variable({"pitch", {}, H::real, {{"units", "m"}}, "", {0.0303}});
  s.finished = s.header.variable({"finished", {}, H::integer, {}, "", {0}});
  s.time = s.header.variable({"time", {time}, H::real, {{"units", "s"}}, "", {}});
  s.wide = s.header.variable({"x", {time, side, ball}, H::real, {}, "", {}, NAN});
  s.narrow = s.header.variable({"load", {time, ball}, H::single, {}, "", {}});
  s.header.layout();
}

}    // namespace

extern "C" {

// records < 0 creates a new file.
Sample *begin(const char *path, int batch, long records, double temperature)
{
  Sample *s = new Sample;
  define(*s, temperature);
  s->why = records < 0 ? s->file.create(path, s->header, batch)
                       : s->file.go_on(path, s->header, batch, records, s->finished);
  return s;
}

// Writes record k: time k/8, x = 1e-9 k + 0.1 (3 side + ball) except for (1, 2), which is not set,
// and load k + ball/3.
void write_record(Sample *s, long k)
{
  s->file.start_record();
  const double t = k / 8.0;
  s->file.put(s->time, 0, &t, 1);
  for (int n = 0; n < 2 * balls - 1; ++n) {
    const double x = 1e-9 * k + 0.1 * n;
    s->file.put(s->wide, n, &x, 1);
  }
  double load[balls];
  for (int n = 0; n < balls; ++n) load[n] = k + n / 3.0;
  s->file.put(s->narrow, 0, load, balls);
  if (s->file.full()) s->why = s->file.flush();
}

const char *why(Sample *s) { return s->why.c_str(); }
long record_bytes(Sample *s) { return static_cast<long>(s->header.record_bytes()); }
long header_bytes(Sample *s) { return static_cast<long>(s->header.bytes().size()); }
void settle(Sample *s) { s->why = s->file.settle(); }
void finish(Sample *s) { s->why = s->file.put_fixed(s->finished, 1); }
void leave(Sample *s) { delete s; }
}
