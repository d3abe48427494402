# Finds libraries of SuiteSparse 5, which ships neither CMake nor pkg-config files: the components CHOLMOD and UMFPACK.
# Defines SuiteSparse_INCLUDE_DIR, SuiteSparse_<component>_LIBRARY and, of CHOLMOD, SuiteSparse_VERSION.
find_path(SuiteSparse_INCLUDE_DIR NAMES cholmod.h PATH_SUFFIXES suitesparse)
mark_as_advanced(SuiteSparse_INCLUDE_DIR)
set(_suitesparse_libraries)
foreach(_component IN LISTS SuiteSparse_FIND_COMPONENTS)
  string(TOLOWER "${_component}" _name)
  find_library(SuiteSparse_${_component}_LIBRARY ${_name})
  mark_as_advanced(SuiteSparse_${_component}_LIBRARY)
  list(APPEND _suitesparse_libraries SuiteSparse_${_component}_LIBRARY)
endforeach()

if(SuiteSparse_INCLUDE_DIR AND EXISTS "${SuiteSparse_INCLUDE_DIR}/cholmod_core.h")
  file(STRINGS "${SuiteSparse_INCLUDE_DIR}/cholmod_core.h" _suitesparse_version_lines
       REGEX "^#define CHOLMOD_(MAIN|SUB|SUBSUB)_VERSION [0-9]+")
  string(REGEX REPLACE "[^0-9;]" "" SuiteSparse_VERSION "${_suitesparse_version_lines}")
  string(REPLACE ";" "." SuiteSparse_VERSION "${SuiteSparse_VERSION}")
  unset(_suitesparse_version_lines)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SuiteSparse
  REQUIRED_VARS ${_suitesparse_libraries} SuiteSparse_INCLUDE_DIR
  VERSION_VAR SuiteSparse_VERSION)
unset(_suitesparse_libraries)
unset(_name)
