# One executable of tests that see the library as a host does: through bempd.h and the shared library. It is one entry of the
# test run, because its cases may share a long computation.
function(bempd_add_host_test name)
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE bempd bempd_claims bempd_warnings GTest::gtest_main)
  target_precompile_headers(${name} REUSE_FROM bempd_host_test_headers)
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES LABELS host)
  add_dependencies(host_tests ${name})
endfunction()

# Cracks take ten times as long with the permissive backend and under sanitizers: there only the cases of this filter run.
function(bempd_shorten_host_test name filter)
  if(NOT BEMPD_LINALG STREQUAL "suitesparse" OR CMAKE_CXX_FLAGS MATCHES "-fsanitize=")
    set_tests_properties(${name} PROPERTIES ENVIRONMENT "GTEST_FILTER=${filter}")
  endif()
endfunction()

if(TARGET bempd)
  bempd_add_host_test(coupled_patch_test coupled_patch_test.cpp)
  bempd_add_host_test(coupled_layers_test coupled_layers_test.cpp)
  bempd_add_host_test(joined_lattices_test joined_lattices_test.cpp)
  bempd_add_host_test(pressure_test pressure_test.cpp)
  bempd_add_host_test(coupled_cantilever_test coupled_cantilever_test.cpp)
  bempd_add_host_test(coupled_interface_test coupled_interface_test.cpp)
  bempd_add_host_test(coupled_kirsch_test coupled_kirsch_test.cpp)
  bempd_add_host_test(coupled_clamped_plate_test coupled_clamped_plate_test.cpp)
endif()
