# One program of tests that see the library as a host does: through bempd.h and the shared library.
function(bempd_add_host_tests name)
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE bempd bempd_claims bempd_test_main bempd_warnings bempd_host_options GTest::gtest)
  target_include_directories(${name} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}" "${PROJECT_SOURCE_DIR}/tests")
  target_precompile_headers(${name} REUSE_FROM bempd_host_test_headers)
  bempd_compile_together(${name} ${ARGN})
  bempd_add_tests_of_files(${name} ${ARGN} LABEL host)
  add_dependencies(host_tests ${name})
endfunction()

# Cracks take ten times as long with the permissive backend and under sanitizers: there only the cases of this filter run.
function(bempd_shorten_test name filter)
  if(NOT BEMPD_LINALG STREQUAL "suitesparse" OR CMAKE_CXX_FLAGS MATCHES "-fsanitize=")
    set_tests_properties(${name} PROPERTIES ENVIRONMENT "GTEST_FILTER=${filter}")
  endif()
endfunction()
