# cmake -D SWTRACER=... -D VERSION=... -P version.cmake
# The number in CMakeLists.txt is the program's. (find_package(swtracer 1.0) is tested beside this.)
execute_process(COMMAND ${SWTRACER} --version OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
if(NOT said MATCHES "(^|[^0-9.])${VERSION}([^0-9.]|\n|$)")
  message(FATAL_ERROR "expected ${VERSION} from --version, found ${said}")
endif()
