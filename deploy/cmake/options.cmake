# race_options: what every target of ours is compiled with. Libraries' headers are system headers and do not warn.
find_package(Threads REQUIRED)

add_library(race_options INTERFACE)
target_compile_features(race_options INTERFACE cxx_std_20)
target_include_directories(race_options INTERFACE ${RACE_SOURCE_DIR})
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(race_options INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Werror
    # g++ 12 warns at -O2 of an overlap in "literal" + std::to_string(x) that is not there; once <string> comes from a
    # precompiled header, it also warns of sizes inside of it, as it forgets that it is a system header.
    -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread
    # For ccache: preprocessed text names the precompiled header.
    -fpch-preprocess)
else()
  # Clang builds what sanitizers test, without optimization in a third of g++'s time. g++ and the checks with Clang warn.
  target_compile_options(race_options INTERFACE -Wno-everything
    # For ccache: a precompiled header depends on no time.
    "SHELL:-Xclang -fno-pch-timestamp")
endif()
target_link_options(race_options INTERFACE -fuse-ld=lld)
# RACE_OPTIMIZED: what a target is compiled with if its tests compute much. A sanitizer's build optimizes nothing else, and
# that of the fuzz targets nothing at all: it would take longer than they run.
set(RACE_OPTIMIZED "")
if(NOT RACE_SANITIZE STREQUAL "" AND NOT RACE_SANITIZE STREQUAL "fuzz")
  set(RACE_OPTIMIZED -O1)
endif()
if(RACE_SANITIZE STREQUAL "address" OR RACE_SANITIZE STREQUAL "fuzz")
  target_compile_options(race_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(race_options INTERFACE -fsanitize=address,undefined)
  if(RACE_SANITIZE STREQUAL "fuzz")  # what libFuzzer sees of the code; tests/fuzz links libFuzzer itself
    target_compile_options(race_options INTERFACE -fsanitize=fuzzer-no-link)
  endif()
elseif(RACE_SANITIZE STREQUAL "thread")
  target_compile_options(race_options INTERFACE -fsanitize=thread)
  target_link_options(race_options INTERFACE -fsanitize=thread)
elseif(NOT RACE_SANITIZE STREQUAL "")
  message(FATAL_ERROR "RACE_SANITIZE is '${RACE_SANITIZE}': expected address, fuzz, thread or nothing")
endif()
