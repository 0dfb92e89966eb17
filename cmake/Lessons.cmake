# Writes lessons_table.h: the lessons, found as the folders of chapters/ that hold a lesson.md, and the listings, found as
# those that hold a listing.cpp (its text may still be to come). It defines two lists in the order of the folders' names,
# to be used with a macro of one argument:
#   PS_LESSONS(X)           X(folder) for each folder with a lesson.md
#   PS_LESSON_LISTINGS(X)   X(folder) for each folder with a listing.cpp
# and a third one, to be used with a macro of three arguments:
#   PS_LISTING_BUGS(X)      X(folder, bug, "symptom") for each folder/bugs/bug.cpp, whose first line is // symptom
# Such a file is its folder's listing.cpp with one changed line and so defines the same names. Therefore listing_bugs.cpp,
# which is written too, includes them all, each with its folder's name replaced by its own.

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

file(GLOB bugs CONFIGURE_DEPENDS RELATIVE ${CMAKE_SOURCE_DIR}/chapters ${CMAKE_SOURCE_DIR}/chapters/*/bugs/*.cpp)
list(SORT bugs)
list(TRANSFORM bugs PREPEND ${CMAKE_SOURCE_DIR}/chapters/ OUTPUT_VARIABLE bug_files)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${bug_files})  # their first lines
set(all_bugs "")
set(bug_names "")
set(bug_sources "")
foreach(file ${bugs})
  string(REGEX MATCH "^([^/]+)/bugs/([a-z][a-z0-9_]*)[.]cpp$" matched ${file})
  set(folder "${CMAKE_MATCH_1}")
  set(bug "${CMAKE_MATCH_2}")
  file(STRINGS ${CMAKE_SOURCE_DIR}/chapters/${file} symptom LIMIT_COUNT 1)
  if(NOT matched OR bug IN_LIST bug_names)
    message(FATAL_ERROR "chapters/${file}: a bug is named in snake_case (a-z, 0-9, _), like no other bug")
  endif()
  if(NOT symptom MATCHES "^// ([^\"\\]+[.])$")
    message(FATAL_ERROR "chapters/${file}: its first line is // and a sentence, without ; and quotes, that says what is seen")
  endif()
  list(APPEND bug_names ${bug})
  string(APPEND all_bugs " X(${folder}, ${bug}, \"${CMAKE_MATCH_1}\")")
  string(APPEND bug_sources "#define ${folder} bug_${bug}\n#include \"${CMAKE_SOURCE_DIR}/chapters/${file}\"\n#undef ${folder}\n")
endforeach()
set(PIXELSCOPE_LISTING_BUGS ${PIXELSCOPE_LESSONS_INCLUDE}/listing_bugs.cpp)
file(CONFIGURE OUTPUT ${PIXELSCOPE_LISTING_BUGS} @ONLY CONTENT [[
// Written by cmake/Lessons.cmake from the files of chapters/*/bugs/.
@bug_sources@]])
file(CONFIGURE OUTPUT ${PIXELSCOPE_LESSONS_INCLUDE}/lessons_table.h @ONLY CONTENT [[
// Written by cmake/Lessons.cmake from the folders of chapters/.
#pragma once
#define PS_LESSONS(X)@all_lessons@
#define PS_LESSON_LISTINGS(X)@all_listings@
#define PS_LISTING_BUGS(X)@all_bugs@
]])
