# cmake -D KIND=... -D PROJECT=... -D WORK=... -D SOURCE=... -D PREFIX=... -D GENERATOR=...
#   -D MAKE_PROGRAM=... -D COMPILER=... -D FLAGS=... -D CCACHE=... -P useLibrary.cmake
# Configures, builds and runs consumer/, which uses the library as KIND says:
#   subfolder  by add_subdirectory. It lies in SOURCE, and is installed at PREFIX in the end
#   fetched    by FetchContent of SOURCE
#   installed  by find_package, found at PREFIX
cmake_minimum_required(VERSION 3.21)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})

set(options)
if(KIND STREQUAL "subfolder")
  file(REMOVE_RECURSE ${SOURCE} ${PREFIX})
  foreach(item CMakeLists.txt LICENSE README.md external include scenes src)
    file(COPY ${PROJECT}/${item} DESTINATION ${SOURCE} PATTERN external/stb EXCLUDE)
  endforeach()
  set(options -D SWTRACER_INSTALL=ON)
elseif(KIND STREQUAL "installed")
  set(options -D CMAKE_PREFIX_PATH=${PREFIX})
endif()
if(CCACHE)
  list(APPEND options -D CMAKE_CXX_COMPILER_LAUNCHER=${CCACHE})
endif()
file(GLOB_RECURSE before ${SOURCE}/*)

execute_process(COMMAND_ERROR_IS_FATAL ANY
  COMMAND ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${WORK}/build -G ${GENERATOR}
    -D CMAKE_MAKE_PROGRAM=${MAKE_PROGRAM} -D CMAKE_CXX_COMPILER=${COMPILER}
    -D CMAKE_CXX_FLAGS=${FLAGS}
    -D KIND=${KIND} -D SWTRACER_SOURCE=${SOURCE} ${options})
execute_process(COMMAND_ERROR_IS_FATAL ANY
  COMMAND ${CMAKE_COMMAND} --build ${WORK}/build)
find_program(consumer consumer PATHS ${WORK}/build ${WORK}/build/Debug REQUIRED NO_DEFAULT_PATH)
execute_process(COMMAND_ERROR_IS_FATAL ANY COMMAND ${consumer})

# Another's sources are not the place for what is downloaded or made.
file(GLOB_RECURSE after ${SOURCE}/*)
if(NOT "${after}" STREQUAL "${before}")
  list(REMOVE_ITEM after ${before})
  message(FATAL_ERROR "expected the library's sources to stay as they are, found ${after}")
endif()

if(KIND STREQUAL "subfolder")
  execute_process(COMMAND_ERROR_IS_FATAL ANY
    COMMAND ${CMAKE_COMMAND} --install ${WORK}/build --prefix ${PREFIX})
endif()
