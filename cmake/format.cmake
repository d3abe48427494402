# `format` rewrites the sources in the project's style, `format-check` fails if that would change anything.
find_program(BEMPD_CLANG_FORMAT NAMES clang-format clang-format-14)
mark_as_advanced(BEMPD_CLANG_FORMAT)
if(NOT BEMPD_CLANG_FORMAT)
  return()
endif()

set(formatted_patterns)
foreach(folder include src tests examples benchmarks)
  foreach(suffix h c hpp cpp)
    list(APPEND formatted_patterns "${PROJECT_SOURCE_DIR}/${folder}/*.${suffix}")
  endforeach()
endforeach()
file(GLOB_RECURSE formatted_files CONFIGURE_DEPENDS ${formatted_patterns})

add_custom_target(format COMMAND "${BEMPD_CLANG_FORMAT}" -i ${formatted_files} VERBATIM)
add_custom_target(format-check COMMAND "${BEMPD_CLANG_FORMAT}" --dry-run --Werror ${formatted_files} VERBATIM)
