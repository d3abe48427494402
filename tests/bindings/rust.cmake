# The Rust crates are tested with the library just built, by Debian's Rust where several are installed, and offline.
find_program(BEMPD_CARGO cargo HINTS /usr/bin)
find_program(BEMPD_RUSTFMT rustfmt HINTS /usr/bin)
find_program(BEMPD_VALGRIND valgrind)
mark_as_advanced(BEMPD_CARGO BEMPD_RUSTFMT BEMPD_VALGRIND)
# An ordinary program cannot load a library built with sanitizers.
if(NOT BEMPD_CARGO OR CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  return()
endif()

get_filename_component(rust_programs "${BEMPD_CARGO}" DIRECTORY)
set(rust_build "${CMAKE_CURRENT_BINARY_DIR}/rust")
set(rust_source "${PROJECT_SOURCE_DIR}/bindings/rust")
set(rust_environment "PATH=${rust_programs}:$ENV{PATH}" "CARGO_HOME=${rust_build}/home"
    "CARGO_TARGET_DIR=${rust_build}/target" "RUSTFLAGS=-D warnings" "RUSTDOCFLAGS=-D warnings"
    CARGO_INCREMENTAL=0 CARGO_PROFILE_DEV_DEBUG=0 CARGO_PROFILE_TEST_DEBUG=0)  # which takes half of the time

function(bempd_add_rust_test name)
  add_test(NAME ${name} COMMAND ${ARGN} WORKING_DIRECTORY "${rust_source}")
  set_tests_properties(${name} PROPERTIES RESOURCE_LOCK cargo TIMEOUT 900)
endfunction()

set(rust_with_library "${CMAKE_COMMAND}" -E env ${rust_environment} "BEMPD_LIB_DIR=$<TARGET_FILE_DIR:bempd>")
bempd_add_rust_test(bindings.rust ${rust_with_library} "${BEMPD_CARGO}" test --workspace --offline --locked)
set_tests_properties(bindings.rust PROPERTIES COST 150)

if(BEMPD_RUSTFMT)
  file(GLOB rust_roots CONFIGURE_DEPENDS "${rust_source}/*/build.rs" "${rust_source}/bempd/src/lib.rs"
       "${rust_source}/bempd/tests/*/main.rs" "${PROJECT_SOURCE_DIR}/examples/*/main.rs")
  add_test(NAME bindings.rust_format
    COMMAND "${BEMPD_RUSTFMT}" --check --edition 2021 --config-path "${rust_source}" ${rust_roots})
  set_tests_properties(bindings.rust_format PROPERTIES LABELS delivery)
endif()

# example.readme_programs_run_and_print_the_same compares the first programs, too.
if(TARGET example_first_crack)
  bempd_add_rust_test(bindings.rust_first_crack ${rust_with_library} "${CMAKE_COMMAND}"
    -D "CARGO=${BEMPD_CARGO}" -D "C_PROGRAM=$<TARGET_FILE:example_first_crack>"
    -P "${CMAKE_CURRENT_SOURCE_DIR}/rust/first_crack.cmake")
  set_tests_properties(bindings.rust_first_crack PROPERTIES LABELS long FIXTURES_SETUP rust_first_crack)

  if(BEMPD_VALGRIND)
    bempd_add_rust_test(bindings.rust_valgrind "${BEMPD_VALGRIND}" --leak-check=full
      --errors-for-leak-kinds=definite,indirect --error-exitcode=1 "${rust_build}/target/debug/examples/first_crack")
    set_tests_properties(bindings.rust_valgrind PROPERTIES LABELS long FIXTURES_REQUIRED rust_first_crack)
  endif()
endif()

# A host's view: a package of its own that finds the installed library by pkg-config.
if(BEMPD_INSTALL)
  bempd_add_rust_test(package.cargo "${CMAKE_COMMAND}" -E env ${rust_environment} "${CMAKE_COMMAND}"
    -D "CARGO=${BEMPD_CARGO}" -D "WORK_DIR=${rust_build}/with space" -D "BUILD_DIR=${PROJECT_BINARY_DIR}"
    -D "LIBDIR=${CMAKE_INSTALL_LIBDIR}" -D "CRATES=${rust_source}" -D "VERSION=${PROJECT_VERSION}"
    -P "${PROJECT_SOURCE_DIR}/tests/package/cargo.cmake")
  bempd_add_rust_test(package.rust_lines bash "${PROJECT_SOURCE_DIR}/tests/package/rust_lines.sh" "${PROJECT_SOURCE_DIR}"
    "${PROJECT_BINARY_DIR}/tests/package/with space/prefix moved" "${CMAKE_INSTALL_LIBDIR}" "${rust_build}/lines"
    "${PROJECT_VERSION}" "${BEMPD_CARGO}")
  set_tests_properties(package.cargo PROPERTIES LABELS delivery)
  set_tests_properties(package.rust_lines PROPERTIES LABELS long)
  set_tests_properties(package.rust_lines PROPERTIES FIXTURES_REQUIRED installed_package ENVIRONMENT "PATH=${rust_programs}:$ENV{PATH}")
endif()
