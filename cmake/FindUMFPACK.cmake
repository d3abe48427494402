# Finds UMFPACK of SuiteSparse 5, which ships neither CMake nor pkg-config files. Defines UMFPACK::UMFPACK.
find_path(UMFPACK_INCLUDE_DIR umfpack.h PATH_SUFFIXES suitesparse)
find_library(UMFPACK_LIBRARY umfpack)
mark_as_advanced(UMFPACK_INCLUDE_DIR UMFPACK_LIBRARY)

if(UMFPACK_INCLUDE_DIR AND EXISTS "${UMFPACK_INCLUDE_DIR}/umfpack.h")
  file(STRINGS "${UMFPACK_INCLUDE_DIR}/umfpack.h" _umfpack_version_lines
       REGEX "^#define UMFPACK_(MAIN|SUB|SUBSUB)_VERSION [0-9]+")
  string(REGEX REPLACE "[^0-9;]" "" UMFPACK_VERSION "${_umfpack_version_lines}")
  string(REPLACE ";" "." UMFPACK_VERSION "${UMFPACK_VERSION}")
  unset(_umfpack_version_lines)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(UMFPACK REQUIRED_VARS UMFPACK_LIBRARY UMFPACK_INCLUDE_DIR
                                  VERSION_VAR UMFPACK_VERSION)

if(UMFPACK_FOUND AND NOT TARGET UMFPACK::UMFPACK)
  add_library(UMFPACK::UMFPACK UNKNOWN IMPORTED)
  set_target_properties(UMFPACK::UMFPACK PROPERTIES
    IMPORTED_LOCATION "${UMFPACK_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${UMFPACK_INCLUDE_DIR}")
endif()
