# Compiles every public header on its own, with nothing but the library's own folders to include
# from, and checks that none includes a third party's:
#   cmake -D compiler=PATH -D include=DIR -D generated=DIR -P public_headers.cmake
file(GLOB headers RELATIVE ${include} ${include}/deburr/*.hpp)
list(APPEND headers deburr/version.hpp)
foreach(header IN LISTS headers)
  execute_process(
    COMMAND ${compiler} -std=c++20 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wold-style-cast
      -Werror -I ${include} -I ${generated} -include ${header} -fsyntax-only -H -x c++ /dev/null
    RESULT_VARIABLE status ERROR_VARIABLE included)
  if(status)
    message(FATAL_ERROR "${header} does not compile on its own:\n${included}")
  endif()
  if(included MATCHES "[^\n]*/(CLI|Eigen|eigen3|fmt|nlohmann|oneapi|tbb)/[^\n]*")
    message(FATAL_ERROR "${header} includes ${CMAKE_MATCH_0}")
  endif()
endforeach()
