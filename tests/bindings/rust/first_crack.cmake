# Run by CTest with -P: the Rust program and the C program print the same line.
function(output_of result)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
  set(${result} "${output}" PARENT_SCOPE)
endfunction()

output_of(ours "${CARGO}" run --quiet --offline --locked --example first_crack)
output_of(reference "${C_PROGRAM}")
message("Rust: ${ours}C:    ${reference}")
if(reference STREQUAL "" OR NOT ours STREQUAL reference)
  message(FATAL_ERROR "the lines differ")
endif()
