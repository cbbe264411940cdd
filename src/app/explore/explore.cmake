# The page of --explore is one string in the program: page.html with style and scripts in it.
set(explore ${CMAKE_CURRENT_LIST_DIR})
set(page ${CMAKE_CURRENT_BINARY_DIR}/explorePageText.cpp)
file(GLOB page_parts CONFIGURE_DEPENDS ${explore}/*.html ${explore}/*.css ${explore}/*.js)
add_custom_command(OUTPUT ${page}
  COMMAND ${CMAKE_COMMAND} -D FOLDER=${explore} -D OUT=${page} -P ${explore}/makePage.cmake
  DEPENDS ${page_parts} ${explore}/makePage.cmake VERBATIM)
file(GLOB explore_sources CONFIGURE_DEPENDS ${explore}/*.cpp)
target_sources(swtracer_program PRIVATE ${explore_sources} ${page})
