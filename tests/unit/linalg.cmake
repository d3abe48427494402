bempd_add_unit_test(linalg_test linalg_blas_test.cpp linalg_condensation_test.cpp
  linalg_conjugate_gradient_test.cpp linalg_dense_parts_test.cpp linalg_external_test.cpp linalg_least_change_test.cpp
  linalg_profile_cholesky_test.cpp)
bempd_add_unit_test(linalg_cholesky_test linalg_cholesky_test.cpp linalg_backend_test.cpp)
set_source_files_properties(linalg_backend_test.cpp PROPERTIES
  COMPILE_DEFINITIONS "BEMPD_EXPECTED_BACKEND=\"${BEMPD_LINALG}\"")
if(BEMPD_LINALG STREQUAL "suitesparse")
  bempd_add_unit_test(linalg_cholmod_version_test linalg_cholmod_version_test.cpp)
  target_include_directories(linalg_cholmod_version_test SYSTEM PRIVATE "${SuiteSparse_INCLUDE_DIR}")
endif()
