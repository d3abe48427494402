bempd_add_engine_test(curved_patch_test curved_patch_test.cpp)

if(TARGET bempd)
  bempd_add_host_test(curved_lame_test curved_lame_test.cpp)
  bempd_add_host_test(curved_inclusion_test curved_inclusion_test.cpp)
  bempd_add_host_test(curved_plate_test curved_plate_test.cpp)
endif()
