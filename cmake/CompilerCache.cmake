# SPDX-License-Identifier: BSD-3-Clause
# ccache, if it is there. Precompiled headers need the relaxations below to be cacheable at all; with
# the base folder all clones of the project share their objects.
find_program(OFFMAP_CCACHE ccache)
if(OFFMAP_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
      CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} ${OFFMAP_CCACHE})
endif()
