# Writes lessons_table.h: the lessons, found as the folders of chapters/ that hold a lesson.md, and the listings, found as
# those that hold a listing.cpp (its text may still be to come). It defines two lists in the order of the folders' names,
# to be used with a macro of one argument:
#   PS_LESSONS(X)           X(folder) for each folder with a lesson.md
#   PS_LESSON_LISTINGS(X)   X(folder) for each folder with a listing.cpp
# and a third one, to be used with a macro of three arguments:
#   PS_LISTING_BUGS(X)      X(folder, bug, "symptom") for each folder/bugs/bug.bug, whose first line is the symptom
# The program pixelscope-plant puts the bugs into copies of their listings (core/textbook/bug_patch.h).

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

file(GLOB bugs CONFIGURE_DEPENDS RELATIVE ${CMAKE_SOURCE_DIR}/chapters ${CMAKE_SOURCE_DIR}/chapters/*/bugs/*.bug)
list(SORT bugs)
list(TRANSFORM bugs PREPEND ${CMAKE_SOURCE_DIR}/chapters/ OUTPUT_VARIABLE bug_files)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${bug_files})  # their first lines
set(all_bugs "")
set(bug_names "")
set(buggy_listings "")
foreach(file ${bugs})
  string(REGEX MATCH "^([^/]+)/bugs/([a-z][a-z0-9_]*)[.]bug$" matched ${file})
  set(folder "${CMAKE_MATCH_1}")
  set(bug "${CMAKE_MATCH_2}")
  file(STRINGS ${CMAKE_SOURCE_DIR}/chapters/${file} symptom LIMIT_COUNT 1)
  if(NOT matched OR bug IN_LIST bug_names)
    message(FATAL_ERROR "chapters/${file}: a bug is named in snake_case (a-z, 0-9, _), like no other bug")
  endif()
  if(NOT symptom MATCHES "^[^\"\\]+[.]$")
    message(FATAL_ERROR "chapters/${file}: its first line is a sentence, without ; and quotes, that says what is seen")
  endif()
  list(APPEND bug_names ${bug})
  list(APPEND buggy_listings ${CMAKE_SOURCE_DIR}/chapters/${folder}/listing.cpp)
  string(APPEND all_bugs " X(${folder}, ${bug}, \"${symptom}\")")
endforeach()
set(PIXELSCOPE_LISTING_BUGS ${PIXELSCOPE_LESSONS_INCLUDE}/listing_bugs.cpp)
add_executable(pixelscope-plant app/plant/main.cpp core/textbook/bug_patch.cpp core/base/archived_file.cpp core/base/check.cpp
               core/base/read_file.cpp core/base/spelling.cpp core/base/tar.cpp)
target_include_directories(pixelscope-plant PRIVATE core)
set_target_properties(pixelscope-plant PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/generated)
target_link_libraries(pixelscope-plant PRIVATE fmt::fmt)
target_compile_options(pixelscope-plant PRIVATE ${PIXELSCOPE_WARNINGS})
add_custom_command(OUTPUT ${PIXELSCOPE_LISTING_BUGS} DEPENDS ${bug_files} ${buggy_listings} VERBATIM
                   COMMAND pixelscope-plant ${PIXELSCOPE_LISTING_BUGS} ${bug_files})
file(CONFIGURE OUTPUT ${PIXELSCOPE_LESSONS_INCLUDE}/lessons_table.h @ONLY CONTENT [[
// Written by cmake/Lessons.cmake from the folders of chapters/.
#pragma once
#define PS_LESSONS(X)@all_lessons@
#define PS_LESSON_LISTINGS(X)@all_listings@
#define PS_LISTING_BUGS(X)@all_bugs@
]])
