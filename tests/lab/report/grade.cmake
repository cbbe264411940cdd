# cmake -D CTEST=... -D BUILD=... -D CONFIG=... -D REPORT=... -D TESTS=... -D POINTS=1,2,3,4,5,6
#   -P grade.cmake
# Builds and runs all of the lab's tests, and shows the grade on stdout. What the tests print goes
# into BUILD/lab-report/grade.log. A test that fails is no failure of this script.
set(records ${BUILD}/lab-report/records)
set(log ${BUILD}/lab-report/grade.log)
file(REMOVE ${BUILD}/grade.json)  # which may be of another day's code
file(REMOVE_RECURSE ${records})
file(MAKE_DIRECTORY ${BUILD}/lab-report)
execute_process(
  COMMAND ${CMAKE_COMMAND} --build ${BUILD} --config "${CONFIG}" --target lab_tests lab_report
  OUTPUT_FILE ${log}
  ERROR_FILE ${log}
  RESULT_VARIABLE failed)
if(failed)
  file(READ ${log} text)
  message(FATAL_ERROR "grade: expected code that compiles, found:\n${text}")
endif()
cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
execute_process(
  COMMAND ${CTEST} -C "${CONFIG}" -L "^lab[1-6]-" -FS lab_built -j ${cores} --output-on-failure
  WORKING_DIRECTORY ${BUILD}
  OUTPUT_FILE ${log}
  ERROR_FILE ${log}
  RESULT_VARIABLE ignored)
execute_process(
  COMMAND ${REPORT} grade ${records} ${TESTS} ${BUILD}/grade.json ${POINTS}
  COMMAND_ERROR_IS_FATAL ANY)
