// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/RegisterClasses.h>

#include <mrpt/maps/registerAllClasses.h>

#include <mutex>

namespace offmap::rawlog {

void registerMrptClasses() {
    static std::once_flag once;
    std::call_once(once, mrpt::maps::registerAllClasses_mrpt_maps);
}

}  // namespace offmap::rawlog
