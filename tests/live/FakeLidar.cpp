// SPDX-License-Identifier: BSD-3-Clause
#include "FakeLidar.h"

IMPLEMENTS_GENERIC_SENSOR(FakeLidar, offmap::test)
