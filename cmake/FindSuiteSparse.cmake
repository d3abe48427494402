# Finds CHOLMOD and UMFPACK of SuiteSparse 5, which ships neither CMake nor pkg-config files. Defines
# SuiteSparse_INCLUDE_DIR, SuiteSparse_LIBRARIES and, of CHOLMOD, SuiteSparse_VERSION.
find_path(SuiteSparse_INCLUDE_DIR NAMES cholmod.h PATH_SUFFIXES suitesparse)
find_library(SuiteSparse_CHOLMOD_LIBRARY cholmod)
find_library(SuiteSparse_UMFPACK_LIBRARY umfpack)
mark_as_advanced(SuiteSparse_INCLUDE_DIR SuiteSparse_CHOLMOD_LIBRARY SuiteSparse_UMFPACK_LIBRARY)
set(SuiteSparse_LIBRARIES ${SuiteSparse_CHOLMOD_LIBRARY} ${SuiteSparse_UMFPACK_LIBRARY})

if(SuiteSparse_INCLUDE_DIR AND EXISTS "${SuiteSparse_INCLUDE_DIR}/cholmod_core.h")
  file(STRINGS "${SuiteSparse_INCLUDE_DIR}/cholmod_core.h" _suitesparse_version_lines
       REGEX "^#define CHOLMOD_(MAIN|SUB|SUBSUB)_VERSION [0-9]+")
  string(REGEX REPLACE "[^0-9;]" "" SuiteSparse_VERSION "${_suitesparse_version_lines}")
  string(REPLACE ";" "." SuiteSparse_VERSION "${SuiteSparse_VERSION}")
  unset(_suitesparse_version_lines)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SuiteSparse
  REQUIRED_VARS SuiteSparse_CHOLMOD_LIBRARY SuiteSparse_UMFPACK_LIBRARY SuiteSparse_INCLUDE_DIR
  VERSION_VAR SuiteSparse_VERSION)
