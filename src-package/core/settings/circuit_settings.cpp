// SPDX-License-Identifier: GPL-2.0-or-later
#include "circuit_settings.h"

#include <cmath>
#include <limits>
#include <sstream>

using namespace bearing;
using raceway::OuterPoint;
using raceway::Waveform;

namespace {

// Reads rows that consist of a time (s) and a voltage (V) from a text file, in which # starts a
// comment.
void read_table(const Arguments &args, Waveform &w, const std::string &name)
{
  const std::optional<std::string> content = args.content(name);
  if (!content) args.fail("cannot read '" + name + "'");
  std::istringstream lines(*content);
  int row = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::string where = "'" + name + "', line " + std::to_string(++row);
    std::istringstream words(line.substr(0, line.find('#')));
    double t, v;
    std::string more;
    const bool number = bool(words >> t);
    if (!number && words.eof()) continue;
    if (!number || !(words >> v) || words >> more || !std::isfinite(t) || !std::isfinite(v))
      args.fail(where + ": a row of a voltage table must contain two numbers, s and V");
    if (!w.times.empty() && t <= w.times.back())
      args.fail(where + ": times of a voltage table must increase");
    w.times.push_back(t);
    w.voltages.push_back(v);
  }
  if (w.times.size() < 2) args.fail("'" + name + "' needs at least two rows of s and V");
}

Waveform read_voltage(Arguments &args)
{
  Waveform w;
  w.kind = static_cast<Waveform::Kind>(
      args.choice("voltage", {"constant", "sine", "common_mode", "table"}));
  if (w.kind == Waveform::table) {
    read_table(args, w, args.word("file of the voltage"));
    return w;
  }
  w.voltage = args.number("voltage (V)");
  if (w.kind == Waveform::sine) {
    w.frequency = args.positive("frequency (Hz)");
    if (args.more() && args.next_is_number()) w.phase = args.number("phase (rad)");
  } else if (w.kind == Waveform::common_mode) {
    w.carrier = args.positive("frequency of the carrier (Hz)");
    w.frequency = args.positive("frequency of the phases (Hz)");
    w.modulation = args.within("modulation", 0.0, 1.0);
    if (!w.carrier_fits())
      args.fail("a carrier of " + text(w.carrier) +
                " Hz must have at least twice the frequency of " + "the phases, " +
                text(w.frequency) + " Hz");
  }
  return w;
}

bool read_number(Arguments &args, CircuitSettings &s)
{
  return args.non_negative("second", s.second, "capacitance of the other bearing (F)") ||
         args.non_negative("second_factor", s.second_factor,
                           "capacitance of the other bearing over this one's") ||
         args.non_negative("beside", s.beside, "capacitance beside the bearing (F)") ||
         args.non_negative("stray", s.stray, "capacitance added to every film (F)") ||
         args.positive("breakdown", s.strength, "dielectric strength of a film (V/m)") ||
         args.positive("film_floor", s.film_floor, "smallest local thickness (m)") ||
         args.positive("resistivity", s.resistivity, "resistivity of the lubricant (ohm m)") ||
         args.positive("arc", s.arc, "resistance of a film while it fails (ohm)") ||
         args.integer("within", s.within, "samples per step", 1, 100000) ||
         args.integer("points", s.points, "circuit points per sample", 1, 1000000);
}

}    // namespace

CircuitSettings CircuitSettings::read(Arguments &args)
{
  CircuitSettings s;
  bool driven = false;
  s.outer = static_cast<Outer>(args.choice("outer circuit", {"floating", "source", "motor"}));
  if (s.outer == floating) s.start = args.number("voltage at the start (V)");
  if (s.outer == source) s.resistance = args.non_negative("resistance of the source (ohm)");
  if (s.outer == motor) {
    s.winding_rotor = args.positive("capacitance of winding to rotor (F)");
    s.rotor_frame = args.non_negative("capacitance of rotor to frame (F)");
  }
  while (args.more()) {
    if (args.take("voltage")) {
      s.voltage = read_voltage(args);
      driven = true;
    } else if (read_number(args, s) ||
               args.word("events", s.events, "file for the films that fail")) {
      continue;
    } else if (args.take("surfaces")) {
      s.rough = args.choice("surfaces", {"rough", "smooth"}) == 0;
    } else if (args.positive("metal", s.metal, "resistance of a metallic film (ohm)")) {
      s.metal_share =
          args.within("share of the load on asperities above which a film is metallic", 0.0, 0.999);
    } else {
      args.unknown();
    }
  }
  if (driven != (s.outer != floating))
    args.fail(driven ? "a floating inner ring takes no 'voltage'" : "'voltage' is missing");
  if (s.outer != motor && (s.second > 0.0 || s.second_factor > 0.0))
    args.fail("'second' and 'second_factor' need a motor");
  if (s.second > 0.0 && s.second_factor > 0.0) args.fail("give either 'second' or 'second_factor'");
  if (s.breaks_down() && s.outer == source && s.resistance == 0.0)
    args.fail("breakdown would short a source without resistance: give it a resistance");
  if (!s.events.empty() && !s.breaks_down()) args.fail("'events' needs 'breakdown'");
  if (s.arc > 0.0 && s.events.empty()) args.fail("'arc' needs 'events'");
  return s;
}

OuterPoint CircuitSettings::at(double time, double bearing) const
{
  OuterPoint p;
  p.beside = beside;
  p.driving = voltage.at(time);
  if (outer == source)
    p.conductance = resistance > 0.0 ? 1.0 / resistance : std::numeric_limits<double>::infinity();
  if (outer == motor) {
    p.coupling = winding_rotor;
    p.beside += rotor_frame + second + second_factor * bearing;
  }
  return p;
}

double CircuitSettings::voltage_ratio(const OuterPoint &p, double bearing) const
{
  return outer == motor ? p.coupling / (p.coupling + p.beside + bearing) : 0.0;
}
