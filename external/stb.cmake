# stb's single-file libraries, copied into one folder: stb/, so that the students' kit carries them
# along, or the build folder where this is a part of another project, whose sources are not ours.

set(SWTRACER_STB_URL
  https://raw.githubusercontent.com/nothings/stb/8b5f1f37b5b75829fc72d38e7b5d4bcbf8a26d55
  CACHE STRING "Where stb is downloaded from, if this system has none")
mark_as_advanced(SWTRACER_STB_URL)

# Whether a file is one of stb's from its first line to its last: no empty file, half a file or page
# of an error, as an interrupted download or a proxy leaves it behind.
function(swtracer_stb_is_whole header name result)
  set(${result} FALSE PARENT_SCOPE)
  if(EXISTS ${header})
    file(READ ${header} text)
    if(text MATCHES "^/\\* ${name} - v[0-9]" AND text MATCHES "[*]/[ \r\n]*$")
      set(${result} TRUE PARENT_SCOPE)
    endif()
  endif()
endfunction()

# Downloads a header. It gets its name only when all of it is there and is what it should be.
function(swtracer_stb_download name sha256 header)
  set(part ${header}.part)
  message(STATUS "stb: downloading ${SWTRACER_STB_URL}/${name}.h")
  file(DOWNLOAD ${SWTRACER_STB_URL}/${name}.h ${part} STATUS status
    INACTIVITY_TIMEOUT 30)
  list(POP_FRONT status code reason)
  if(code EQUAL 0)
    file(SHA256 ${part} found)
    if(found STREQUAL sha256)
      file(RENAME ${part} ${header})
      return()
    endif()
    set(reason "expected SHA-256 ${sha256}, found ${found}")
  endif()
  file(REMOVE ${part})
  message(FATAL_ERROR "${name}.h cannot be downloaded from ${SWTRACER_STB_URL}: ${reason}.\n"
    "Install stb (Debian, Ubuntu: libstb-dev; Fedora: stb-devel; Arch: stb), or bring ${name}.h from "
    "a machine with a network (https://github.com/nothings/stb) and put it here:\n  ${header}\n"
    "Then configure again.")
endfunction()

# Has a header in a folder: it is there already, or comes from the system, or is downloaded.
function(swtracer_stb_header name sha256 folder)
  set(header ${folder}/${name}.h)
  swtracer_stb_is_whole(${header} ${name} whole)
  if(whole)
    return()
  endif()
  find_file(SWTRACER_SYSTEM_${name} ${name}.h PATH_SUFFIXES stb)
  mark_as_advanced(SWTRACER_SYSTEM_${name})
  swtracer_stb_is_whole("${SWTRACER_SYSTEM_${name}}" ${name} whole)
  if(whole)
    set(origin ${SWTRACER_SYSTEM_${name}})
    file(COPY ${origin} DESTINATION ${folder})
  else()
    set(origin ${SWTRACER_STB_URL}/${name}.h)
    swtracer_stb_download(${name} ${sha256} ${header})
  endif()
  file(STRINGS ${header} version LIMIT_COUNT 1)
  file(SHA256 ${header} found)
  file(APPEND ${folder}/ORIGIN.txt "${version}\nfrom ${origin}\nSHA-256 ${found}\n")
endfunction()

# Both headers. stb_image is for programs of old, which include it.
# @param result  the variable that receives the folder that they are in
function(swtracer_find_stb result)
  set(folder ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/stb)
  foreach(name stb_image_write stb_image)
    swtracer_stb_is_whole(${folder}/${name}.h ${name} whole)
    if(NOT whole AND NOT PROJECT_IS_TOP_LEVEL)
      set(folder ${CMAKE_CURRENT_BINARY_DIR}/stb)
    endif()
  endforeach()
  swtracer_stb_header(stb_image_write
    cbd5f0ad7a9cf4468affb36354a1d2338034f2c12473cf1a8e32053cb6914a05 ${folder})
  swtracer_stb_header(stb_image
    91f435e0fc6a620018b878b9859c74dff60d28046f87e649191ad6f35a98c722 ${folder})
  set(${result} ${folder} PARENT_SCOPE)
endfunction()
