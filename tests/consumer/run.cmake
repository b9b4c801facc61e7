# Installs a build, moves it to another place, and builds and runs the project of this folder
# against it:
#   cmake -D source=DIR -D build=DIR -D work=DIR -D compiler=PATH -D shared=BOOL -P run.cmake
# `build` is an existing build of `source`. With `shared`, a shared library is made of its objects,
# which suit both kinds of library, and installed instead. `work` is emptied.
function(step)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${work})
if(shared)
  set(ENV{CMAKE_CXX_COMPILER_LAUNCHER} "sh;${CMAKE_CURRENT_LIST_DIR}/take_object.sh;${build}")
  step(${CMAKE_COMMAND} -S ${source} -B ${work}/shared -G Ninja -D CMAKE_CXX_COMPILER=${compiler}
    -D BUILD_SHARED_LIBS=ON -D DEBURR_BUILD_CLI=OFF -D DEBURR_BUILD_TESTS=OFF)
  step(${CMAKE_COMMAND} --build ${work}/shared)
  set(build ${work}/shared)
endif()

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
