# SPDX-License-Identifier: BSD-3-Clause
# Intel's ISA-L, which runs on other processors too.
include(${CMAKE_CURRENT_LIST_DIR}/PlainLibrary.cmake)
offmap_find_plain_library(isal isa-l/igzip_lib.h isal)
