// SPDX-License-Identifier: GPL-2.0-or-later
// Output of fix bearing/implicit: statistics of its substeps and the energy balance.
#include "../core/figures/fix_columns.h"
#include "fix_bearing_implicit_solver.h"

#include <algorithm>

using namespace LAMMPS_NS;
using raceway::BearingIntegrator;

// Computes the energy stored before the first step of a run.
void FixBearingImplicit::begin_energy()
{
  stored_before_ = 0.0;
  for (const auto &integrator : solver_->integrators) stored_before_ += integrator->energy().stored;
  MPI_Allreduce(MPI_IN_PLACE, &stored_before_, 1, MPI_DOUBLE, MPI_SUM, world);
  begun_ = true;
}

double FixBearingImplicit::compute_scalar()
{
  return compute_vector(bearing::of_fix_implicit::MEAN_STEP);
}

double FixBearingImplicit::systems() const
{
  double n = static_cast<double>(solver_->own.size());
  MPI_Allreduce(MPI_IN_PLACE, &n, 1, MPI_DOUBLE, MPI_SUM, world);
  return n;
}

// Returns the totals over all bearings since the start of the run (bearing::of_fix_implicit).
// Energies are 0 unless they were requested.
double FixBearingImplicit::compute_vector(int k)
{
  BearingIntegrator::Energy e = solver_->energy;
  for (const auto &integrator : solver_->integrators)
    if (energy_wanted_) {
      const BearingIntegrator::Energy &now = integrator->energy();
      e.work += now.work;
      e.dissipated += now.dissipated;
      e.stored += now.stored;
    }
  double sum[] = {substeps_, corrections_, refused_, static_cast<double>(solver_->own.size()),
                  e.work,    e.dissipated, e.stored};
  double most[] = {worst_, -smallest_};
  MPI_Allreduce(MPI_IN_PLACE, sum, 7, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(MPI_IN_PLACE, most, 2, MPI_DOUBLE, MPI_MAX, world);
  const double n = std::max(sum[0], 1.0), bearings = std::max(sum[3], 1.0),
               stored = sum[6] - stored_before_;
  using namespace bearing::of_fix_implicit;
  switch (k) {
    case MEAN_STEP: return time_ * bearings / n;
    case SMALLEST_STEP: return sum[0] > 0.0 ? -most[1] : 0.0;
    case STEPS: return sum[0];
    case CORRECTIONS: return sum[1] / n;
    case REFUSED: return sum[2];
    case ERROR: return most[0];
    case WORK: return sum[4];
    case DISSIPATED: return sum[5];
    case STORED: return energy_wanted_ ? stored : 0.0;
    case LOST: return energy_wanted_ ? sum[4] - sum[5] - stored : 0.0;
  }
  return 0.0;
}
