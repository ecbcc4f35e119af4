// SPDX-License-Identifier: MIT
#pragma once

namespace bedmix::bench {

/// Resident memory of the process, bytes, once what is free has gone back to the system.
double memoryNow();
/// The largest it has been since forgetPeakMemory().
double peakMemory();
void forgetPeakMemory();

}  // namespace bedmix::bench
