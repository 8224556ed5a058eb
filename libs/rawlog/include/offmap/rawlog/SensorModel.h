// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CObservation.h>

#include <string>

namespace offmap::rawlog {

/// Which device made an observation, as far as that can be told, for a person to read.
struct SensorModel {
    std::string name;     ///< "VLP-16", "depth camera"; empty: not known
    std::string details;  ///< "strongest return", "640 x 480"; may be empty

    friend bool operator==(const SensorModel&, const SensorModel&) = default;
};

SensorModel sensorModelOf(const mrpt::obs::CObservation& obs);

}  // namespace offmap::rawlog
