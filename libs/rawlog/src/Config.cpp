// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/ParameterTable.h>

namespace offmap::rawlog {

void Config::validate() const {
    for (const Parameter& p : parameters()) p.check(*this);
    reduction.validate();
    sensor.validate();
}

}  // namespace offmap::rawlog
