set(files regions_cell_splits_test.cpp regions_second_kind_test.cpp regions_body_force_test.cpp second_bond_law_test.cpp)
bempd_add_engine_program(regions_tests ${files})
bempd_add_tests_of_files(regions_tests ${files} LABEL unit)
add_dependencies(unit_tests regions_tests)
