// SPDX-License-Identifier: BSD-3-Clause
// What SIGINT and SIGTERM do in batch mode.
#pragma once

namespace hogelscope {

/// From now on the two signals make mustStop() true, and the process ends as by the signal and
/// without temporary files: when the job has stopped, after 0.3 s where nothing has asked
/// mustStop(), after 5 s in any case, and at once with a second signal. Whatever is finished is on
/// the disk already, so that the end may come anywhere.
void catchSignals();

/// Asked by every Progress of batch mode, from any thread.
bool mustStop();

/// The end of a job that has stopped.
[[noreturn]] void endBySignal();

}  // namespace hogelscope
