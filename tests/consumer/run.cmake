# Installs a build, moves it to another place, and builds and runs the project of this folder
# against it:
#   cmake -D source=DIR -D build=DIR -D work=DIR -D compiler=PATH -D shared=BOOL -P run.cmake
# `build` is an existing build of `source`; with `shared` it is made here, with a shared library.
# `work` is emptied.
function(step)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

if(shared)
  step(${CMAKE_COMMAND} -S ${source} -B ${build} -G Ninja -D CMAKE_CXX_COMPILER=${compiler}
    -D CMAKE_BUILD_TYPE=Debug -D BUILD_SHARED_LIBS=ON -D DEBURR_BUILD_CLI=OFF
    -D DEBURR_BUILD_TESTS=OFF)
  step(${CMAKE_COMMAND} --build ${build})
endif()

file(REMOVE_RECURSE ${work})
step(${CMAKE_COMMAND} --install ${build} --prefix ${work}/installed)
file(RENAME ${work}/installed ${work}/moved)

file(GLOB_RECURSE package ${work}/moved/*.cmake)
foreach(file IN LISTS package)
  file(READ ${file} text)
  foreach(folder ${source} ${build} ${work})
    string(FIND "${text}" ${folder} found)
    if(NOT found EQUAL -1)
      message(FATAL_ERROR "${file} names ${folder}")
    endif()
  endforeach()
endforeach()

if(EXISTS ${work}/moved/bin/deburr)
  step(${work}/moved/bin/deburr --version)
endif()
step(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${work}/build -G Ninja
  -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_PREFIX_PATH=${work}/moved)
step(${CMAKE_COMMAND} --build ${work}/build)
step(${work}/build/consumer)
