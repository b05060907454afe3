# What every target of the project shares: the language level, warnings, sanitizers.
function(rectilin_target name)
  target_compile_features(${name} PUBLIC cxx_std_20)
  target_compile_options(${name} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
    # False alarms in std::string's operator+ (GCC bug 105651).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-stringop-overflow -Wno-array-bounds>
    $<$<BOOL:${RECTILIN_WARNINGS_AS_ERRORS}>:-Werror>)
  if(RECTILIN_SANITIZE)
    target_compile_options(${name} PUBLIC -fsanitize=${RECTILIN_SANITIZE} -fno-omit-frame-pointer
      -fno-sanitize-recover=all)
    # GCC's flow analysis gives false alarms inside Eigen under sanitizers; the release build keeps this warning.
    target_compile_options(${name} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    # Eigen pads its own allocations when it sees the sanitizer, pagmo's library does not: one rule for both.
    target_compile_definitions(${name} PUBLIC EIGEN_MALLOC_ALREADY_ALIGNED=1)
    target_link_options(${name} PUBLIC -fsanitize=${RECTILIN_SANITIZE})
  endif()
endfunction()

# A house, that is a library of the project: the target rectilin_NAME, exported as rectilin::NAME, headers in include/.
#   SOURCES   its files
#   HOUSES    the houses whose headers its own headers include; linked
#   PACKAGES  packages that a program which links it must find, beyond those of HOUSES
function(rectilin_library name)
  cmake_parse_arguments(PARSE_ARGV 1 house "" "" "SOURCES;HOUSES;PACKAGES")
  set(target rectilin_${name})
  add_library(${target} ${house_SOURCES})
  add_library(rectilin::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_include_directories(${target}
    PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src)
  list(TRANSFORM house_HOUSES PREPEND rectilin:: OUTPUT_VARIABLE linked)
  target_link_libraries(${target} PUBLIC ${linked})
  rectilin_target(${target})
  rectilin_precompile(${target})
  rectilin_unite(${target})
  set_property(GLOBAL APPEND PROPERTY rectilin_houses ${name})
  set_property(GLOBAL PROPERTY rectilin_houses_of_${name} "${house_HOUSES}")
  set_property(GLOBAL PROPERTY rectilin_packages_of_${name} "${house_PACKAGES}")
  install(TARGETS ${target} EXPORT rectilin-${name} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endfunction()

# Eigen and the JSON library are most of what a source compiles: all targets share one precompiled header, that of base.
function(rectilin_precompile target)
  if(NOT RECTILIN_PRECOMPILE)
    return()
  endif()
  if(target STREQUAL rectilin_base)
    target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.h)
  else()
    target_compile_options(${target} PRIVATE -fPIC)  # GCC uses such a header only with the same kind of code
    target_precompile_headers(${target} REUSE_FROM rectilin_base)
  endif()
endfunction()

# With RECTILIN_UNITY the sources of a folder are compiled as one, so that what their headers cost is paid once: names in
# their anonymous namespaces must differ. Kernels stay apart: they compile themselves once for each instruction set.
function(rectilin_unite target)
  if(NOT RECTILIN_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(folder ${source} DIRECTORY)
    if(source MATCHES "_kernels\\.cpp$")
      continue()
    endif()
    string(MAKE_C_IDENTIFIER "${folder}" group)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${target}_${group}")
  endforeach()
endfunction()
