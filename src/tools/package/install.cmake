# What `cmake --install` and `cpack` take: the program with its scenes and tools, and the library for
# find_package(swtracer).
if(NOT SWTRACER_INSTALL)
  return()
endif()
set(package ${CMAKE_CURRENT_LIST_DIR})

# Programs to install, as far as this build has them. swtracer-bench is for work on these sources.
set(programs)
foreach(program swtracer swtracer-scene swtracer-report)
  if(TARGET ${program})
    list(APPEND programs ${program})
  endif()
endforeach()

# Others' machines may lack what this one's processor has. So a build that uses it is not installed:
# a second one is, without.
if(SWTRACER_NATIVE AND SWTRACER_HAS_MARCH_NATIVE)
  configure_file(${package}/installSecondBuild.cmake.in installSecondBuild.cmake @ONLY)
  install(SCRIPT ${PROJECT_BINARY_DIR}/installSecondBuild.cmake ALL_COMPONENTS)
  set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # nothing of this build is needed
  set(CMAKE_SKIP_PACKAGE_ALL_DEPENDENCY ON)
else()
  include(CMakePackageConfigHelpers)
  set(config ${CMAKE_INSTALL_LIBDIR}/cmake/swtracer)
  target_link_libraries(libsw PUBLIC $<INSTALL_INTERFACE:swtracer::glm>)
  install(TARGETS libsw EXPORT swtracer ARCHIVE)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/swtracer)
  install(EXPORT swtracer NAMESPACE swtracer:: FILE swtracerTargets.cmake DESTINATION ${config})
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/swtracerConfigVersion.cmake
    VERSION ${PROJECT_VERSION} COMPATIBILITY SameMajorVersion)
  install(FILES ${package}/swtracerConfig.cmake ${PROJECT_BINARY_DIR}/swtracerConfigVersion.cmake
    DESTINATION ${config})
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md
    DESTINATION ${CMAKE_INSTALL_DOCDIR})
  if(programs)
    install(TARGETS ${programs} RUNTIME)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/swtracer)
  endif()
endif()

if(PROJECT_IS_TOP_LEVEL)
  include(${package}/cpack.cmake)
endif()
