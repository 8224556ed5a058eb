// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/LogEntry.h>
#include <offmap/rawlog/Serialised.h>

#include <mrpt/obs/CSensoryFrame.h>

#include <algorithm>
#include <memory>

namespace offmap::rawlog {

using mrpt::obs::CObservation;
using mrpt::obs::CSensoryFrame;

namespace {

using Choice = CObservation::Ptr Replacement::*;

CSensoryFrame::Ptr replacedFrame(const CSensoryFrame& frame,
                                 const std::vector<Replacement>& replacements, Choice choice) {
    auto out = CSensoryFrame::Create();
    size_t position = 0;
    for (const CObservation::Ptr& member : frame) {
        CObservation::Ptr chosen = member;
        for (const Replacement& replacement : replacements) {
            if (replacement.position == position && replacement.*choice) {
                chosen = replacement.*choice;
            }
        }
        out->push_back(chosen);
        ++position;
    }
    return out;
}

void append(const LogEntry& entry, Choice choice, const std::vector<CObservation::Ptr>& poses,
            std::vector<std::byte>& to) {
    const auto frame = std::dynamic_pointer_cast<CSensoryFrame>(entry.object);
    const bool changes = (frame && !poses.empty()) ||
                         std::ranges::any_of(entry.replacements,
                                             [&](const auto& r) { return r.*choice != nullptr; });
    if (!changes) {
        to.insert(to.end(), entry.bytes.begin(), entry.bytes.end());
    } else if (frame) {
        const auto out = replacedFrame(*frame, entry.replacements, choice);
        for (const CObservation::Ptr& pose : poses) out->push_back(pose);
        serialise(*out, to);
        return;
    } else {
        serialise(*(entry.replacements.front().*choice), to);
    }
    for (const CObservation::Ptr& pose : poses) serialise(*pose, to);
}

}  // namespace

void appendReduced(const LogEntry& entry, std::vector<std::byte>& to) {
    append(entry, &Replacement::reduced, entry.poses, to);
}

void appendRemoved(const LogEntry& entry, std::vector<std::byte>& to) {
    append(entry, &Replacement::removed, {}, to);
}

}  // namespace offmap::rawlog
