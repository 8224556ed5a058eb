# SPDX-License-Identifier: BSD-3-Clause
# What all targets of the project share: warnings, sanitizers, coverage, precompiled MRPT headers.

add_library(offmap_options INTERFACE)
target_compile_options(offmap_options INTERFACE -Wall -Wextra -Wconversion -Wshadow)
if(OFFMAP_WERROR)
  target_compile_options(offmap_options INTERFACE -Werror)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Without it, the address of a precompiled header changes its hash and nothing is ever cached.
  target_compile_options(offmap_options INTERFACE -fpch-preprocess)
endif()
if(OFFMAP_SANITIZE)
  set(sanitizers address,undefined)
  if(OFFMAP_SANITIZE STREQUAL "thread")
    set(sanitizers thread)
  endif()
  target_compile_options(offmap_options INTERFACE
    -fsanitize=${sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(offmap_options INTERFACE -fsanitize=${sanitizers})
endif()
if(OFFMAP_FUZZ)
  target_compile_options(offmap_options INTERFACE -g -fno-omit-frame-pointer
    -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all)
  target_link_options(offmap_options INTERFACE -fsanitize=address,undefined)
endif()
if(OFFMAP_COVERAGE)
  target_compile_options(offmap_options INTERFACE --coverage)
  target_link_options(offmap_options INTERFACE --coverage)
endif()

# offmap_add_library(NAME SOURCES... ): target offmap_NAME, alias offmap::NAME, headers in include/.
# Position independent, because others put it into plugins.
function(offmap_add_library name)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/include/*.h)
  add_library(offmap_${name} STATIC ${ARGN})
  add_library(offmap::${name} ALIAS offmap_${name})
  set_target_properties(offmap_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_sources(offmap_${name} PUBLIC FILE_SET HEADERS BASE_DIRS include FILES ${headers})
  target_compile_features(offmap_${name} PUBLIC cxx_std_20)
  target_link_libraries(offmap_${name} PRIVATE $<BUILD_INTERFACE:offmap_options>)
endfunction()

# offmap_add_test(NAME [LABEL label] [BINARY program] [TIMEOUT seconds] LIBS... SOURCES...): one GTest binary per tested
# library; tests of a program are told where it is.
function(offmap_add_test name)
  cmake_parse_arguments(ARG "" "LABEL;BINARY;TIMEOUT" "SOURCES;LIBS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE offmap_options ${ARG_LIBS} GTest::gtest GTest::gmock)
  # Only for this file, so that ccache knows the others again in another clone.
  set(places OFFMAP_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(ARG_BINARY)
    list(APPEND places OFFMAP_BINARY="$<TARGET_FILE:${ARG_BINARY}>")
    add_dependencies(${name} ${ARG_BINARY})
  endif()
  set_source_files_properties(${PROJECT_SOURCE_DIR}/tests/support/main.cpp
    PROPERTIES COMPILE_DEFINITIONS "${places}")
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  include(GoogleTest)
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT ${ARG_TIMEOUT} LABELS "${ARG_LABEL}")
endfunction()
