// SPDX-License-Identifier: GPL-2.0-or-later
// RACEWAY_TWO_TARGETS: lanes are compiled for processors with AVX2 and for those without. Not by
// sanitizers, not with RACEWAY_ONE_TARGET, and not for other families of processors.
#ifndef RACEWAY_TARGETS_H
#define RACEWAY_TARGETS_H

#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(RACEWAY_ONE_TARGET)
#define RACEWAY_TWO_TARGETS 1
#endif

#endif
