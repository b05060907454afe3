# Makes the houses available to others: find_package(rectilin COMPONENTS measure), then rectilin::measure.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/rectilin)
get_property(houses GLOBAL PROPERTY rectilin_houses)
set(RECTILIN_HOUSES ${houses})
set(RECTILIN_HOUSE_TABLE "")
foreach(house IN LISTS houses)
  get_property(needed GLOBAL PROPERTY rectilin_houses_of_${house})
  get_property(packages GLOBAL PROPERTY rectilin_packages_of_${house})
  string(APPEND RECTILIN_HOUSE_TABLE
    "set(rectilin_houses_of_${house} ${needed})\nset(rectilin_packages_of_${house} \"${packages}\")\n")
  install(EXPORT rectilin-${house} NAMESPACE rectilin:: FILE rectilin-${house}-targets.cmake DESTINATION ${package_dir})
endforeach()
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/rectilin-config.cmake.in
  ${PROJECT_BINARY_DIR}/rectilin-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/rectilin-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/rectilin-config.cmake ${PROJECT_BINARY_DIR}/rectilin-config-version.cmake
  ${PROJECT_SOURCE_DIR}/cmake/FindNLoptCxx.cmake ${PROJECT_SOURCE_DIR}/cmake/FindLib3MF.cmake
  ${PROJECT_SOURCE_DIR}/cmake/FindLibDeflate.cmake ${PROJECT_SOURCE_DIR}/cmake/FindMicrohttpd.cmake
  DESTINATION ${package_dir})
