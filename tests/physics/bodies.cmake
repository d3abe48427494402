# Solids of boundary elements, of lattices and of both, whose fields are known, against the engine's layers.
set(files bem_patch_test.cpp bem_thin_patch_test.cpp bem_cantilever_test.cpp bem_interior_test.cpp bem_subdomains_test.cpp curved_patch_test.cpp
  pd_patch_test.cpp pd_kirsch_test.cpp pd_any_ratio_test.cpp coupled_operator_test.cpp free_expansion_test.cpp
  economy_sharing_test.cpp)
if(BEMPD_SCHEME_PAPER)
  list(APPEND files paper_collocation_patch_test.cpp paper_curved_patch_test.cpp paper_collocation_cantilever_test.cpp)
endif()
bempd_add_engine_program(bodies_tests ${files})
bempd_add_tests_of_files(bodies_tests ${files} LABEL physics)
bempd_thorough_test(pd_patch_test bodies_tests pd_patch_test)
