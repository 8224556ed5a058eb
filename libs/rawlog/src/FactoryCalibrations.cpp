// SPDX-License-Identifier: BSD-3-Clause
#include "FactoryCalibrations.h"

namespace offmap::rawlog {

const FactoryCalibrations& factoryCalibrations() {
    using mrpt::obs::VelodyneCalibration;
    static const FactoryCalibrations both{VelodyneCalibration::LoadDefaultCalibration("VLP16"),
                                          VelodyneCalibration::LoadDefaultCalibration("HDL32")};
    return both;
}

}  // namespace offmap::rawlog
