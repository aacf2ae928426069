// SPDX-License-Identifier: BSD-3-Clause
// SIGINT and SIGTERM in batch mode.
#pragma once

namespace hogelscope {

/// Makes the two signals set mustStop() and end the process as by the signal, without temporary
/// files: when the job has stopped, after 0.3 s if nothing has called mustStop(), after 5 s in any
/// case, and at once for a second signal. Finished results are on disk already, so that the process
/// may end anywhere.
void catchSignals();

/// Whether a signal has arrived; called by every Progress of batch mode, from any thread.
bool mustStop();

/// Ends the process after the job has stopped.
[[noreturn]] void endBySignal();

}  // namespace hogelscope
