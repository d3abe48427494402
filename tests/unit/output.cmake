bempd_add_unit_test(output_test output_test.cpp output_places_test.cpp)

# An independent reader: Debian's meshio. The interpreter is named, as others on the PATH may lack it.
find_program(BEMPD_MESHIO_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
if(BEMPD_MESHIO_PYTHON)
  foreach(samples output_samples output_crack_samples)
    add_executable(${samples} ${samples}.cpp)
    target_link_libraries(${samples} PRIVATE bempd_engine bempd_warnings GTest::gtest)
    target_precompile_headers(${samples} REUSE_FROM bempd_engine_test_headers)
  endforeach()
  add_test(NAME output_meshio_test
           COMMAND "${BEMPD_MESHIO_PYTHON}" -B "${CMAKE_CURRENT_SOURCE_DIR}/output_meshio_test.py"
                   "$<TARGET_FILE:output_samples>")
  add_test(NAME output_plot_test
           COMMAND "${BEMPD_MESHIO_PYTHON}" -B "${CMAKE_CURRENT_SOURCE_DIR}/output_plot_test.py"
                   "$<TARGET_FILE:output_crack_samples>" "${PROJECT_SOURCE_DIR}/examples")
  set_tests_properties(output_meshio_test output_plot_test PROPERTIES SKIP_RETURN_CODE 77)
endif()
