# Benchmarks, studies and scene generators.
if(NOT SWTRACER_BUILD_REPORTS)
  return()
endif()

file(GLOB tool_sources CONFIGURE_DEPENDS common/*.cpp common/scenes/*.cpp)
list(FILTER tool_sources EXCLUDE REGEX "common/(html|mainFunctions|subject)\\.cpp$")  # targets of their own
add_library(swtracer_tools STATIC ${tool_sources})
target_compile_definitions(swtracer_tools PRIVATE
  SW_BUILD_TYPE="$<IF:$<BOOL:$<CONFIG>>,$<CONFIG>,plain>")
target_link_libraries(swtracer_tools PUBLIC swtracer_html swtracer_program libsw
  PRIVATE swtracer_cli11 swtracer_warnings)

add_subdirectory(generators)
add_subdirectory(bench)

# swtracer-report: error against run time, as tables and plots.
file(GLOB report_sources CONFIGURE_DEPENDS
  calibration/*.cpp convergence/*.cpp stability/*.cpp common/subject.cpp)
add_executable(swtracer-report report.cpp ${report_sources})
set_target_properties(swtracer-report PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
target_link_libraries(swtracer-report PRIVATE
  swtracer_main swtracer_tools swtracer_warnings swtracer_exact_arithmetic)

# `cmake --build build --target report` studies all shipped scenes: report/convergence/index.html.
if(PROJECT_IS_TOP_LEVEL)
  add_custom_target(report
    COMMAND swtracer-report convergence --output ${PROJECT_SOURCE_DIR}/report/convergence
    USES_TERMINAL COMMENT "Error against run time for all shipped scenes")
endif()

if(SWTRACER_BUILD_TESTS)
  foreach(study stability convergence calibration)
    add_test(NAME report.${study}
      COMMAND swtracer-report ${study} --quick --output ${CMAKE_CURRENT_BINARY_DIR}/quick)
    set_tests_properties(report.${study} PROPERTIES LABELS "report;${study}" TIMEOUT 60)
  endforeach()
endif()
