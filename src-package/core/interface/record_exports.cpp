// SPDX-License-Identifier: GPL-2.0-or-later
// Exports the checksum of records and their headers.
#include "../numbers/checksum.h"
#include "exports.h"

// Computes the checksums of the first `summed` numbers in each of `samples` rows of `width`
// numbers. `first` is the number of the first row.
EXPORT(void, record_checksums,
       (int samples, int width, int summed, int first, const int *rows, int *sums))
{
  for (int k = 0; k < samples; ++k)
    sums[k] = static_cast<int>(bearing::checksum(rows + static_cast<long>(k) * width,
                                                 4 * static_cast<size_t>(summed), first + k));
}
