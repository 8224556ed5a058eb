// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A function that is compiled once more for processors with AVX2; which one runs is chosen when
/// the program starts. Both give the same bits: nothing is contracted, lanes are as many on all.
/// Sanitizers cannot work before the program has started.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define OFFMAP_BY_PROCESSOR [[gnu::target_clones("arch=x86-64-v3", "default")]]
#else
#define OFFMAP_BY_PROCESSOR
#endif
