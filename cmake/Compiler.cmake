# Flags for every target. No -ffast-math and no contraction: pictures are the same bits on every machine.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
if(NOT PIXELSCOPE_SANITIZE)  # the presets of the sanitizers bring their own
  set(CMAKE_CXX_FLAGS_DEBUG "-Og -g -D_GLIBCXX_ASSERTIONS")
endif()

# -fno-math-errno only lets sqrt be one instruction; values are untouched.
add_compile_options(-ffp-contract=off -fno-math-errno)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 drops the rounding of double -> float -> double where it vectorises straight-line code (tests/unit/narrowing_test.cpp).
  add_compile_options(-fno-tree-slp-vectorize)
endif()

set(PIXELSCOPE_WARNINGS -Wall -Wextra -Wconversion -Wshadow)
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  list(APPEND PIXELSCOPE_WARNINGS -Wno-sign-conversion)  # part of -Wconversion in clang, not in GCC
endif()
if(PIXELSCOPE_WERROR)
  list(APPEND PIXELSCOPE_WARNINGS -Werror)
endif()

if(PIXELSCOPE_SANITIZE)
  add_compile_options(-fsanitize=${PIXELSCOPE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${PIXELSCOPE_SANITIZE} -fno-sanitize-recover=all)
  if(PIXELSCOPE_SANITIZE MATCHES "address.*undefined" AND NOT PIXELSCOPE_FUZZ)
    # What these two look for the address sanitizer finds as well; kernels take a quarter longer to compile with them.
    add_compile_options(-fno-sanitize=null,object-size)
  endif()
endif()

if(PIXELSCOPE_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    message(FATAL_ERROR "The fuzz targets need clang; use `cmake --preset fuzz`.")
  endif()
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

# A compiler cache, where one is installed. It takes paths below the checkout as relative to it and leaves out the folder of
# the build, so a clone in another folder finds what this one has compiled.
if(PIXELSCOPE_USE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  find_program(PIXELSCOPE_CCACHE ccache)
  if(PIXELSCOPE_CCACHE)
    set(CMAKE_CXX_COMPILER_LAUNCHER
        ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${PIXELSCOPE_CCACHE})
  endif()
endif()

# Once from nothing, 32 files at once are quicker; with a compiler cache, and after a change, files alone are.
if(CMAKE_CXX_COMPILER_LAUNCHER)
  set(unity_by_default OFF)
else()
  set(unity_by_default ON)
endif()
option(PIXELSCOPE_UNITY "Compile 32 files of a target as one" ${unity_by_default})
# Together they are included by their whole paths, which the cache would otherwise see in the text of an assertion.
if(PIXELSCOPE_UNITY AND CMAKE_CXX_COMPILER_LAUNCHER)
  add_compile_options(-fmacro-prefix-map=${CMAKE_SOURCE_DIR}/=)
endif()

# GCC looks for memory to free from 128 MB on, and then files that are compiled together need up to 1.2 GB. Where there is
# enough for three compilers on two cores, a limit of 1 GB (up to 1.7 GB in all) saves a tenth of the time.
if(PIXELSCOPE_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  cmake_host_system_information(RESULT megabytes QUERY TOTAL_PHYSICAL_MEMORY)
  cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
  math(EXPR megabytes_for_each_core "${megabytes} / ${cores}")
  if(megabytes_for_each_core GREATER_EQUAL 2600)
    add_compile_options("SHELL:--param ggc-min-heapsize=1000000")
  endif()
endif()

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
