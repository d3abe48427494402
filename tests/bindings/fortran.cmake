# The Fortran module; its examples are built with it in bindings/fortran.
if(NOT TARGET bempd_fortran)
  return()
endif()
enable_language(Fortran)

add_library(bempd_fortran_checks STATIC fortran_checks.f90)
set_target_properties(bempd_fortran_checks PROPERTIES
  Fortran_MODULE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/fortran_modules")
target_include_directories(bempd_fortran_checks PUBLIC "${CMAKE_CURRENT_BINARY_DIR}/fortran_modules")
target_link_libraries(bempd_fortran_checks PUBLIC bempd_fortran bempd_fortran_warnings)

foreach(program misuse runs new_values edges pieces stop)
  add_executable(fortran_${program} fortran_${program}.f90)
  target_link_libraries(fortran_${program} PRIVATE bempd_fortran_checks)
  if(CMAKE_Fortran_COMPILER_ID STREQUAL "GNU")
    target_compile_options(fortran_${program} PRIVATE -fcheck=all)
  endif()
endforeach()

add_test(NAME bindings.fortran_misuse COMMAND fortran_misuse)
add_test(NAME bindings.fortran_runs COMMAND fortran_runs)
add_test(NAME bindings.fortran_new_values COMMAND fortran_new_values)
add_test(NAME bindings.fortran_edges COMMAND fortran_edges)
add_test(NAME bindings.fortran_pieces COMMAND fortran_pieces)

# Each way must end with a sentence and without going on.
function(bempd_add_fortran_stop way sentence)
  add_test(NAME bindings.fortran_stops_${way} COMMAND "${CMAKE_COMMAND}" -D "PROGRAM=$<TARGET_FILE:fortran_stop>"
    -D "WAY=${way}" -D "SENTENCE=${sentence}" -P "${CMAKE_CURRENT_SOURCE_DIR}/fortran_stops.cmake")
endfunction()
bempd_add_fortran_stop(library "bempd_set_option: .*no\\.such\\.option")
bempd_add_fortran_stop(shape "bempd_add_crack: points has shape \\(3,1\\)")
bempd_add_fortran_stop(copy "a model cannot be copied")

if(TARGET example_first_crack_fortran)
  find_program(BEMPD_VALGRIND valgrind)
  mark_as_advanced(BEMPD_VALGRIND)
  if(BEMPD_VALGRIND)
    foreach(program example_first_crack_fortran fortran_misuse)
      add_test(NAME bindings.${program}_leaks_nothing COMMAND "${BEMPD_VALGRIND}" --leak-check=full
        --errors-for-leak-kinds=definite,indirect --error-exitcode=1 $<TARGET_FILE:${program}>)
      set_tests_properties(bindings.${program}_leaks_nothing PROPERTIES LABELS long TIMEOUT 900 COST 200)
    endforeach()
  endif()
endif()
if(TARGET example_host_loop)
  add_test(NAME example.host_loop COMMAND example_host_loop)
  set_tests_properties(example.host_loop PROPERTIES PASS_REGULAR_EXPRESSION "specimen is in two"
                       FAIL_REGULAR_EXPRESSION "did not converge")
endif()
