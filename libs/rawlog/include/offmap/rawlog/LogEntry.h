// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CObservation.h>
#include <mrpt/serialization/CSerializable.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace offmap::rawlog {

/// What an observation of an entry becomes.
struct Replacement {
    size_t position = 0;                   ///< in the sensory frame
    mrpt::obs::CObservation::Ptr reduced;  ///< null: as it was
    mrpt::obs::CObservation::Ptr removed;  ///< null: as it was
};

/// An entry of a log on its way to the outputs.
struct LogEntry {
    uint64_t index = 0;
    std::vector<std::byte> bytes;                    ///< as they stood in the uncompressed stream
    mrpt::serialization::CSerializable::Ptr object;  ///< null if nothing in it can be reduced
    std::vector<Replacement> replacements;
    /// Refined, of turns that begin here: to be written behind it, or as a frame's last members.
    std::vector<mrpt::obs::CObservation::Ptr> poses;
    size_t unresolved = 0;  ///< observations whose turn is not reduced yet
};

/// Appends what the reduced log holds of the entry.
void appendReduced(const LogEntry& entry, std::vector<std::byte>& to);
/// Appends what the log of the removed returns holds of it.
void appendRemoved(const LogEntry& entry, std::vector<std::byte>& to);

}  // namespace offmap::rawlog
