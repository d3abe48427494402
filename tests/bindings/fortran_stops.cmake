# Runs PROGRAM with WAY: it must fail with SENTENCE on the error stream and print nothing.
execute_process(COMMAND "${PROGRAM}" "${WAY}" RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE errors)
if(status EQUAL 0 OR NOT output STREQUAL "" OR NOT errors MATCHES "${SENTENCE}")
  message(FATAL_ERROR "status ${status}, output '${output}', errors '${errors}'; expected '${SENTENCE}'")
endif()
