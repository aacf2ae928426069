// SPDX-License-Identifier: BSD-3-Clause
// Where methods fail.
#include "study/stability.h"
