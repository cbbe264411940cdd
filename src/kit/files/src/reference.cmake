# cmake -B build -DREFERENCE_TASKS="2;4": the functions of todo.h for tasks 2 and 4 answer as a right
# solution would. They are there as compiled code only.

set(REFERENCE_TASKS "" CACHE STRING "Tasks that the reference does for you, \"2;4\" for example")

# Where a task's code calls for the reference: file and functions.
set(reference_1 main.cpp "todo::diffuse")
set(reference_2 swTriangle.cpp "todo::intersect")
set(reference_3 main.cpp "todo::isInShadow")
set(reference_4 main.cpp "todo::reflection" swIntersection.cpp "todo::reflectedRay")
set(reference_5 main.cpp "todo::refraction" swIntersection.cpp "todo::refractedRay")
set(reference_6 main.cpp "todo::samplePixel")

# Warns where a student's code no longer calls a function that the reference is wanted for.
function(expect_placeholder task file call)
  file(READ ${CMAKE_CURRENT_SOURCE_DIR}/${file} source)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${file})
  string(FIND "${source}" "${call}(" at)
  if(at EQUAL -1)
    message(WARNING "REFERENCE_TASKS has task ${task}, but src/${file} no longer calls ${call}(): "
      "the reference has nothing to answer there. Put the starter's line back in place of your own "
      "code (README.md shows it).")
  endif()
endfunction()

set(reference_list "")
foreach(task ${REFERENCE_TASKS})
  if(NOT task MATCHES "^[1-6]$")
    message(FATAL_ERROR "REFERENCE_TASKS: expected tasks from 1 to 6, as in \"2;4\"; found ${task}")
  endif()
  string(APPEND reference_list ",${task}")
  set(calls ${reference_${task}})
  while(calls)
    list(POP_FRONT calls file call)
    expect_placeholder(${task} ${file} ${call})
  endwhile()
endforeach()

if(REFERENCE_TASKS)
  set(reference_folder
    ${PROJECT_SOURCE_DIR}/external/reference/${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR})
  set(reference_rays ${reference_folder}/rays${CMAKE_CXX_OUTPUT_EXTENSION})
  set(reference_shading ${reference_folder}/shading${CMAKE_CXX_OUTPUT_EXTENSION})
  if(NOT EXISTS ${reference_rays} OR NOT EXISTS ${reference_shading})
    message(FATAL_ERROR "REFERENCE_TASKS: this kit has no reference for ${CMAKE_SYSTEM_NAME} on "
      "${CMAKE_SYSTEM_PROCESSOR} (${reference_folder}). Your teacher can make one with "
      "`cmake --build build --target student-kit` on such a machine.")
  endif()
  message(STATUS "reference: does tasks ${REFERENCE_TASKS} wherever your code calls todo.h")
  target_sources(libsw PRIVATE ${reference_rays})
  target_sources(swtracer_program INTERFACE ${reference_shading})
endif()
set_source_files_properties(todo.cpp todoShading.cpp PROPERTIES
  COMPILE_DEFINITIONS "SW_REFERENCE_TASKS=${reference_list}")
