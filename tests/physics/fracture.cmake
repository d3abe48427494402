if(TARGET bempd)
  bempd_add_host_tests(fracture_tests heat_test.cpp crack_pressure_test.cpp changing_heat_test.cpp
    compression_test.cpp fracture_increments_test.cpp strength_test.cpp crack_meshes_test.cpp line_directions_test.cpp line_loads_test.cpp fracture_centre_crack_test.cpp fracture_griffith_test.cpp
    fracture_tip_test.cpp lattice_tips_test.cpp mixed_cracks_test.cpp fracture_path_test.cpp fracture_stepping_test.cpp
    fracture_window_test.cpp fracture_sources_test.cpp fracture_fragments_test.cpp fracture_new_loads_test.cpp
    many_cracks_test.cpp fracture_dead_load_test.cpp fracture_equilibrium_path_test.cpp fracture_scaling_test.cpp
    outlined_elastic_test.cpp outlined_fracture_test.cpp outlined_interface_test.cpp outlined_tips_test.cpp
    joined_outlines_test.cpp)
  # Windows and plain loops are compared by random scenes (differential.random_scenes), at any ratio: by default bodies that those do not
  # have stand for all. Horizons of 3, 4 and 5 stand for 6.
  bempd_long_test(fracture_window_test fracture_tests
    "AnyRatio/*ratio_45*:AnyRatio/*crack_ratio_20*:*crack_nearly_incompressible:*wide_band:*coupled_short_windows:*inclined_crack*:*centre_crack_*:*offset_edge_cracks:*dead_load:*constant_and_proportional:*/falling_piece")
  bempd_long_test(fracture_griffith_test fracture_tests "*horizon_of_6")
  bempd_long_test(fracture_tip_test fracture_tests "*bond_by_bond")
  bempd_thorough_test(mixed_cracks_test fracture_tests mixed_cracks_test)
  bempd_shorten_test(fracture_griffith_test "*horizon_of_3")
  bempd_shorten_test(fracture_window_test "*debonding_grips:*square_hole")
  bempd_shorten_test(fracture_sources_test "*tied*")
  # Five factorizations are counted with the permissive backend where one is asked.
  bempd_shorten_test(fracture_increments_test "-*centre_crack*:*many_bonds_at_once*")
  bempd_long_test(outlined_fracture_test fracture_tests "*mouths_anywhere*")
  bempd_thorough_test(outlined_fracture_test fracture_tests outlined_fracture_test)
  bempd_thorough_test(many_cracks_test fracture_tests many_cracks_test)
  bempd_thorough_test(crack_pressure_test fracture_tests crack_pressure_test)
  if(BEMPD_SCHEME_PAPER)
    bempd_add_host_tests(paper_tests paper_scheme_test.cpp paper_fracture_test.cpp)
    bempd_long_test(paper_fracture_test paper_tests "*first_at_the_published_increment*")
  endif()
endif()
