# `tidy` looks through src/ with clang-tidy. Run it with the preset of that name: compiled headers of another compiler,
# as the other presets have them, are nothing that clang-tidy can read.
find_program(BEMPD_RUN_CLANG_TIDY NAMES run-clang-tidy run-clang-tidy-14)
mark_as_advanced(BEMPD_RUN_CLANG_TIDY)
if(NOT BEMPD_RUN_CLANG_TIDY)
  return()
endif()

# Files that are compiled together are read together, which takes a fourth of the time.
add_custom_target(tidy
  COMMAND "${BEMPD_RUN_CLANG_TIDY}" -quiet -p "${CMAKE_BINARY_DIR}" "/src/.*\\.cxx$"
  USES_TERMINAL VERBATIM)
