bempd_add_engine_test(output_test output_test.cpp)

# An independent reader: Debian's meshio. The interpreter is named, as others on the PATH may lack it.
find_program(BEMPD_MESHIO_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
if(BEMPD_MESHIO_PYTHON)
  add_executable(output_samples output_samples.cpp)
  target_link_libraries(output_samples PRIVATE bempd_engine bempd_warnings)
  add_test(NAME output_meshio_test
           COMMAND "${BEMPD_MESHIO_PYTHON}" "${CMAKE_CURRENT_SOURCE_DIR}/output_meshio_test.py"
                   "$<TARGET_FILE:output_samples>")
  set_tests_properties(output_meshio_test PROPERTIES SKIP_RETURN_CODE 77)
endif()
