# SPDX-License-Identifier: BSD-3-Clause
# offmap_find_plain_library(NAME HEADER LIBRARY [options of find_path]): what a find module does for a library that
# comes without a package file for CMake: the target NAME::NAME. Installed with offmap's package, whose users need no
# pkg-config.
include(FindPackageHandleStandardArgs)

macro(offmap_find_plain_library name header library)
  find_path(${name}_INCLUDE_DIR ${header} ${ARGN})
  find_library(${name}_LIBRARY ${library})
  mark_as_advanced(${name}_INCLUDE_DIR ${name}_LIBRARY)
  find_package_handle_standard_args(${name} REQUIRED_VARS ${name}_LIBRARY ${name}_INCLUDE_DIR)
  if(${name}_FOUND AND NOT TARGET ${name}::${name})
    add_library(${name}::${name} UNKNOWN IMPORTED)
    set_target_properties(${name}::${name} PROPERTIES
      IMPORTED_LOCATION "${${name}_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${${name}_INCLUDE_DIR}")
  endif()
endmacro()
