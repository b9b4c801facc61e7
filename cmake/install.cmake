include(CMakePackageConfigHelpers)
# Before 1.0 a minor version may change the binary interface.
set_target_properties(deburr PROPERTIES
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
if(DEBURR_BUILD_CLI AND BUILD_SHARED_LIBS)
  file(RELATIVE_PATH from_bin /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR})
  set_target_properties(deburr_cli PROPERTIES INSTALL_RPATH "$ORIGIN/${from_bin}")
endif()
install(TARGETS deburr EXPORT deburr-targets)
install(DIRECTORY include/deburr DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/generated/deburr/version.hpp
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/deburr)
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/deburr)
install(EXPORT deburr-targets NAMESPACE deburr:: DESTINATION ${config_dir})
configure_package_config_file(cmake/deburr-config.cmake.in deburr-config.cmake
  INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(deburr-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/deburr-config.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/deburr-config-version.cmake DESTINATION ${config_dir})
