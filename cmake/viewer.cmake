# The page that `view` and `--report` fill in: built from viewer/ with Node.js, once per build
# folder, and embedded. Sets viewer_template_source, and DEBURR_HAS_VIEWER.
set(DEBURR_VIEWER AUTO CACHE STRING
  "Embed the viewer page: ON, OFF, or AUTO, which is ON where Node.js 18 and its packages are there")
set_property(CACHE DEBURR_VIEWER PROPERTY STRINGS AUTO ON OFF)
set(DEBURR_VIEWER_TEMPLATE "" CACHE FILEPATH
  "template.html of an earlier build, to embed instead of building it")

cmake_path(SET viewer_dir NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/../viewer)

# Says why the page cannot be built, or nothing.
function(deburr_viewer_obstacle result)
  find_program(DEBURR_NODE NAMES node nodejs)
  find_program(DEBURR_NPM NAMES npm)
  mark_as_advanced(DEBURR_NODE DEBURR_NPM)
  if(NOT DEBURR_NODE OR NOT DEBURR_NPM)
    set(${result} "node or npm is missing" PARENT_SCOPE)
    return()
  endif()
  execute_process(COMMAND ${DEBURR_NODE} --version OUTPUT_VARIABLE version
    OUTPUT_STRIP_TRAILING_WHITESPACE)
  string(REGEX REPLACE "^v" "" version "${version}")
  if(version VERSION_LESS 18)
    set(${result} "Node.js ${version} is older than 18" PARENT_SCOPE)
    return()
  endif()
  # npm is asked again only when the list of packages has changed.
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${viewer_dir}/package-lock.json)
  file(SHA256 ${viewer_dir}/package-lock.json wanted)
  set(stamp ${viewer_dir}/node_modules/.deburr-lock)
  set(installed "")
  if(EXISTS ${stamp})
    file(READ ${stamp} installed)
  endif()
  if(NOT installed STREQUAL wanted)
    message(STATUS "installing the packages of viewer/ with npm")
    execute_process(
      COMMAND ${CMAKE_COMMAND} -E env PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD=1
        ${DEBURR_NPM} ci --no-audit --no-fund --loglevel=error --fetch-retries=1
      WORKING_DIRECTORY ${viewer_dir} RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE told)
    if(failed)
      set(${result} "npm ci failed in viewer/: ${told}" PARENT_SCOPE)
      return()
    endif()
    file(WRITE ${stamp} ${wanted})
  endif()
  set(${result} "" PARENT_SCOPE)
endfunction()

set(viewer_template "")
if(DEBURR_VIEWER_TEMPLATE)
  set(viewer_template ${DEBURR_VIEWER_TEMPLATE})
elseif(DEBURR_VIEWER)
  deburr_viewer_obstacle(obstacle)
  if(NOT obstacle STREQUAL "" AND NOT DEBURR_VIEWER STREQUAL "AUTO")
    message(FATAL_ERROR "DEBURR_VIEWER is ${DEBURR_VIEWER}, but ${obstacle}")
  endif()
  if(obstacle STREQUAL "")
    set(viewer_template ${PROJECT_BINARY_DIR}/viewer/template.html)
    file(GLOB_RECURSE viewer_sources CONFIGURE_DEPENDS ${viewer_dir}/src/* ${viewer_dir}/bundle/*)
    add_custom_command(OUTPUT ${viewer_template}
      COMMAND ${DEBURR_NODE} node_modules/vite/bin/vite.js build --logLevel warn
        --outDir ${PROJECT_BINARY_DIR}/viewer --emptyOutDir false
      WORKING_DIRECTORY ${viewer_dir}
      DEPENDS ${viewer_sources} ${viewer_dir}/template.html ${viewer_dir}/vite.config.ts
        ${viewer_dir}/package-lock.json
      COMMENT "Building the viewer page" VERBATIM)
  else()
    message(STATUS "no viewer page: ${obstacle}")
  endif()
endif()

set(viewer_template_source ${CMAKE_CURRENT_BINARY_DIR}/viewer_template.cpp)
set(embed ${CMAKE_CURRENT_LIST_DIR}/embed_text.cmake)
if(viewer_template)
  set(DEBURR_HAS_VIEWER ON CACHE INTERNAL "whether the viewer page is embedded")
  add_custom_command(OUTPUT ${viewer_template_source}
    COMMAND ${CMAKE_COMMAND} -D text=${viewer_template} -D source=${viewer_template_source}
      -P ${embed}
    DEPENDS ${viewer_template} ${embed}
    COMMENT "Embedding the viewer page" VERBATIM)
else()
  set(DEBURR_HAS_VIEWER OFF CACHE INTERNAL "whether the viewer page is embedded")
  # Another name, or it would be newer than a template that is there later, and stay.
  set(viewer_template_source ${CMAKE_CURRENT_BINARY_DIR}/no_viewer_template.cpp)
  set(text "")
  set(source ${viewer_template_source})
  include(${embed})
endif()
