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

# Adds a house, a library of the project: the target rectilin_NAME, exported as rectilin::NAME, with headers in include/.
#   SOURCES   its source files
#   HOUSES    the houses that it uses; linked
#   APART     never compile its sources as one (see rectilin_unite()): private names occur in several of them
#   COLD      its code takes next to no time when it runs, so it is optimized less (see rectilin_cold())
#   PACKAGES  packages that its users must find, in addition to those of HOUSES: "NAME" or "NAME VERSION"
function(rectilin_library name)
  cmake_parse_arguments(PARSE_ARGV 1 house "APART;COLD" "" "SOURCES;HOUSES;PACKAGES")
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
  if(house_COLD)
    rectilin_cold(${target})
    rectilin_precompile(${target} COLD)
  else()
    rectilin_precompile(${target})
  endif()
  if(NOT house_APART)
    rectilin_unite(${target})
  endif()
  set_property(GLOBAL APPEND PROPERTY rectilin_houses ${name})
  set_property(GLOBAL PROPERTY rectilin_houses_of_${name} "${house_HOUSES}")
  set_property(GLOBAL PROPERTY rectilin_packages_of_${name} "${house_PACKAGES}")
  install(TARGETS ${target} EXPORT rectilin-${name} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endfunction()

# Eigen and the JSON library are most of what a source compiles, so the targets share the precompiled header of base.
# Cold targets share another one, because GCC optimizes a source like its precompiled header, whatever the flags say.
function(rectilin_precompile target)
  cmake_parse_arguments(PARSE_ARGV 1 target "COLD" "" "")
  if(NOT RECTILIN_PRECOMPILE)
    return()
  endif()
  if(target STREQUAL rectilin_base)
    target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.h)
    return()
  endif()
  set(owner rectilin_base)
  if(target_COLD)
    set(owner rectilin_cold_precompiled)
    if(NOT TARGET ${owner})
      file(WRITE ${PROJECT_BINARY_DIR}/cold_precompiled.cpp "")
      add_library(${owner} OBJECT ${PROJECT_BINARY_DIR}/cold_precompiled.cpp)
      set_target_properties(${owner} PROPERTIES POSITION_INDEPENDENT_CODE ON)
      target_link_libraries(${owner} PRIVATE rectilin::base)
      rectilin_target(${owner})
      rectilin_cold(${owner})
      target_precompile_headers(${owner} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.h)
    endif()
  endif()
  target_compile_options(${target} PRIVATE -fPIC)  # GCC accepts the header only if it was compiled with -fPIC, too
  target_precompile_headers(${target} REUSE_FROM ${owner})
endfunction()

# Code whose running time nobody notices is optimized for debugging, so that it compiles in two thirds of the time. GCC's
# flow analysis then gives false alarms inside std::stop_callback.
function(rectilin_cold target)
  target_compile_options(${target} PRIVATE $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU,Clang>>:-Og>
    $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-Wno-maybe-uninitialized>)
endfunction()

# With RECTILIN_UNITY the sources of a house are compiled as one, so that their headers are compiled and what they share
# is optimized only once: four fifths of the time of a unit for each folder, and a third of that of each source alone.
# They must not use the same name in their anonymous namespaces. Kernels stay apart: each includes itself once for every
# instruction set.
function(rectilin_unite target)
  if(NOT RECTILIN_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # GCC looks for unused memory again and again in sources this large. To begin at a gigabyte saves a tenth of the
  # processor's time and takes a fifth more memory: 1.5 GB for the largest.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=1048576>)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    file(STRINGS ${source} kernel REGEX "hwy/foreach_target\\.h")
    if(NOT kernel)
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${target})
    endif()
  endforeach()
endfunction()
