# The Python package: what it promises, its types, the code in its documentation, and the wheel.
# An ordinary interpreter cannot load a library with sanitizers.
if(NOT Python3_FOUND OR CMAKE_CXX_FLAGS MATCHES "-fsanitize=")
  return()
endif()
execute_process(COMMAND "${Python3_EXECUTABLE}" -c "import cffi, matplotlib, mypy, numpy, PIL, pytest"
                RESULT_VARIABLE python_lacks_modules ERROR_VARIABLE python_message)
if(python_lacks_modules)
  message(STATUS "Tests of the Python package are left out: ${python_message}")
  return()
endif()

set(python_package "${PROJECT_SOURCE_DIR}/bindings/python")
set(python_work "${CMAKE_CURRENT_BINARY_DIR}/python")
file(MAKE_DIRECTORY "${python_work}")

function(bempd_add_python_test name)
  add_test(NAME ${name} COMMAND "${Python3_EXECUTABLE}" ${ARGN} WORKING_DIRECTORY "${python_work}")
  set_tests_properties(${name} PROPERTIES TIMEOUT 600
    ENVIRONMENT "PYTHONPATH=${python_package};BEMPD_LIBRARY=$<TARGET_FILE:bempd>;PYTHONDONTWRITEBYTECODE=1;BEMPD_TEST_HOOKS=1")
endfunction()

# Files whose scenes take longest are entries of their own, which can run at once.
set(python_tests "${CMAKE_CURRENT_SOURCE_DIR}/python")
set(python_growth test_fatigue.py test_fatigue_in_calls.py test_fatigue_of_lines.py test_specimens.py test_resistance.py test_falling_loads.py)
set(python_lines test_crack_lines.py test_line_windows.py test_line_extensions.py test_line_energy.py test_reported_growth.py
    test_side_by_side.py test_torn_plates.py)
set(python_rest)
foreach(part growth lines)
  list(TRANSFORM python_${part} PREPEND "${python_tests}/")
  bempd_add_python_test(bindings.python_${part} -m pytest -q -p no:cacheprovider ${python_${part}})
  foreach(file ${python_${part}})
    list(APPEND python_rest "--ignore=${file}")
  endforeach()
endforeach()
bempd_add_python_test(bindings.python -m pytest -q -p no:cacheprovider "${python_tests}" ${python_rest})
# The longest begin first, so that no core waits for them in the end.
set_tests_properties(bindings.python bindings.python_growth bindings.python_lines PROPERTIES COST 300)
# Processes, Open MPI and Dask; fails where Debian's python3-mpi4py or python3-distributed is missing.
bempd_add_python_test(bindings.ensembles -m pytest -q -p no:cacheprovider "${CMAKE_CURRENT_SOURCE_DIR}/ensembles")
# Needs Debian's python3-vtk9.
bempd_add_python_test(bindings.paraview "${CMAKE_CURRENT_SOURCE_DIR}/paraview_test.py")
set_tests_properties(bindings.paraview PROPERTIES SKIP_RETURN_CODE 77)
bempd_add_python_test(bindings.python_documentation -m pytest -q -p no:cacheprovider --doctest-modules
                      --doctest-glob=README.md "${python_package}/bempd" "${python_package}/README.md")
bempd_add_python_test(bindings.python_types -m mypy --config-file "${python_package}/pyproject.toml"
                      --cache-dir "${python_work}/mypy" "${python_package}/bempd")
set_tests_properties(bindings.python_types PROPERTIES LABELS delivery)

bempd_add_python_test(package.python_wheel "${PROJECT_SOURCE_DIR}/tests/package/python_wheel.py" "${PROJECT_SOURCE_DIR}"
                      "${python_work}/wheel")
set_tests_properties(package.python_wheel PROPERTIES LABELS delivery)
