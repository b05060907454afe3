# Makes the libraries available to others: find_package(rectilin), rectilin::optim, rectilin::measure.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/rectilin)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/rectilin-config.cmake.in
  ${PROJECT_BINARY_DIR}/rectilin-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/rectilin-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/rectilin-config.cmake ${PROJECT_BINARY_DIR}/rectilin-config-version.cmake
  DESTINATION ${package_dir})
install(EXPORT rectilin NAMESPACE rectilin:: FILE rectilin-targets.cmake DESTINATION ${package_dir})
