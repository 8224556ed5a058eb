// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CObservation.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CSerializable.h>

#include <cstddef>
#include <memory>
#include <string>

namespace offmap::rawlog {

/// The name of its class without namespaces, as MRPT's own programs show it.
inline std::string classNameOf(const mrpt::rtti::CObject& object) {
    const std::string name = object.GetRuntimeClass()->className;
    return name.substr(name.rfind(':') + 1);
}

/// Calls visit(observation, position) for the observation that a rawlog entry is, or for every one
/// of the sensory frame that it is.
template <class Visit>
void forEachObservation(const mrpt::serialization::CSerializable::Ptr& entry, Visit&& visit) {
    if (const auto obs = std::dynamic_pointer_cast<mrpt::obs::CObservation>(entry)) {
        visit(obs, size_t{0});
    } else if (const auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(entry)) {
        size_t position = 0;
        for (const mrpt::obs::CObservation::Ptr& member : *frame) {
            if (member) visit(member, position);
            ++position;
        }
    }
}

}  // namespace offmap::rawlog
