# What every target of ours shares: the include root, warnings, sanitizers and embedded texts.
include_guard()

set(umbra_unity_batch 8)  # sources that are compiled as one where UMBRA_UNITY is on

add_library(umbra_options INTERFACE)
target_include_directories(umbra_options INTERFACE ${CMAKE_SOURCE_DIR})
target_compile_options(umbra_options INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Wno-missing-field-initializers
  # GCC 12 sees overlapping copies in std::string's operator+ where there are none (bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  $<$<BOOL:${UMBRA_WARNINGS_ARE_ERRORS}>:-Werror>
  $<$<BOOL:${UMBRA_SANITIZE}>:-fsanitize=address,undefined -fno-omit-frame-pointer>)
target_link_options(umbra_options INTERFACE
  $<$<BOOL:${UMBRA_SANITIZE}>:-fsanitize=address,undefined>)

# Compiles headers that nearly every source of a target includes once, instead of once a source:
# the standard library's and Eigen's, and those given. Sources still include what they use;
# `-DUMBRA_PRECOMPILE=OFF -DUMBRA_UNITY=OFF` proves it.
#
# `group` names targets that are compiled with the same options; those of one that give the same
# headers share what the first of them compiles. Where all sources are compiled as one there is nothing
# to share.
function(umbra_precompile target group)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  list(LENGTH sources count)
  if(UMBRA_PRECOMPILE AND NOT (UMBRA_UNITY AND count LESS_EQUAL umbra_unity_batch))
    string(MAKE_C_IDENTIFIER "umbra precompiled ${group} ${ARGN}" shared)
    get_property(first GLOBAL PROPERTY ${shared})
    if(first)
      target_precompile_headers(${target} REUSE_FROM ${first})
    else()
      set_property(GLOBAL PROPERTY ${shared} ${target})
      target_precompile_headers(${target} PRIVATE
        <algorithm> <array> <cmath> <functional> <map> <memory> <optional> <span> <string> <vector>
        <Eigen/Core> <Eigen/Geometry> <Eigen/LU> ${ARGN})
    endif()
    # GCC forgets that what it has precompiled is the library's, and reports on std::string what it
    # keeps to itself otherwise.
    target_compile_options(${target} PRIVATE
      "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread>")
  endif()
endfunction()

# Compiles a target's sources several at a time, where that is asked for: they share the headers of the
# library and of VTK, which take most of the time. Sources given stay alone.
function(umbra_unity target)
  set_target_properties(${target} PROPERTIES
    UNITY_BUILD ${UMBRA_UNITY} UNITY_BUILD_BATCH_SIZE ${umbra_unity_batch})
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# One object library per layer. Its sources are every .cpp of the calling folder and its rooms, but the tests
# (*Test.cpp), so that adding a file edits no list. PRECOMPILE is followed by headers.
function(umbra_layer name)
  cmake_parse_arguments(PARSE_ARGV 1 layer "" "" PRECOMPILE)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cpp *.h)
  list(FILTER sources EXCLUDE REGEX "Test\\.cpp$")
  add_library(${name} OBJECT ${sources})
  target_link_libraries(${name} PUBLIC umbra_options ${layer_UNPARSED_ARGUMENTS})
  umbra_precompile(${name} layer ${layer_PRECOMPILE})
  umbra_unity(${name})
endfunction()

# What every test program shares, with the headers that most of its sources include. A test spends
# its time in the library under test, so that optimising the test itself only costs time to build.
function(umbra_test_program name)
  target_link_libraries(${name} PRIVATE umbra_options)
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  umbra_precompile(${name} test ${ARGN})
  umbra_unity(${name})
endfunction()

# Every *Test.cpp of the calling folder and those below, as one GoogleTest program whose cases CTest lists. Nothing
# where the tests are not built.
function(umbra_unit_tests name)
  if(NOT UMBRA_TESTS)
    return()
  endif()
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS *Test.cpp)
  if(sources)
    add_executable(${name} ${sources})
    target_link_libraries(${name} PRIVATE GTest::gtest_main ${ARGN})
    umbra_test_program(${name} <gtest/gtest.h>)
    gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60)
  endif()
endfunction()

# Makes texts (.glsl, .md) of the calling folder available as C++ string constants:
# Blur.glsl becomes `extern const char* Blur_glsl;` in "Blur_glsl.h", included without a path.
function(umbra_embed target)
  foreach(file IN LISTS ARGN)
    get_filename_component(stem ${file} NAME)
    string(MAKE_C_IDENTIFIER ${stem} identifier)
    vtk_encode_string(INPUT ${CMAKE_CURRENT_SOURCE_DIR}/${file} NAME ${identifier}
                      HEADER_OUTPUT header SOURCE_OUTPUT source)
    target_sources(${target} PRIVATE ${source} ${header})
  endforeach()
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
endfunction()
