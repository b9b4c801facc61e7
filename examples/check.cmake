# Checks that the readme shows an example as it is, and what it prints:
#   cmake -D program=PATH -D source=PATH -D readme=PATH -P check.cmake
execute_process(COMMAND ${program} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
file(READ ${source} code)
string(REGEX REPLACE "^(//[^\n]*\n)+" "" code "${code}")
file(READ ${readme} text)
foreach(part code printed)
  string(FIND "${text}" "\n${${part}}```" found)
  if(found EQUAL -1)
    message(FATAL_ERROR "${readme} does not show this:\n${${part}}")
  endif()
endforeach()
