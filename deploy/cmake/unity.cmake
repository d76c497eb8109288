# Unity builds: the files of a target are compiled a dozen at a time, as what they include takes longer than they do. So
# names that a file keeps to itself are its folder's own too. A file with options or definitions of its own stays alone.
# deploy/compile_commands.py tells the checks how each file would be compiled by itself.
#
# race_unity(TARGET [EXCEPT file...]): the files EXCEPT stay alone.
function(race_unity target)
  cmake_parse_arguments(ARG "" "" "EXCEPT" ${ARGN})
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 12)
  set_source_files_properties(${ARG_EXCEPT} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
