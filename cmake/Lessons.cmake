# Writes lessons_table.h: the lessons, found as the folders of chapters/ that hold a lesson.md, and the listings, found as
# those that hold a listing.cpp (its text may still be to come). It defines two lists in the order of the folders' names,
# to be used with a macro of one argument:
#   PS_LESSONS(X)           X(folder) for each folder with a lesson.md
#   PS_LESSON_LISTINGS(X)   X(folder) for each folder with a listing.cpp

file(GLOB lessons CONFIGURE_DEPENDS RELATIVE ${CMAKE_SOURCE_DIR}/chapters ${CMAKE_SOURCE_DIR}/chapters/*/lesson.md)
file(GLOB listings CONFIGURE_DEPENDS RELATIVE ${CMAKE_SOURCE_DIR}/chapters ${CMAKE_SOURCE_DIR}/chapters/*/listing.cpp)
list(SORT lessons)
list(SORT listings)

# lesson_list(RESULT FILE...): " X(folder)" for the folder of each file.
function(lesson_list result)
  set(all "")
  foreach(file ${ARGN})
    get_filename_component(folder ${file} DIRECTORY)
    if(NOT folder MATCHES "^[a-z][a-z0-9_]*$")
      message(FATAL_ERROR "chapters/${folder}: a lesson's folder is named in snake_case (a-z, 0-9, _)")
    endif()
    string(APPEND all " X(${folder})")
  endforeach()
  set(${result} "${all}" PARENT_SCOPE)
endfunction()
lesson_list(all_lessons ${lessons})
lesson_list(all_listings ${listings})

set(PIXELSCOPE_LESSONS_INCLUDE ${CMAKE_BINARY_DIR}/generated/chapters)
file(CONFIGURE OUTPUT ${PIXELSCOPE_LESSONS_INCLUDE}/lessons_table.h @ONLY CONTENT [[
// Written by cmake/Lessons.cmake from the folders of chapters/.
#pragma once
#define PS_LESSONS(X)@all_lessons@
#define PS_LESSON_LISTINGS(X)@all_listings@
]])
