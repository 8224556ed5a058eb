# SPDX-License-Identifier: BSD-3-Clause
include(${CMAKE_CURRENT_LIST_DIR}/PlainLibrary.cmake)
offmap_find_plain_library(cairo cairo.h cairo PATH_SUFFIXES cairo)
