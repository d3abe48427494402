# Run by CTest with -P; WAY says how the consumer finds the library.
set(prefix "${WORK_DIR}/prefix")
set(consumer_build "${WORK_DIR}/${WAY}")

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "failed (${status}): ${command}")
  endif()
endfunction()

function(run_consumer)
  execute_process(COMMAND "${CMAKE_COMMAND}" -E env ${ARGN} "${consumer_build}/consumer"
                  OUTPUT_VARIABLE output RESULT_VARIABLE status OUTPUT_STRIP_TRAILING_WHITESPACE)
  message("${output}")
  if(NOT status EQUAL 0 OR NOT output STREQUAL "bempd ${VERSION}")
    message(FATAL_ERROR "expected 'bempd ${VERSION}' and status 0, got '${output}' and ${status}")
  endif()
endfunction()

file(REMOVE_RECURSE "${consumer_build}")
file(MAKE_DIRECTORY "${consumer_build}")
set(configure "${CMAKE_COMMAND}" -S "${CONSUMER_DIR}" -B "${consumer_build}" -G Ninja
    "-DCMAKE_C_COMPILER=${C_COMPILER}" "-DWAY=${WAY}")

if(WAY STREQUAL "install")
  file(REMOVE_RECURSE "${prefix}" "${prefix} moved")
  run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${prefix}")
  # An installed tree may be moved.
  file(RENAME "${prefix}" "${prefix} moved")
elseif(WAY STREQUAL "find_package")
  # The library's own needs must not become the host's.
  run(${configure} "-DCMAKE_PREFIX_PATH=${prefix} moved" -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON
      -DCMAKE_DISABLE_FIND_PACKAGE_LAPACK=ON -DCMAKE_DISABLE_FIND_PACKAGE_BLAS=ON
      -DCMAKE_DISABLE_FIND_PACKAGE_SuiteSparse=ON "-DVERSION=${VERSION}")
  run("${CMAKE_COMMAND}" --build "${consumer_build}")
  run_consumer()
elseif(WAY STREQUAL "pkg_config")
  set(ENV{PKG_CONFIG_PATH} "${prefix} moved/${LIBDIR}/pkgconfig")
  execute_process(COMMAND pkg-config --cflags --libs bempd OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  run("${C_COMPILER}" -std=c99 "${CONSUMER_DIR}/main.c" ${flags} -o "${consumer_build}/consumer")
  run_consumer("LD_LIBRARY_PATH=${prefix} moved/${LIBDIR}")
elseif(WAY STREQUAL "linking_lines")
  # The lines of docs/linking.md for a prefix of one's own, as they stand there.
  run(bash "${CONSUMER_DIR}/../linking_lines.sh" "${CONSUMER_DIR}/../../.." "${prefix} moved" "${LIBDIR}"
      "${consumer_build}" "${VERSION}")
elseif(WAY MATCHES "^fortran_")
  set(installed "${prefix} moved")
  if(WAY STREQUAL "fortran_sources")
    set(installed "${consumer_build} prefix")
    file(REMOVE_RECURSE "${installed}")
    file(COPY "${prefix} moved/" DESTINATION "${installed}")
    file(GLOB modules "${installed}/${LIBDIR}/bempd/fortran/*.mod")
    foreach(module IN LISTS modules)
      file(WRITE "${module}" "GFORTRAN module version '0' created from another compiler\n")
    endforeach()
  endif()
  run(${configure} "-DCMAKE_PREFIX_PATH=${installed}" "-DCMAKE_Fortran_COMPILER=${Fortran_COMPILER}"
      "-DVERSION=${VERSION}")
  run("${CMAKE_COMMAND}" --build "${consumer_build}")
  run_consumer()
  # Compiling the sources again must be the exception.
  file(GLOB compiled "${consumer_build}/CMakeFiles/bempd_fortran.dir")
  if((WAY STREQUAL "fortran_modules" AND compiled) OR (WAY STREQUAL "fortran_sources" AND NOT compiled))
    message(FATAL_ERROR "${WAY}: compiled in the host: '${compiled}'")
  endif()
endif()
