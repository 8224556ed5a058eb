// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/VelodyneCalibration.h>

namespace offmap::rawlog {

/// The lasers of Velodynes as they leave the factory.
struct FactoryCalibrations {
    mrpt::obs::VelodyneCalibration vlp16, hdl32;
};

/// MRPT's, asked for once and both together: what MRPT keeps them in has no lock.
const FactoryCalibrations& factoryCalibrations();

}  // namespace offmap::rawlog
