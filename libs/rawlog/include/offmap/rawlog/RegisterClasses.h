// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace offmap::rawlog {

/// Makes every observation and map class of MRPT known to its deserialiser. The linker drops MRPT's
/// own registration of libraries that are not called by name. Cheap and safe to call repeatedly.
void registerMrptClasses();

}  // namespace offmap::rawlog
