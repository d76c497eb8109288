# race_test(NAME SOURCES file... [LIBS target...] [LABELS label...] [TIMEOUT seconds] [SHARDS count] [COST cost]
# [ALONE file...]): a GoogleTest program NAME, registered with CTest as one test. Its cases see RACE_SOURCE_DIR (the
# project's folder) as a string literal.
#
# SHARDS: a long program is registered so many times, as NAME_0, NAME_1, ..., and GoogleTest shares its cases out; CTest runs
# them side by side. Each has a name of the program of its own, as GoogleTest names the report after it. COST: CTest begins
# with what costs most.
#
# Test files are compiled without optimization, as they are compiled more often than they run; what they test is
# optimized. A file that does much itself stands in a library of its own (semantics_random_cases).
#
# Labels: the room under test (`core`, `services`, `server`, `application`; by default that of the folder tests/unit/ROOM),
# `threads` for programs whose tests use several, which the thread sanitizer runs, and `slow` for what takes more than some
# seconds. The test programs of a room, and those with `threads`, are built together by the target tests_LABEL.
find_package(GTest REQUIRED)

# race_test_main: main() of the test programs, and their precompiled header.
add_library(race_test_main STATIC ${RACE_SOURCE_DIR}/tests/unit/main.cpp)
target_link_libraries(race_test_main PUBLIC race_options GTest::gtest GTest::gmock)
target_compile_options(race_test_main PRIVATE -O0)
target_precompile_headers(race_test_main PRIVATE <gmock/gmock.h> <gtest/gtest.h> <algorithm> <array> <atomic> <chrono>
  <cmath> <cstdint> <deque> <filesystem> <fstream> <functional> <future> <limits> <map> <memory> <mutex> <optional>
  <random> <set> <span> <sstream> <string> <string_view> <thread> <utility> <variant> <vector>
  <tl/expected.hpp>)

set(RACE_TEST_ROOMS core services server application)
set(RACE_TEST_TARGETS ${RACE_TEST_ROOMS} threads)
set(RACE_TEST_LABELS ${RACE_TEST_TARGETS} slow)
foreach(label ${RACE_TEST_TARGETS})
  add_custom_target(tests_${label})
endforeach()

function(race_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT;SHARDS;COST" "SOURCES;LIBS;LABELS;ALONE" ${ARGN})
  if(CMAKE_CURRENT_SOURCE_DIR MATCHES "/tests/unit/([a-z]+)")
    list(APPEND ARG_LABELS ${CMAKE_MATCH_1})
    list(REMOVE_DUPLICATES ARG_LABELS)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE race_test_main ${ARG_LIBS})
  target_compile_options(${name} PRIVATE -O0)
  target_precompile_headers(${name} REUSE_FROM race_test_main)
  race_unity(${name} EXCEPT ${ARG_ALONE})
  target_compile_definitions(${name} PRIVATE RACE_SOURCE_DIR="${RACE_SOURCE_DIR}")
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  if(RACE_SANITIZE)  # deploy/soak takes all cases there, too
    math(EXPR ARG_TIMEOUT "5 * ${ARG_TIMEOUT}")
  endif()
  race_register_test(${name} "${ARG_SHARDS}")
  set_tests_properties(${race_registered} PROPERTIES TIMEOUT ${ARG_TIMEOUT} LABELS "${ARG_LABELS}")
  if(RACE_SANITIZE)  # of binutils, which is there with any compiler; each sanitizer looks for its own variable
    set_tests_properties(${race_registered} PROPERTIES ENVIRONMENT_MODIFICATION
      "ASAN_SYMBOLIZER_PATH=set:/usr/bin/addr2line;TSAN_SYMBOLIZER_PATH=set:/usr/bin/addr2line;UBSAN_SYMBOLIZER_PATH=set:/usr/bin/addr2line")
  endif()
  if(ARG_COST)
    set_tests_properties(${race_registered} PROPERTIES COST ${ARG_COST})
  endif()
  foreach(label ${ARG_LABELS})
    if(NOT label IN_LIST RACE_TEST_LABELS)
      message(FATAL_ERROR "race_test(${name}): there is no label '${label}', only ${RACE_TEST_LABELS}")
    endif()
    if(label IN_LIST RACE_TEST_TARGETS)
      add_dependencies(tests_${label} ${name})
    endif()
  endforeach()
endfunction()

# race_register_test(NAME SHARDS): tells CTest of the program, and sets race_registered to the names of its tests.
function(race_register_test name shards)
  if(NOT shards)
    add_test(NAME ${name} COMMAND ${name})
    set(race_registered ${name} PARENT_SCOPE)
    return()
  endif()
  math(EXPR last "${shards} - 1")
  foreach(shard RANGE ${last})
    set(link ${CMAKE_CURRENT_BINARY_DIR}/${name}_${shard})
    add_custom_command(TARGET ${name} POST_BUILD COMMAND ${CMAKE_COMMAND} -E create_symlink ${name} ${link})
    add_test(NAME ${name}_${shard} COMMAND ${link})
    set_tests_properties(${name}_${shard} PROPERTIES
      ENVIRONMENT "GTEST_TOTAL_SHARDS=${shards};GTEST_SHARD_INDEX=${shard}")
    list(APPEND names ${name}_${shard})
  endforeach()
  set(race_registered ${names} PARENT_SCOPE)
endfunction()
