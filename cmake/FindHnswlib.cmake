# hnswlib, headers that come without a CMake package: the folder Hnswlib_INCLUDE_DIR.
find_path(Hnswlib_INCLUDE_DIR hnswlib/hnswlib.h)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Hnswlib REQUIRED_VARS Hnswlib_INCLUDE_DIR)
mark_as_advanced(Hnswlib_INCLUDE_DIR)
