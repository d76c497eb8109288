# Precompiled headers: what nearly every file includes of libraries is parsed once for each build. Headers of ours are not
# precompiled: g++ recognizes a `#pragma once` file by its time, which differs when ccache has kept the precompiled header.
# Files include what they use all the same: the checks with Clang (deploy/check_locks, deploy/lint) precompile nothing.
#
# race_precompile(TARGET): TARGET owns a precompiled header of the libraries.
# race_use_precompiled(TARGET): TARGET, a library of ours, uses race_core's; in a sanitizer's build, where only race_core is
# optimized, that of the first such TARGET, as a precompiled header is for one level of optimization.
function(race_precompile target)
  target_precompile_headers(${target} PRIVATE <algorithm> <array> <charconv> <cmath> <cstddef> <cstdint> <cstdio> <deque>
    <functional> <limits> <map> <memory> <numbers> <optional> <set> <span> <string> <string_view> <utility> <variant>
    <vector> <tl/expected.hpp>)
endfunction()

function(race_use_precompiled target)
  get_property(owner GLOBAL PROPERTY RACE_PRECOMPILED)
  if(RACE_SANITIZE AND NOT owner)
    set_property(GLOBAL PROPERTY RACE_PRECOMPILED ${target})
    race_precompile(${target})
  elseif(RACE_SANITIZE)
    target_precompile_headers(${target} REUSE_FROM ${owner})
  else()
    target_precompile_headers(${target} REUSE_FROM race_core)
  endif()
endfunction()
