# The stability experiments on compiler flags compile one kernel several times (core/study/stability/build_flags). Flags
# of a file follow those of the program, so they win, -O2 over what a sanitizer asks for. What a processor may lack is
# asked for at run time.
set(build_flags_dir core/study/stability/build_flags)
set_source_files_properties(${build_flags_dir}/unoptimised.cpp PROPERTIES COMPILE_OPTIONS "-O0")
set_source_files_properties(${build_flags_dir}/fast.cpp PROPERTIES COMPILE_OPTIONS "-O2;-ffast-math")
set(has_x87 0)  # the compiler can be told to compute in the x87 unit
set(fma_flags "-ffp-contract=fast")
set(unfused_flags "-ffp-contract=off")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  list(APPEND fma_flags "-mfma")
  list(APPEND unfused_flags "-mavx2" "-mfma")
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set(has_x87 1)
    set_source_files_properties(${build_flags_dir}/x87.cpp PROPERTIES COMPILE_OPTIONS "-mfpmath=387")
  endif()
endif()
set_source_files_properties(${build_flags_dir}/x87.cpp PROPERTIES COMPILE_DEFINITIONS "PS_HAS_X87=${has_x87}")
set_source_files_properties(${build_flags_dir}/contracted.cpp PROPERTIES COMPILE_OPTIONS "${fma_flags};-O2")
set_source_files_properties(${build_flags_dir}/uncontracted.cpp PROPERTIES COMPILE_OPTIONS "${unfused_flags};-O2")
set_source_files_properties(${build_flags_dir}/fast_contracted.cpp PROPERTIES COMPILE_OPTIONS "${fma_flags};-O2;-ffast-math")
