// SPDX-License-Identifier: BSD-3-Clause
// Where methods fail: which inverse of a lens finds the right root, and the other unstable places.
#pragma once
