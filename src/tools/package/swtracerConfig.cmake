# find_package(swtracer): the target swtracer::swtracer.
include(CMakeFindDependencyMacro)
find_dependency(Threads)

# The public headers include GLM.
if(NOT TARGET swtracer::glm)
  find_path(SWTRACER_GLM_INCLUDE_DIR glm/glm.hpp)
  mark_as_advanced(SWTRACER_GLM_INCLUDE_DIR)
  if(NOT SWTRACER_GLM_INCLUDE_DIR)
    set(swtracer_FOUND FALSE)
    set(swtracer_NOT_FOUND_MESSAGE "GLM is not found. Install it (Debian, Ubuntu: libglm-dev), or set \
SWTRACER_GLM_INCLUDE_DIR to the folder that contains glm/glm.hpp")
    return()
  endif()
  add_library(swtracer::glm INTERFACE IMPORTED)
  target_include_directories(swtracer::glm SYSTEM INTERFACE ${SWTRACER_GLM_INCLUDE_DIR})
endif()

include(${CMAKE_CURRENT_LIST_DIR}/swtracerTargets.cmake)
