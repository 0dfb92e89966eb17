# Targets from folders: adding a source file never needs an edit here. A folder without sources gives no target (a
# program) or an empty one (a library), so everything may link it at once.

# ps_sources(VAR FOLDER): every .cpp under FOLDER, looked up again at each build.
function(ps_sources variable folder)
  file(GLOB_RECURSE found CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${folder}/*.cpp)
  set(${variable} ${found} PARENT_SCOPE)
endfunction()

# ps_library(NAME SOURCE...): a static library, or an interface library while there are no sources.
function(ps_library name)
  if(ARGN)
    add_library(${name} STATIC ${ARGN})
    target_compile_options(${name} PRIVATE ${PIXELSCOPE_WARNINGS})
  else()
    add_library(${name} INTERFACE)
  endif()
endfunction()

# ps_program(NAME SOURCE...): a program in bin/, or nothing while there are no sources.
function(ps_program name)
  if(ARGN)
    add_executable(${name} ${ARGN})
    target_compile_options(${name} PRIVATE ${PIXELSCOPE_WARNINGS})
  endif()
endfunction()

# ps_compile_quickly(NAME): for what takes no time to run, as the work is done in libraries: optimised less, and under a
# sanitizer not at all, where that is a third of the time to compile.
function(ps_compile_quickly name)
  if(NOT TARGET ${name})
    return()
  endif()
  if(PIXELSCOPE_SANITIZE)
    target_compile_options(${name} PRIVATE -O0)
  else()
    target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
endfunction()

# ps_link and ps_include: as target_link_libraries and target_include_directories, for targets that may be absent or
# empty.
function(ps_scope name given result)
  get_target_property(type ${name} TYPE)
  if(type STREQUAL "INTERFACE_LIBRARY")
    set(given INTERFACE)
  endif()
  set(${result} ${given} PARENT_SCOPE)
endfunction()

function(ps_link name scope)
  if(TARGET ${name})
    ps_scope(${name} ${scope} scope)
    target_link_libraries(${name} ${scope} ${ARGN})
  endif()
endfunction()

function(ps_include name scope)
  if(TARGET ${name})
    ps_scope(${name} ${scope} scope)
    target_include_directories(${name} ${scope} ${ARGN})
  endif()
endfunction()

# ps_unity(TARGET...): compiles the files of a folder together, 32 at a time, in less than a third of the time. A folder
# is one of the second level with all below it (core/raster, app/gui); the listings of all lessons count as one, and so
# do all files of a target that has no more than 32. So names within such a folder are unique, or lie in namespaces of
# their own. A file that Highway compiles once per SIMD target stays alone; so does, by CMake's own rule, a file with
# flags or definitions of its own.
function(ps_unity)
  set(together 32)
  foreach(target ${ARGN})
    if(TARGET ${target})
      set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
      get_target_property(sources ${target} SOURCES)
      list(LENGTH sources count)
      foreach(source ${sources})
        cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
        set(per_target "")
        if(EXISTS ${source})  # what the build writes is not there yet, and is none of these
          file(STRINGS ${source} per_target REGEX "hwy/foreach_target.h" LIMIT_COUNT 1)
        endif()
        if(per_target)
          continue()
        endif()
        cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${CMAKE_SOURCE_DIR} OUTPUT_VARIABLE place)
        string(REGEX REPLACE "^([^/]*/[^/]*)/.*" "\\1" folder ${place})
        string(REGEX REPLACE "^chapters/.*" "listings" folder ${folder})
        if(count LESS_EQUAL together)
          set(folder all)
        endif()
        string(MAKE_C_IDENTIFIER ${folder} folder)
        if(NOT DEFINED members_${target}_${folder})
          set(members_${target}_${folder} 0)
        endif()
        math(EXPR group "${members_${target}_${folder}} / ${together}")
        math(EXPR members_${target}_${folder} "${members_${target}_${folder}} + 1")
        set_property(SOURCE ${source} TARGET_DIRECTORY ${target} PROPERTY UNITY_GROUP ${folder}_${group})
      endforeach()
    endif()
  endforeach()
endfunction()
