if(TARGET bempd)
  bempd_add_host_tests(economy_tests economy_test.cpp cancellation_test.cpp economy_condition_test.cpp
    lattice_stress_test.cpp extremes/extremes_units_test.cpp extremes/extremes_shapes_test.cpp
    extremes/extremes_fracture_test.cpp)
  # A program of its own, so that the thread sanitizer runs it and no other test of this folder.
  bempd_add_host_tests(economy_threads_test economy_threads_test.cpp)
  set_property(TEST economy_threads_test APPEND PROPERTY LABELS threads)
  bempd_long_test(extremes_fracture_test economy_tests "LongRuns.*")
endif()
