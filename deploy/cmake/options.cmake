# race_options: what every target of ours is compiled with. Libraries' headers are system headers and do not warn.
find_package(Threads REQUIRED)

add_library(race_options INTERFACE)
target_compile_features(race_options INTERFACE cxx_std_20)
target_include_directories(race_options INTERFACE ${RACE_SOURCE_DIR})
target_compile_options(race_options INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Werror
  # g++ 12 warns at -O2 of an overlap in "literal" + std::to_string(x) that is not there; once <string> comes from a
  # precompiled header, it also warns of sizes inside of it, as it forgets that it is a system header.
  -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread
  # For ccache: preprocessed text names the precompiled header.
  -fpch-preprocess)
target_link_options(race_options INTERFACE -fuse-ld=lld)
if(RACE_SANITIZE)
  # What a sanitizer adds makes g++ 12 see uninitialised members in <regex>; the other builds keep the warning.
  target_compile_options(race_options INTERFACE -Wno-maybe-uninitialized)
endif()
if(RACE_SANITIZE STREQUAL "address")
  target_compile_options(race_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(race_options INTERFACE -fsanitize=address,undefined)
elseif(RACE_SANITIZE STREQUAL "thread")
  target_compile_options(race_options INTERFACE -fsanitize=thread -Wno-tsan)
  target_link_options(race_options INTERFACE -fsanitize=thread)
elseif(NOT RACE_SANITIZE STREQUAL "")
  message(FATAL_ERROR "RACE_SANITIZE is '${RACE_SANITIZE}': expected address, thread or nothing")
endif()
