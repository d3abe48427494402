# Properties of random scenes, few of them; tests/run.sh long takes more. An ordinary interpreter cannot load a library with
# sanitizers.
find_package(Python3 COMPONENTS Interpreter)
if(NOT Python3_FOUND OR NOT TARGET bempd OR CMAKE_CXX_FLAGS MATCHES "-fsanitize=")
  return()
endif()
execute_process(COMMAND "${Python3_EXECUTABLE}" -c "import cffi, numpy" RESULT_VARIABLE python_lacks_modules ERROR_QUIET)
if(NOT python_lacks_modules EQUAL 0)
  return()
endif()
add_test(NAME differential.properties COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_LIST_DIR}/properties.py" --first 1 --count 10 --also 70 130 150)
set_tests_properties(differential.properties PROPERTIES TIMEOUT 300 ENVIRONMENT
  "PYTHONPATH=${PROJECT_SOURCE_DIR}/bindings/python;BEMPD_LIBRARY=$<TARGET_FILE:bempd>;PYTHONDONTWRITEBYTECODE=1;OPENBLAS_NUM_THREADS=1")
add_test(NAME differential.restarts COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_LIST_DIR}/restarts.py" --short)
add_test(NAME differential.restarts.long COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_LIST_DIR}/restarts.py")
set_tests_properties(differential.restarts.long PROPERTIES LABELS long)
set_tests_properties(differential.restarts differential.restarts.long PROPERTIES TIMEOUT 300 ENVIRONMENT
  "PYTHONPATH=${PROJECT_SOURCE_DIR}/bindings/python;BEMPD_LIBRARY=$<TARGET_FILE:bempd>;PYTHONDONTWRITEBYTECODE=1;OPENBLAS_NUM_THREADS=1")
