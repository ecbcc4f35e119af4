// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>

// HDF5 1.10 crashes on damaged files, follows their lists without end, or takes as much memory as they say.
// So whatever it does with a file that was there before happens first in a ChildProcess.

namespace bedmix {

/// In the child: what comes next may take what an honest file of that size needs a fraction of.
void allowWorkOn(const std::filesystem::path& file);

/// In the child: what is wrong with what is done, for the parent; empty where nothing is.
std::string troubleOf(const std::function<void()>& work);

/// In the parent: what is wrong with a file on which the child has ended like this.
std::string damageShownBy(const std::string& end);

}  // namespace bedmix
