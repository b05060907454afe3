# NLopt with its C++ parts (StoGO, AGS, nlopt.hpp) as the target NLoptCxx::NLoptCxx. Debian keeps them in a
# library of their own beside the C one, elsewhere there is one library; the two share a package name for CMake.
find_path(NLoptCxx_INCLUDE_DIR nlopt.hpp)
find_library(NLoptCxx_LIBRARY NAMES nlopt_cxx nlopt)
mark_as_advanced(NLoptCxx_INCLUDE_DIR NLoptCxx_LIBRARY)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(NLoptCxx REQUIRED_VARS NLoptCxx_LIBRARY NLoptCxx_INCLUDE_DIR)
if(NLoptCxx_FOUND AND NOT TARGET NLoptCxx::NLoptCxx)
  add_library(NLoptCxx::NLoptCxx UNKNOWN IMPORTED)
  set_target_properties(NLoptCxx::NLoptCxx PROPERTIES
    IMPORTED_LOCATION ${NLoptCxx_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${NLoptCxx_INCLUDE_DIR})
endif()
