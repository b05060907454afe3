# What every target of the project shares: the language level, warnings, sanitizers.
function(rectilin_target name)
  target_compile_features(${name} PUBLIC cxx_std_20)
  target_compile_options(${name} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # false alarms in std::string's operator+ (GCC bug 105651)
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

# A library of the project: rectilin_NAME, exported as rectilin::NAME, headers in NAME/include.
function(rectilin_library name)
  add_library(rectilin_${name} STATIC ${ARGN})
  add_library(rectilin::${name} ALIAS rectilin_${name})
  set_target_properties(rectilin_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_include_directories(rectilin_${name} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  rectilin_target(rectilin_${name})
  install(TARGETS rectilin_${name} EXPORT rectilin ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endfunction()
