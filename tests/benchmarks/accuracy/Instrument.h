// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/ReductionConfig.h>
#include <offmap/evaluation/Scanner.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace offmap::accuracy {

/// The methods that are compared, in the order of all tables.
inline constexpr std::array methods{core::MatchingMethod::Paper,
                                    core::MatchingMethod::Probabilistic,
                                    core::MatchingMethod::Aligned};
inline constexpr size_t methodCount = methods.size();
inline constexpr size_t paperMethod = 0, alignedMethod = 2;  // indices into methods

std::string_view nameOf(core::MatchingMethod method);

/// A scanner and the parameters that users give it.
struct Instrument {
    std::string name;
    evaluation::Scanner scanner;
    core::ReductionConfig config;
};

/// The paper's scanner with the default parameters, and the VLP-16 with those of its preset.
/// \throw std::runtime_error if the preset cannot be read
std::vector<Instrument> instruments();

}  // namespace offmap::accuracy
