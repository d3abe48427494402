!> Misuse of the Fortran module arrives in stat and errmsg, with the sentence of whoever found it.
program fortran_misuse
  use fortran_checks
  implicit none

  call model_that_was_not_created_is_refused()
  call errors_of_the_library_arrive_in_stat_and_errmsg()
  call wrong_shapes_are_refused_by_the_module()
  call unequal_parts_are_refused()
  call failed_calls_leave_no_results()
  call short_messages_are_cut_and_long_ones_padded()
  call states_complain_too()
  call finish_checks()

contains

  subroutine model_that_was_not_created_is_refused()
    type(bempd_model) :: model
    character(200) :: message
    integer :: stat

    call model%prepare(stat, message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_prepare: model is NULL")
    call check(index(model%last_error(), "model is NULL") > 0, "last_error tells it too")
  end subroutine model_that_was_not_created_is_refused

  subroutine errors_of_the_library_arrive_in_stat_and_errmsg()
    type(bempd_model) :: model
    character(300) :: message
    integer :: stat, id

    call model%create()
    message = "untouched"
    call model%add_material(1000._dp, 1 / 3._dp, id, stat=stat, errmsg=message)
    call check(stat == BEMPD_OK .and. message == "untouched" .and. id == 1, "success leaves errmsg alone")
    call model%add_material(-1._dp, 1 / 3._dp, stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_add_material: ")
    call check(message == model%last_error(), "errmsg and last_error are the same sentence")
    call model%add_bem_region(7, rectangle(0._dp, 0._dp, 1._dp, 1._dp), .5_dp, stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_add_bem_region: ")
    call model%add_crack(reshape([0._dp, 0._dp], [2, 1]), stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_add_crack: ")
    call model%set_option("crack.exponnet", 4._dp, stat, message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "crack.exponent")
  end subroutine errors_of_the_library_arrive_in_stat_and_errmsg

  subroutine wrong_shapes_are_refused_by_the_module()
    type(bempd_model) :: model
    real(dp) :: sideways(4, 2)
    real(dp), allocatable :: displacement(:, :), stresses(:, :)
    character(300) :: message
    integer :: stat, material, region

    sideways = transpose(rectangle(0._dp, 0._dp, 1._dp, 1._dp))
    call model%create()
    call model%add_material(1000._dp, 1 / 3._dp, material)
    call model%add_bem_region(material, sideways, .5_dp, region, stat, message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_add_bem_region: vertices has shape (4,2)")
    call check(region == 0, "no region was added")
    call check(index(model%last_error(), "transpose(vertices)") > 0, "last_error has the sentence of the module")
    call model%add_pd_region(material, sideways, .5_dp, 3, region, stat, message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_add_pd_region: vertices has shape (4,2)")
    call model%add_hole(1, sideways, stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_add_hole: vertices has shape (4,2)")
    call model%add_crack(sideways(1:3, :), stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_add_crack: points has shape (3,2)")
    call model%set_toughness_at(1, sideways, [1._dp], stat, message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_set_toughness_at: places has shape (4,2)")
    call model%set_toughness_at(1, transpose(sideways), [1._dp], stat, message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_set_toughness_at: there are 1 values and 4 places")
    call model%set_resistance_curve(1, [0._dp, 1._dp], [1._dp], stat, message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_set_resistance_curve: there are 1 energies and 2")
    call model%set_resistance_directions(1, [0._dp], [1._dp, 2._dp], stat, message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_set_resistance_directions: there are 2 energies and 1")
    call model%combined_values([1._dp], sideways, displacement, stresses, stat, message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_load_case_evaluate: points has shape (4,2)")
    call model%evaluate(sideways, displacement, stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_evaluate: points has shape (4,2)")
    call model%add_bem_region(material, transpose(sideways), .5_dp, region, stat, message)
    call check(stat == BEMPD_OK .and. region == 1, "transposed it is right")
    call check(model%last_error() == "", "success clears the sentence")
  end subroutine wrong_shapes_are_refused_by_the_module

  subroutine unequal_parts_are_refused()
    type(bempd_model) :: model
    real(dp), allocatable :: nothing(:)
    character(300) :: message
    integer :: stat, material

    call model%create()
    call model%add_material(1000._dp, 1 / 3._dp, material)
    call model%add_bem_region(material, rectangle(0._dp, 0._dp, 1._dp, 1._dp), .5_dp)
    call model%add_traction(1, 2, BEMPD_X, [1._dp, 2._dp], [1._dp, 2._dp, 3._dp], stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "constant has 2 values and proportional 3")
    call model%prescribe_edge(1, 4, BEMPD_X, [1._dp, 2._dp], [1._dp], stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "constant has 2 values and proportional 1")
    allocate (nothing(0))
    call model%add_traction(1, 2, BEMPD_X, nothing, stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_add_traction: ")
  end subroutine unequal_parts_are_refused

  subroutine failed_calls_leave_no_results()
    type(bempd_model) :: model
    real(dp), pointer :: values(:, :)
    real(dp), allocatable :: copy(:, :), displacement(:, :)
    character(300) :: message
    integer, allocatable :: nodes(:, :), bonds(:, :)
    integer :: stat

    call make_strip(model)
    call model%view_field(9, BEMPD_DISPLACEMENT, values, stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_view_field: ")
    call check(.not. associated(values), "no view after a failure")
    call model%copy_field(1, BEMPD_DAMAGE, copy, stat, message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_field_size: ")
    call check(size(copy) == 0, "no field after a failure")
    call model%copy_elements(9, nodes, stat, message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_element_count: ")
    call check(size(nodes) == 0, "no elements after a failure")
    call model%copy_bonds(1, bonds, stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_bond_count: ")
    call model%evaluate(reshape([99._dp, 0._dp], [2, 1]), displacement, stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_evaluate: ")
    call model%write_history("/no/such/folder/history.csv", stat, message)
    call check_error(stat, BEMPD_ERROR_IO, message, "bempd_write_history: ")
  end subroutine failed_calls_leave_no_results

  subroutine short_messages_are_cut_and_long_ones_padded()
    type(bempd_model) :: model
    character(12) :: short
    character(2000) :: long
    integer :: stat

    call model%prepare(stat, short)
    call check(short == "bempd_prepar", "a short message is cut")
    call model%prepare(stat, long)
    call check(long == model%last_error(), "a long message is padded")
  end subroutine short_messages_are_cut_and_long_ones_padded

  subroutine states_complain_too()
    use, intrinsic :: iso_c_binding, only: c_int8_t
    type(bempd_model) :: model
    type(bempd_state) :: state
    integer(c_int8_t), allocatable :: bytes(:)
    character(300) :: message
    integer :: stat

    call make_strip(model)
    call model%state_restore(state, stat, message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_state_restore: ")
    call state%to_bytes(bytes, stat, message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_state_to_bytes: ")
    call check(size(bytes) == 0, "no bytes after a failure")
    call state%from_bytes([integer(c_int8_t) :: 1, 2, 3], stat, message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_state_from_bytes: ")
  end subroutine states_complain_too
end program fortran_misuse
