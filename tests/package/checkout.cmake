# cmake -D PROJECT=... -D WORK=... -P checkout.cmake
# Git on Windows gives text files CRs when it checks them out, unless .gitattributes says otherwise:
# sh then refuses external/setup.sh, and pictures change. Checks project and kit out that way.
cmake_minimum_required(VERSION 3.21)
find_program(GIT git)
if(NOT GIT)
  message("skipped: git is not installed")
  return()
endif()
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})

# expect_same_bytes(FOLDER NAME): commits the folder in a repository of its own, as the student does
# who starts with the kit, and compares a clone with it.
function(expect_same_bytes folder name)
  set(repository ${WORK}/${name}.git)
  set(clone ${WORK}/${name})
  set(git ${GIT} -c core.autocrlf=true -c core.safecrlf=false -c user.name=Test -c user.email=test@localhost)
  set(here ${git} --git-dir=${repository} --work-tree=${folder})
  execute_process(COMMAND_ERROR_IS_FATAL ANY WORKING_DIRECTORY ${folder}
    COMMAND ${git} init -q --bare ${repository}
    COMMAND_ECHO NONE)
  execute_process(COMMAND_ERROR_IS_FATAL ANY WORKING_DIRECTORY ${folder}
    COMMAND ${here} add -A)
  execute_process(COMMAND_ERROR_IS_FATAL ANY WORKING_DIRECTORY ${folder}
    COMMAND ${here} commit -q -m all)
  execute_process(COMMAND_ERROR_IS_FATAL ANY
    COMMAND ${git} clone -q ${repository} ${clone})

  file(GLOB_RECURSE files RELATIVE ${clone} ${clone}/*)
  list(FILTER files EXCLUDE REGEX "^\\.git/")
  list(LENGTH files count)
  if(count LESS 100)
    message(FATAL_ERROR "${name}: expected a whole checkout, found ${count} files")
  endif()
  foreach(file ${files})
    file(SHA256 ${folder}/${file} ours)
    file(SHA256 ${clone}/${file} theirs)
    if(NOT ours STREQUAL theirs)
      message(SEND_ERROR "${name}: ${file} has other bytes in a checkout with core.autocrlf=true")
    endif()
  endforeach()
  message(STATUS "${name}: ${count} files")

  # A CR at the end of its first command makes this "Illegal option -".
  execute_process(COMMAND sh ${clone}/external/setup.sh --unknown
    RESULT_VARIABLE code ERROR_VARIABLE said)
  if(NOT code EQUAL 2 OR NOT said MATCHES "^usage: sh external/setup.sh")
    message(SEND_ERROR "${name}: expected setup.sh to show its usage, found ${code}: ${said}")
  endif()
endfunction()

execute_process(COMMAND_ERROR_IS_FATAL ANY
  COMMAND ${CMAKE_COMMAND} -D PROJECT=${PROJECT} -D KIT=${WORK}/handed-out
    -P ${PROJECT}/src/tools/kit/makeKit.cmake)
expect_same_bytes(${PROJECT} project)
expect_same_bytes(${WORK}/handed-out kit)
