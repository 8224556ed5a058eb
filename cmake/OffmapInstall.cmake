# SPDX-License-Identifier: BSD-3-Clause
# What `cmake --install` puts where, and the package that find_package(offmap) finds there.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(OFFMAP_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/offmap)

# offmap_install_library(NAME [NEEDS libraries...] [FINDS packages...]): the library becomes the
# component NAME of the package. It needs other libraries of the project and finds packages of others.
function(offmap_install_library name)
  cmake_parse_arguments(ARG "" "" "NEEDS;FINDS" ${ARGN})
  install(TARGETS offmap_${name} EXPORT offmap-${name}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} FILE_SET HEADERS DESTINATION include)
  install(EXPORT offmap-${name} NAMESPACE offmap:: FILE offmap-${name}-targets.cmake
    DESTINATION ${OFFMAP_PACKAGE_DIR})
  set(component ${PROJECT_BINARY_DIR}/package/offmap-${name}.cmake)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/offmap-component.cmake.in ${component} @ONLY)
  install(FILES ${component} DESTINATION ${OFFMAP_PACKAGE_DIR})
  set_property(GLOBAL APPEND PROPERTY offmap_components ${name})
endfunction()

# offmap_install_package(): the package of all components so far, the documents and the samples.
function(offmap_install_package)
  get_property(OFFMAP_COMPONENTS GLOBAL PROPERTY offmap_components)
  set(package ${PROJECT_BINARY_DIR}/package)
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/offmapConfig.cmake.in
    ${package}/offmapConfig.cmake INSTALL_DESTINATION ${OFFMAP_PACKAGE_DIR}
    NO_SET_AND_CHECK_MACRO)
  write_basic_package_version_file(${package}/offmapConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
  install(FILES ${package}/offmapConfig.cmake ${package}/offmapConfigVersion.cmake
    cmake/PlainLibrary.cmake cmake/Findcairo.cmake cmake/Findisal.cmake cmake/Findlibdeflate.cmake
    DESTINATION ${OFFMAP_PACKAGE_DIR})

  install(DIRECTORY config share/maps DESTINATION ${CMAKE_INSTALL_DATADIR}/offmap)
  # As they stand in the sources, so that the links between them hold.
  install(FILES README.md LICENSE CHANGELOG.md CONTRIBUTING.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
  install(DIRECTORY doc DESTINATION ${CMAKE_INSTALL_DOCDIR})
endfunction()
