# Writes experiments_table.h: the stability experiments, found as the constants that the files of core/study/stability/
# define, each with the line
#   extern const StabilityExperiment NAME{
# Each file has a namespace of its own, named like the file, so that experiments may use the same words.
# It defines one list, to be used with a macro of two arguments: PS_STABILITY_EXPERIMENTS(X) is X(FILE, NAME) for each of
# them.

file(GLOB experiment_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/core/study/stability/*.cpp)
# A constant may come to a file that is there already.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${experiment_sources})
set(all_experiments "")
foreach(source ${experiment_sources})
  get_filename_component(file ${source} NAME_WE)
  file(STRINGS ${source} lines REGEX "^extern const StabilityExperiment [a-z0-9_]+{")
  foreach(line ${lines})
    string(REGEX REPLACE "^extern const StabilityExperiment ([a-z0-9_]+){.*" "\\1" name "${line}")
    string(APPEND all_experiments " X(${file}, ${name})")
  endforeach()
endforeach()

set(experiments_include ${CMAKE_BINARY_DIR}/generated/experiments)
file(CONFIGURE OUTPUT ${experiments_include}/experiments_table.h @ONLY CONTENT [[
// Written by cmake/Experiments.cmake from the files of core/study/stability/.
#pragma once
#define PS_STABILITY_EXPERIMENTS(X)@all_experiments@
]])
set_source_files_properties(core/study/stability/table.cpp PROPERTIES INCLUDE_DIRECTORIES ${experiments_include})
