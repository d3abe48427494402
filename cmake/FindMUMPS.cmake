# Finds the double precision MUMPS that works over MPI: MUMPS_INCLUDE_DIR, MUMPS_LIBRARIES. The sequential MUMPS, which brings an
# MPI of its own, is not looked for.
find_path(MUMPS_INCLUDE_DIR dmumps_c.h)
find_library(MUMPS_LIBRARY dmumps)
find_library(MUMPS_COMMON_LIBRARY mumps_common)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MUMPS REQUIRED_VARS MUMPS_LIBRARY MUMPS_COMMON_LIBRARY MUMPS_INCLUDE_DIR)
set(MUMPS_LIBRARIES "${MUMPS_LIBRARY}" "${MUMPS_COMMON_LIBRARY}")
mark_as_advanced(MUMPS_INCLUDE_DIR MUMPS_LIBRARY MUMPS_COMMON_LIBRARY)
