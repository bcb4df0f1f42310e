// SPDX-License-Identifier: GPL-2.0-or-later
// compute bearing/contact: local data, a row per live raceway contact, columns as asked for.
#ifdef COMPUTE_CLASS
ComputeStyle(bearing/contact,ComputeBearingContact)
#else
#ifndef LMP_COMPUTE_BEARING_CONTACT_H
#define LMP_COMPUTE_BEARING_CONTACT_H

#include "../contacts/contact_attribute.h"

namespace LAMMPS_NS {

class ComputeBearingContact : public Compute {
 public:
  ComputeBearingContact(BRG_COMPUTE_ARGS);
  void init() override;
  void compute_local() override;
  double memory_usage() override;

 private:
  PairBearingHertz *pair_;
  std::vector<const bearing::ContactAttribute *> columns_;
  bearing::AttributeContext context_;
  std::vector<double> values_;
  std::vector<double *> rows_;
};

}    // namespace LAMMPS_NS

#endif
#endif
