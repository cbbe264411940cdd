# Installed: the program with its scenes, and the library for find_package(swtracer).
if(NOT PROJECT_IS_TOP_LEVEL)
  return()
endif()
install(TARGETS swtracer RUNTIME)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/swtracer)
install(TARGETS libsw EXPORT swtracer ARCHIVE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/swtracer)
install(EXPORT swtracer NAMESPACE swtracer:: FILE swtracerTargets.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/swtracer)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/swtracerConfig.cmake
  "include(CMakeFindDependencyMacro)\nfind_dependency(Threads)\n"
  "include(\${CMAKE_CURRENT_LIST_DIR}/swtracerTargets.cmake)\n")
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/swtracerConfig.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/swtracer)
