# The students' kit: `cmake --build build --target student-kit`. See makeKit.cmake.
if(NOT PROJECT_IS_TOP_LEVEL)
  return()
endif()
set(kit_source ${CMAKE_CURRENT_LIST_DIR})

# The starter files compile where they stand. Their swScene.h comes first. Its include guard keeps
# out the swScene.h beside the other public headers.
file(GLOB_RECURSE starters CONFIGURE_DEPENDS ${kit_source}/starter/*.cpp)
add_library(swtracer_starter OBJECT ${starters})
target_compile_options(swtracer_starter PRIVATE
  $<$<CXX_COMPILER_ID:MSVC>:/FI${kit_source}/starter/include/swScene.h>
  $<$<NOT:$<CXX_COMPILER_ID:MSVC>>:-include;${kit_source}/starter/include/swScene.h>)
target_include_directories(swtracer_starter PRIVATE
  ${kit_source}/starter ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/include)
target_compile_features(swtracer_starter PRIVATE cxx_std_20)
target_link_libraries(swtracer_starter PRIVATE
  swtracer_glm swtracer_warnings swtracer_student_warnings swtracer_exact_arithmetic)

set(kit ${PROJECT_BINARY_DIR}/student-kit)
add_custom_target(student-kit
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${kit} ${kit}.zip
  COMMAND ${CMAKE_COMMAND} -D PROJECT=${PROJECT_SOURCE_DIR} -D KIT=${kit}
    -P ${kit_source}/makeKit.cmake
  COMMAND ${CMAKE_COMMAND} -E chdir ${PROJECT_BINARY_DIR}
    ${CMAKE_COMMAND} -E tar cf student-kit.zip --format=zip student-kit
  COMMENT "Making build/student-kit and build/student-kit.zip" VERBATIM)
