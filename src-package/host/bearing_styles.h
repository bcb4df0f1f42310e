// SPDX-License-Identifier: GPL-2.0-or-later
// The only list of the styles; every loader registers the styles in it.
#pragma once

#include "../styles/bearing_resume.h"
#include "../styles/compute_bearing_ball.h"
#include "../styles/compute_bearing_contact.h"
#include "../styles/compute_bearing_ring.h"
#include "../styles/compute_bearing_total.h"
#include "../styles/create_bearing.h"
#include "../styles/deck_columns.h"
#include "../styles/fix_bearing_cage.h"
#include "../styles/fix_bearing_cage_ring.h"
#include "../styles/fix_bearing_capacitance.h"
#include "../styles/fix_bearing_checkpoint.h"
#include "../styles/fix_bearing_circuit.h"
#include "../styles/fix_bearing_grains.h"
#include "../styles/fix_bearing_heat.h"
#include "../styles/fix_bearing_implicit.h"
#include "../styles/fix_bearing_profile.h"
#include "../styles/fix_bearing_progress.h"
#include "../styles/fix_bearing_record.h"
#include "../styles/fix_bearing_ring.h"
#include "../styles/fix_bearing_run.h"
#include "../styles/fix_bearing_shaft.h"
#include "../styles/fix_bearing_state.h"
#include "../styles/fix_bearing_timestep.h"
#include "../styles/fix_bearing_verlet.h"
#include "../styles/name_bearing.h"
#include "../styles/pair_bearing.h"
#include "../styles/pair_bearing_ehd.h"
#include "../styles/run_bearing.h"

// add.pair<Class>("name"), add.fix<Class>("name"), ...
template <class Registry> void register_bearing_styles(Registry &add)
{
  using namespace LAMMPS_NS;
  add.template pair<PairBearingHertz>("bearing/hertz");
  add.template pair<PairBearingEHD>("bearing/ehd");
  add.template pair<PairBearing>("bearing");
  add.template fix<FixBearingState>("bearing/state");
  add.template fix<FixBearingRing>("bearing/ring");
  add.template fix<FixBearingShaft>("bearing/shaft");
  add.template fix<FixBearingImplicit>("bearing/implicit");
  add.template fix<FixBearingImplicit>("bearing/damping");
  add.template fix<FixBearingImplicit>("bearing/vibration");
  add.template fix<FixBearingVerlet>("bearing/verlet");
  add.template fix<FixBearingCage>("bearing/cage");
  add.template fix<FixBearingCageRing>("bearing/cage/ring");
  add.template fix<FixBearingCapacitance>("bearing/capacitance");
  add.template fix<FixBearingCircuit>("bearing/circuit");
  add.template fix<FixBearingGrains>("bearing/grains");
  add.template fix<FixBearingHeat>("bearing/heat");
  add.template fix<FixBearingProfile>("bearing/profile");
  add.template fix<FixBearingProgress>("bearing/progress");
  add.template fix<FixBearingRecord>("bearing/record");
  add.template fix<FixBearingRun>("bearing/run");
  add.template fix<FixBearingTimestep>("bearing/timestep");
  add.template fix<FixBearingCheckpoint>("bearing/checkpoint");
  add.template compute<ComputeBearingContact>("bearing/contact");
  add.template compute<ComputeBearingBall>("bearing/ball");
  add.template compute<ComputeBearingRing>("bearing/ring");
  add.template compute<ComputeBearingTotal>("bearing/total");
  add.template command<NameBearing>("bearing");
  add.template command<CreateBearing>("create_bearing");
  add.template command<BearingDump>("bearing_dump");
  add.template command<BearingResume>("bearing_resume");
  add.template command<RunBearing>("run_bearing");
}
