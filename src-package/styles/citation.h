// SPDX-License-Identifier: GPL-2.0-or-later
// The paper that describes the model implemented by these styles, for the host's list of citations.
#pragma once

#include "bearing_compat.h"
#if !BEARING_IS_LIGGGHTS
#include "citeme.h"
#endif

namespace bearing {

constexpr char citation[] =
    "Raceway bearing styles: doi:10.1051/meca/2020022\n\n"
    "@Article{Farah2020,\n"
    " author =  {S. O. Farah and M. Guessasma and E. Bellenger},\n"
    " title =   {Digital twin by {DEM} for ball bearing operating under {EHD} conditions},\n"
    " journal = {Mechanics \\& Industry},\n"
    " year =    2020,\n"
    " volume =  21,\n"
    " number =  5,\n"
    " pages =   {506}\n"
    "}\n\n";

// LAMMPS prints the first line of the citation at the end of the run and writes the whole citation
// to the log. LIGGGHTS would write a file log.cite to the folder in which it was started, so no
// citation is registered there.
inline void cite_paper(LAMMPS_NS::LAMMPS *lmp)
{
#if BEARING_IS_LIGGGHTS
  (void)lmp;
#else
  if (lmp->citeme) lmp->citeme->add(citation);
#endif
}

}    // namespace bearing
