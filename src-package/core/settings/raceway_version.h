// SPDX-License-Identifier: GPL-2.0-or-later
// The version of Raceway, which applies to the styles, the Python package and the documentation.
#pragma once

#define RACEWAY_VERSION "1.0.0"
