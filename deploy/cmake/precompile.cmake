# Precompiled headers: what nearly every file includes is parsed once for each build. Files include what they use all the
# same: the checks that run Clang (deploy/check_locks, deploy/lint) have no precompiled header.
#
# race_precompile(TARGET): TARGET owns the precompiled header of the libraries.
# race_use_precompiled(TARGET): TARGET, a library of ours, uses it.
function(race_precompile target)
  target_precompile_headers(${target} PRIVATE <algorithm> <array> <charconv> <cmath> <cstddef> <cstdint> <cstdio> <deque>
    <functional> <limits> <map> <memory> <numbers> <optional> <set> <span> <string> <string_view> <utility> <variant>
    <vector> ${RACE_SOURCE_DIR}/core/value/expected.h ${RACE_SOURCE_DIR}/core/value/value.h)
endfunction()

function(race_use_precompiled target)
  target_precompile_headers(${target} REUSE_FROM race_core)
endfunction()
