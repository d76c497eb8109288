# Precompiled headers: what nearly every file includes of libraries is parsed once for each build. Headers of ours are not
# precompiled: g++ recognizes a `#pragma once` file by its time, which differs when ccache has kept the precompiled header.
# Files include what they use all the same: the checks with Clang (deploy/check_locks, deploy/lint) precompile nothing.
#
# race_precompile(TARGET): TARGET owns the precompiled header of the libraries.
# race_use_precompiled(TARGET): TARGET, a library of ours, uses it.
function(race_precompile target)
  target_precompile_headers(${target} PRIVATE <algorithm> <array> <charconv> <cmath> <cstddef> <cstdint> <cstdio> <deque>
    <functional> <limits> <map> <memory> <numbers> <optional> <set> <span> <string> <string_view> <utility> <variant>
    <vector> <tl/expected.hpp>)
endfunction()

function(race_use_precompiled target)
  target_precompile_headers(${target} REUSE_FROM race_core)
endfunction()
