bempd_add_unit_test(paper_test paper_collocation_test.cpp paper_layer_forces_test.cpp paper_low_rank_test.cpp
  paper_lu_test.cpp paper_network_test.cpp paper_refinement_test.cpp paper_unsymmetric_test.cpp)
# The network test is compiled alone, because its bodies have the same names as those of other tests.
set_source_files_properties(paper_network_test.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
