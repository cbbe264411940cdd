# cmake -D KIT=... -D HANDINS=... -D OUT=... [-D POINTS=1,2,3,4,5,6] [-D PART=i/n] -P gradeAll.cmake
#
# Grades many hand-ins.
#   KIT      the kit as it was handed out; it stays as it is
#   HANDINS  a folder with a folder for each hand-in. Only main.cpp, swTriangle.cpp and
#            swIntersection.cpp count, wherever they lie in it; one that is missing, or does not
#            compile, gives way to the starter's
#   OUT      a folder for grades.json and grades.md, and NAME.json with all failed tests of each.
#            Its kit/ is where hand-ins are built
#   PART     only the i-th of n parts of the hand-ins, i from 1 to n, so that n machines share the
#            work; each needs an OUT of its own
cmake_minimum_required(VERSION 3.21)
set(student_files main.cpp swTriangle.cpp swIntersection.cpp)
if(NOT POINTS)
  set(POINTS 10,10,10,10,10,10)
endif()
foreach(folder KIT HANDINS OUT)
  if(NOT ${folder})
    message(FATAL_ERROR "gradeAll: expected -D ${folder}=folder (see the head of this file)")
  endif()
  cmake_path(ABSOLUTE_PATH ${folder} BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
endforeach()
if(NOT PART)
  set(PART 1/1)
endif()
if(NOT PART MATCHES "^([1-9][0-9]*)/([1-9][0-9]*)$" OR CMAKE_MATCH_1 GREATER CMAKE_MATCH_2)
  message(FATAL_ERROR "gradeAll: expected -D PART=i/n with i from 1 to n, found ${PART}")
endif()
set(part ${CMAKE_MATCH_1})
set(parts ${CMAKE_MATCH_2})
set(build ${OUT}/kit/build)
set(records ${build}/lab-report/records)
cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)

# The starter's file, or the hand-in's. Touched, as a build looks at dates.
function(place file from)
  file(COPY_FILE ${from} ${OUT}/kit/src/${file})
  file(TOUCH ${OUT}/kit/src/${file})
endfunction()

function(build_tests result log)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${build} --target lab_tests lab_report
    OUTPUT_VARIABLE text ERROR_VARIABLE text RESULT_VARIABLE failed ${ARGN})
  set(${result} ${failed} PARENT_SCOPE)
  set(${log} "${text}" PARENT_SCOPE)
endfunction()

# Replaces as few of the hand-in's files as need be until the rest compiles. Says which.
function(build_what_compiles folder replaced first_error)
  set(sets none main.cpp swTriangle.cpp swIntersection.cpp main.cpp,swTriangle.cpp
    main.cpp,swIntersection.cpp swTriangle.cpp,swIntersection.cpp
    main.cpp,swTriangle.cpp,swIntersection.cpp)
  foreach(set ${sets})
    string(REPLACE "," ";" starters ${set})
    foreach(file ${student_files})
      file(GLOB_RECURSE found ${folder}/${file})
      if(found AND NOT file IN_LIST starters)
        list(GET found 0 from)
      else()
        set(from ${KIT}/src/${file})
      endif()
      place(${file} ${from})
    endforeach()
    build_tests(failed log TIMEOUT 60)
    if(set STREQUAL none AND failed)
      string(REGEX MATCH "[^\n]*error[: ][^\n]*" error "${log}")
      if(error STREQUAL "")
        set(error "${failed}")  # "Process terminated due to timeout"
      endif()
      set(${first_error} "${error}" PARENT_SCOPE)
    endif()
    if(NOT failed)
      string(REPLACE "none" "" set ${set})
      set(${replaced} "${set}" PARENT_SCOPE)
      return()
    endif()
  endforeach()
endfunction()

# Points, verdict and first hint of a hand-in, from its own JSON.
function(summarize name replaced error)
  file(READ ${OUT}/${name}.json json)
  string(JSON total GET "${json}" total)
  set(row "| ${name} | ${total} |")
  set(verdict "")
  set(hint "")
  foreach(i RANGE 5)
    string(JSON points GET "${json}" tasks ${i} points)
    string(APPEND row " ${points} |")
    string(JSON failed LENGTH "${json}" tasks ${i} failed)
    if(failed GREATER 0 AND verdict STREQUAL "")
      string(JSON verdict GET "${json}" tasks ${i} failed 0 verdict)
      string(JSON hint GET "${json}" tasks ${i} failed 0 hint)
    endif()
  endforeach()
  if(NOT replaced STREQUAL "")
    set(verdict "does not compile: ${replaced}")
    set(hint "${error}")
  endif()
  string(REGEX REPLACE "[|\n]" "/" verdict "${verdict}")
  string(REGEX REPLACE "[|\n]" "/" hint "${hint}")
  file(APPEND ${OUT}/grades.md "${row} ${verdict} | ${hint} |\n")
  string(JSON json SET "${json}" name "\"${name}\"")
  string(JSON json SET "${json}" replaced "\"${replaced}\"")
  set(last "${json}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${OUT}/kit/src)
file(GLOB contents ${KIT}/* ${KIT}/.clang-format)
list(FILTER contents EXCLUDE REGEX "/(build[^/]*|out.png)$")
file(COPY ${contents} DESTINATION ${OUT}/kit)
execute_process(COMMAND ${CMAKE_COMMAND} -S ${OUT}/kit -B ${build} -G Ninja
  -DCMAKE_BUILD_TYPE=Release OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
# Once without a hand-in, so that each is judged by its own files alone.
build_tests(failed log)
if(failed)
  message(FATAL_ERROR "gradeAll: expected the kit to build, found:\n${log}")
endif()
file(WRITE ${OUT}/grades.md "| hand-in | total | 1 | 2 | 3 | 4 | 5 | 6 | verdict | first hint |\n"
  "|---|---:|---:|---:|---:|---:|---:|---:|---|---|\n")
set(all "[]")
set(count 0)
set(found 0)
file(GLOB handins LIST_DIRECTORIES true RELATIVE ${HANDINS} ${HANDINS}/*)
foreach(name ${handins})
  if(NOT IS_DIRECTORY ${HANDINS}/${name})
    continue()
  endif()
  math(EXPR others_turn "(${found} - ${part} + 1) % ${parts}")
  math(EXPR found "${found} + 1")
  if(NOT others_turn EQUAL 0)
    continue()
  endif()
  message(STATUS "grading ${name}")
  set(replaced "")
  set(error "")
  build_what_compiles(${HANDINS}/${name} replaced error)
  file(REMOVE_RECURSE ${records})
  execute_process(COMMAND ${CMAKE_CTEST_COMMAND} -L "^lab[1-6]-" -FS lab_built -j ${cores}
    WORKING_DIRECTORY ${build} OUTPUT_QUIET ERROR_QUIET RESULT_VARIABLE ignored)
  execute_process(COMMAND ${build}/tests/lab/report/lab_report grade ${records}
    ${build}/tests/lab/lab_tests ${OUT}/${name}.json ${POINTS}
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  summarize(${name} "${replaced}" "${error}")
  string(JSON all SET "${all}" ${count} "${last}")
  math(EXPR count "${count} + 1")
endforeach()
file(WRITE ${OUT}/grades.json "${all}\n")
message(STATUS "${count} hand-ins graded: ${OUT}/grades.md")
