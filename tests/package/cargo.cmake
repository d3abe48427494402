# Run by CTest with -P: the library is installed, and a package in a folder of its own is built with it and run.
file(REMOVE_RECURSE "${WORK_DIR}")
file(MAKE_DIRECTORY "${WORK_DIR}")
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${WORK_DIR}/prefix"
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

set(consumer "${WORK_DIR}/consumer")
file(COPY "${CMAKE_CURRENT_LIST_DIR}/cargo_consumer/" DESTINATION "${consumer}" PATTERN "*.in" EXCLUDE)
configure_file("${CMAKE_CURRENT_LIST_DIR}/cargo_consumer/Cargo.toml.in" "${consumer}/Cargo.toml" @ONLY)

foreach(name BEMPD_LIB_DIR LD_LIBRARY_PATH PKG_CONFIG_LIBDIR)
  unset(ENV{${name}})
endforeach()
set(ENV{PKG_CONFIG_PATH} "${WORK_DIR}/prefix/${LIBDIR}/pkgconfig")
set(ENV{CARGO_TARGET_DIR} "${consumer}/target")
execute_process(COMMAND "${CARGO}" build --offline WORKING_DIRECTORY "${consumer}" COMMAND_ERROR_IS_FATAL ANY)
# Started by itself, since cargo adds search paths of its own.
execute_process(COMMAND "${consumer}/target/debug/consumer" OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
message("${output}")
if(NOT output STREQUAL "bempd ${VERSION}\n")
  message(FATAL_ERROR "expected 'bempd ${VERSION}'")
endif()

# The installed library is the one that runs, not that of the build tree.
execute_process(COMMAND ldd "${consumer}/target/debug/consumer" OUTPUT_VARIABLE libraries COMMAND_ERROR_IS_FATAL ANY)
string(FIND "${libraries}" "${WORK_DIR}/prefix/${LIBDIR}/libbempd.so" place)
if(place EQUAL -1)
  message(FATAL_ERROR "the program runs with another library:\n${libraries}")
endif()

# A folder without the library is refused with a sentence.
set(ENV{BEMPD_LIB_DIR} "${WORK_DIR}")
execute_process(COMMAND "${CARGO}" build --offline WORKING_DIRECTORY "${consumer}" RESULT_VARIABLE status
                ERROR_VARIABLE error)
string(FIND "${error}" "bempd-sys: BEMPD_LIB_DIR is \"${WORK_DIR}\", where no libbempd.so is" place)
if(status EQUAL 0 OR place EQUAL -1)
  message(FATAL_ERROR "expected the build to stop with a sentence on BEMPD_LIB_DIR, got:\n${error}")
endif()
