# SPDX-License-Identifier: BSD-3-Clause
# The target PclFilters::PclFilters: those libraries of PCL that the benchmarks compare with. PCL's own package file
# asks for VTK and MPI, which they do not need.
find_path(PclFilters_INCLUDE_DIR pcl/point_types.h PATH_SUFFIXES pcl-1.13 pcl-1.12 pcl-1.14)
set(PclFilters_LIBRARIES)
foreach(part common kdtree octree search filters segmentation)
  find_library(PclFilters_${part}_LIBRARY pcl_${part})
  mark_as_advanced(PclFilters_${part}_LIBRARY)
  list(APPEND PclFilters_LIBRARIES ${PclFilters_${part}_LIBRARY})
endforeach()
mark_as_advanced(PclFilters_INCLUDE_DIR)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(PclFilters REQUIRED_VARS PclFilters_segmentation_LIBRARY PclFilters_INCLUDE_DIR)
if(PclFilters_FOUND AND NOT TARGET PclFilters::PclFilters)
  add_library(PclFilters::PclFilters INTERFACE IMPORTED)
  set_target_properties(PclFilters::PclFilters PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${PclFilters_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${PclFilters_LIBRARIES};lz4")
endif()
