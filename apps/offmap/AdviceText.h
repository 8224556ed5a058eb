// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "InfoAdvice.h"

#include <string>

namespace offmap::app {

/// What a log lacks, a numbered step each, and the command line that reduces it.
std::string adviceText(const Advice& advice);

/// An option and its value as a shell reads them: "--pose X,Y,YAW_DEG".
std::string optionText(const AdviceStep& step);

}  // namespace offmap::app
