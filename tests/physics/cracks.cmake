# Cracks and contact against the engine's layers; bodies with cracks and their equilibrium by other means.
set(files crack_operator_test.cpp cut_operator_test.cpp crack_factors_test.cpp crack_extremes_test.cpp crack_kept_blocks_test.cpp
  crack_kinks_test.cpp crack_gaps_test.cpp closing_crack_test.cpp driven_cracks_test.cpp turning_and_cracked_test.cpp
  contact_test.cpp)
bempd_add_engine_program(cracks_tests ${files} contact_bodies.cpp closing_cracks.cpp)
target_link_libraries(cracks_tests PRIVATE bempd_claims)
bempd_add_tests_of_files(cracks_tests ${files} LABEL physics)
bempd_thorough_test(contact_test cracks_tests contact_test)
bempd_shorten_test(contact_test "-*quadratic_programme*:*windows_switch*:*wings*")
if(TARGET bempd)
  bempd_add_host_tests(cut_tests cut_regions_test.cpp resting_tips_test.cpp crossed_interfaces_test.cpp crossed_borders_test.cpp)
  bempd_thorough_test(crossed_borders_test cut_tests crossed_borders_test)
endif()
