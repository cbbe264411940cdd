# cmake -D PROJECT=... -D KIT=... -P makeKit.cmake
# Makes the students' kit in the new folder KIT: the files below, then the starter files (which
# replace the solved ones) and the files that only the kit has.
cmake_minimum_required(VERSION 3.21)

set(contents
  .clang-format
  .gitattributes
  CMakeLists.txt
  LICENSE
  external/*.txt external/stb.cmake external/setup.sh external/stb/* external/windows/*
  include/sw*.h
  scenes/glass.nff scenes/lights.nff scenes/mirrors.nff scenes/one-triangle.nff scenes/spheres.nff
  src/CMakeLists.txt src/sw*.cpp
  src/app/*
  src/nff/nff*.h src/nff/nffShapes.cpp src/nff/nffSpheres.cpp src/nff/nffTokens.cpp
  src/nff/nffView.cpp src/nff/plainText.* src/nff/swNff.cpp
  src/png/*
  src/rayTree/*
  src/sampling/splitMix64.h src/sampling/swErrorEstimate.cpp
  tests/CMakeLists.txt tests/catch.h tests/files.h tests/main.cpp tests/support.*
  tests/cameraTest.cpp tests/samplingTest.cpp tests/sphereTest.cpp tests/vec3Test.cpp
  tests/lab/CMakeLists.txt tests/lab/*.cpp tests/lab/*.h tests/lab/pictures/*
  tests/lab/report/*)

# Of rooms that the six tasks do not need.
set(left_out
  include/swAdaptive.h include/swBvh*.h include/swCone.h include/swCorners.h include/swMetrics.h
  include/swPatch.h include/swSamplePattern.h
  src/app/console.cpp src/app/extraOptions.cpp src/app/extras.cpp src/app/help.*
  src/app/commandLine.cmake src/app/interrupt.* src/app/outputChecks.cpp src/app/outputs.cpp
  src/app/pictureFormat.* src/app/preview.* src/app/process.* src/app/progressBar.*
  src/app/renderWatch.cpp src/app/scenePath.cpp src/app/statistics.* src/app/terminal.*
  src/app/validators.cpp src/app/explore
  src/nff/nffChecks.h src/nff/nffHints.h src/nff/nffMaterial.h src/nff/nffSkipped.h src/nff/nffText.h
  src/rayTree/darkness.cpp
  src/swCone.cpp src/swPatch.cpp src/swStop.cpp
  tests/lab/report/*Test.cpp tests/lab/report/labBuild.h)

function(listed result patterns)
  list(TRANSFORM patterns PREPEND ${PROJECT}/)
  file(GLOB files RELATIVE ${PROJECT} ${patterns})
  set(${result} ${files} PARENT_SCOPE)
endfunction()

# copy(FROM file...): copies each file to the same path in the kit.
function(copy from)
  foreach(file ${ARGN})
    cmake_path(GET file PARENT_PATH folder)
    file(COPY ${from}/${file} DESTINATION ${KIT}/${folder})
  endforeach()
endfunction()

listed(files "${contents}")
listed(none "${left_out}")
list(REMOVE_ITEM files ${none})
copy(${PROJECT} ${files})

# In the kit, only tests use these.
listed(helpers "src/tools/CMakeLists.txt;src/tools/common/html.*;src/tools/common/mainFunctions.*")
foreach(file ${helpers})
  string(REGEX REPLACE "^src/" "tests/" place ${file})
  cmake_path(GET place PARENT_PATH folder)
  file(COPY ${PROJECT}/${file} DESTINATION ${KIT}/${folder})
endforeach()

set(own ${PROJECT}/src/tools/kit)
file(GLOB_RECURSE starters RELATIVE ${own}/starter ${own}/starter/*)
foreach(file ${starters})
  set(place src/${file})
  if(file MATCHES "^include/")
    set(place ${file})
  endif()
  # Not file(COPY): it skips a file with the same time stamp as its target, as in a fresh clone.
  file(COPY_FILE ${own}/starter/${file} ${KIT}/${place})
endforeach()
file(GLOB_RECURSE extras RELATIVE ${own}/files ${own}/files/*)
copy(${own}/files ${extras})
