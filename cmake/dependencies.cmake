# Looks for everything first, so that one message names all that is missing.
set(deburr_missing "")
set(deburr_packages "")
macro(deburr_find name package)
  find_package(${name} ${ARGN} QUIET)
  if(NOT ${name}_FOUND)
    string(APPEND deburr_missing " ${name}")
    string(APPEND deburr_packages " ${package}")
  endif()
endmacro()

deburr_find(Eigen3 libeigen3-dev 3.4 NO_MODULE)
deburr_find(TBB libtbb-dev)
deburr_find(fmt libfmt-dev)
if(DEBURR_BUILD_CLI)
  deburr_find(CLI11 libcli11-dev 2.1)
  deburr_find(nlohmann_json nlohmann-json3-dev 3.10)
endif()
if(deburr_missing)
  message(FATAL_ERROR "deburr needs these libraries, which CMake does not find:${deburr_missing}\n"
    "On Debian or Ubuntu:\n  apt-get install${deburr_packages}\n"
    "Elsewhere install them by other means, and name their folder in CMAKE_PREFIX_PATH.")
endif()
