!> What the library calls during the runs below.
module fortran_listener
  use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int32_t, c_int64_t, c_f_pointer, c_ptr, c_sizeof
  use fortran_checks
  implicit none

  type :: listener
    integer :: calls = 0, cancel_at = 0
    integer(c_int64_t) :: events = 0
    character(200) :: line = ""
  end type listener

contains

  function listen(load_factor, events, broken_bonds, user) bind(c) result(stop_now)
    real(c_double), value :: load_factor
    integer(c_int64_t), value :: events, broken_bonds
    type(c_ptr), value :: user
    integer(c_int32_t) :: stop_now
    type(listener), pointer :: heard

    call c_f_pointer(user, heard)
    heard%calls = heard%calls + 1
    heard%events = events
    call check(load_factor > 0 .and. broken_bonds >= events, "progress hears sensible numbers")
    stop_now = merge(1, 0, heard%calls == heard%cancel_at)
  end function listen

  function hear_phase(phase, share, seconds, expected, user) bind(c) result(stop_now)
    character(kind=c_char), intent(in) :: phase(*)
    real(c_double), value :: share, seconds, expected
    type(c_ptr), value :: user
    integer(c_int32_t) :: stop_now
    type(listener), pointer :: heard

    call c_f_pointer(user, heard)
    heard%calls = heard%calls + 1
    heard%line = bempd_text(phase)
    call check(share >= 0 .and. share <= 1 .and. seconds >= 0 .and. expected >= 0, "phases hear sensible numbers")
    stop_now = merge(1, 0, heard%calls == heard%cancel_at)
  end function hear_phase

  subroutine note(level, message, user) bind(c)
    integer(c_int32_t), value :: level
    character(kind=c_char), intent(in) :: message(*)
    type(c_ptr), value :: user
    type(listener), pointer :: heard

    call c_f_pointer(user, heard)
    heard%calls = heard%calls + 1
    heard%line = bempd_text(message)
    call check(level >= 1 .and. level <= 3, "a log line has a level")
  end subroutine note

  function resistance(crack, tip_end, equivalent, ratio, k1, k2, t_stress, length, x, y, user) bind(c) result(energy)
    integer(c_int32_t), value :: crack, tip_end
    real(c_double), value :: equivalent, ratio, k1, k2, t_stress, length, x, y
    type(c_ptr), value :: user
    real(c_double) :: energy
    real(c_double), pointer :: said

    call c_f_pointer(user, said)
    energy = said
    if (crack /= 1 .or. tip_end < 1 .or. equivalent < k1 .or. abs(ratio - 1) > 0 .or. abs(k2) > k1 .or. t_stress > 0 &
      .or. length < 0 .or. abs(x) < .2 .or. abs(y) > .1) energy = -2
  end function resistance

  function linear(x, y, constant, proportional, user) bind(c) result(stop_now)
    real(c_double), value :: x, y
    real(c_double), intent(inout) :: constant(2), proportional(2)
    type(c_ptr), value :: user
    integer(c_int32_t) :: stop_now
    type(listener), pointer :: heard

    call c_f_pointer(user, heard)
    heard%calls = heard%calls + 1
    call check(x >= 0 .and. maxval(abs(constant)) <= 0, "a boundary function starts from zeros")
    proportional(1) = 3 + y
    stop_now = merge(1, 0, heard%calls == heard%cancel_at)
  end function linear
end module fortran_listener

!> Runs through the Fortran module: views, callbacks, repeated steps, options, results.
program fortran_runs
  use, intrinsic :: iso_c_binding, only: c_int8_t, c_int32_t, c_int64_t, c_loc, c_sizeof
  use fortran_listener
  implicit none

  call views_alias_the_memory_of_the_library()
  call fields_fill_arrays_of_the_host()
  call generation_tells_when_a_view_is_old()
  call progress_cancels_and_the_step_returns_to_its_start()
  call long_parts_are_told()
  call log_lines_arrive()
  call explanations_are_sentences_and_numbers()
  call boundary_functions_give_what_arrays_give()
  call boundary_function_can_cancel()
  call restored_state_repeats_a_step_bit_by_bit()
  call options_are_set_listed_and_read_back()
  call indices_count_from_one()
  call pressure_in_a_crack_has_its_factor_and_opening()
  call cracks_grow_where_they_are_not_frozen()
  call cracks_grow_by_cycles_and_by_lengths()
  call load_cases_add_up()
  call cracks_grow_between_load_cases()
  call functions_give_resistances()
  call reactions_and_evaluation_agree_with_a_uniform_bar()
  call pressure_and_moments_balance()
  call edges_sides_arcs_and_singular_places()
  call what_is_removed_leaves_no_trace()
  call history_and_statistics_belong_together()
  call the_path_of_equilibrium_costs_what_bonds_take()
  call snapshots_of_another_run_are_kept()
  call models_are_freed_and_created_again()
  call finish_checks()

contains

  subroutine views_alias_the_memory_of_the_library()
    type(bempd_model) :: model
    real(dp), pointer :: first(:, :), second(:, :)
    real(dp), allocatable :: copy(:, :)
    integer(c_int64_t) :: nodes, stamp, now

    call make_strip(model)
    call model%step(.5_dp)
    call model%view_field(2, BEMPD_DISPLACEMENT, first, stamp)
    call model%view_field(2, BEMPD_DISPLACEMENT, second)
    call model%copy_field(2, BEMPD_DISPLACEMENT, copy)
    call model%node_count(2, nodes)
    call model%generation(now)
    call check(all(shape(first, c_int64_t) == [2_c_int64_t, nodes]), "a view is (components,n)")
    call check(associated(first, second), "two views are the same memory")
    call check(same_bits(first, copy) .and. maxval(abs(copy)) > 0, "a copy has the same numbers")
    call check(stamp == now, "a view carries the generation")
    call model%view_field(2, BEMPD_DAMAGE, first)
    call check(size(first, 1) == 1 .and. size(first, 2) == nodes, "a scalar field is (1,n)")
  end subroutine views_alias_the_memory_of_the_library

  subroutine generation_tells_when_a_view_is_old()
    type(bempd_model) :: model
    real(dp), pointer :: values(:, :)
    integer(c_int64_t) :: stamp, now

    call make_strip(model)
    call model%step(.25_dp)
    call model%view_field(2, BEMPD_DISPLACEMENT, values, stamp)
    call model%step(.5_dp)
    call model%generation(now)
    call check(now /= stamp, "a step changes the generation")
  end subroutine generation_tells_when_a_view_is_old

  subroutine long_parts_are_told()
    type(bempd_model) :: model
    type(listener), target :: heard
    character(300) :: message
    integer :: stat

    call make_strip(model)
    heard%cancel_at = 1
    call model%set_phase_progress(hear_phase, c_loc(heard))
    call model%step(.1_dp, stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_CANCELLED, message, "bempd_step: the phase callback")
    call check(heard%calls == 1 .and. len_trim(heard%line) > 0, "a phase has a name")
    call model%set_phase_progress()
    call model%request_stop()
    call model%step(.1_dp)
    call check(heard%calls == 1, "nobody hears of phases any more")
  end subroutine long_parts_are_told

  subroutine progress_cancels_and_the_step_returns_to_its_start()
    type(bempd_model) :: model
    type(bempd_step_report) :: report
    type(listener), target :: heard
    real(dp), allocatable :: before(:, :), after(:, :)
    real(dp) :: reached
    character(300) :: message
    integer :: stat

    call make_strip(model)
    call model%step(.1_dp)
    call model%copy_field(2, BEMPD_DISPLACEMENT, before)
    heard%cancel_at = 3
    call model%set_progress(listen, c_loc(heard))
    call model%run_to_separation(1e6_dp, report, stat, message)
    call check_error(stat, BEMPD_ERROR_CANCELLED, message, "bempd_run_to_separation: ")
    call check(heard%calls == 3, "progress was called until it cancelled")
    call model%load_factor(reached)
    call model%copy_field(2, BEMPD_DISPLACEMENT, after)
    call check(abs(reached - .1_dp) <= 0 .and. same_bits(before, after), "a cancelled step returns to its start")
    call model%set_progress()
    call model%run_to_separation(1e6_dp, report)
    call check(heard%calls == 3 .and. report%separated == 1, "without progress it runs to the end")
  end subroutine progress_cancels_and_the_step_returns_to_its_start

  subroutine explanations_are_sentences_and_numbers()
    type(bempd_model) :: model
    type(bempd_explanation) :: next
    character(:), allocatable :: text

    call make_strip(model)
    call model%explain(text, explanation=next)
    call check(index(text, "While the load factor rises") == 1, "an explanation is sentences")
    call check(next%load_factor > 0 .and. next%next /= BEMPD_NEXT_NOTHING, "it says what comes next")
    call model%explain(text, rising=.false.)
    call check(index(text, "While the load factor falls") == 1 .or. index(text, "Nothing") == 1, "and on the way back")
  end subroutine explanations_are_sentences_and_numbers

  subroutine log_lines_arrive()
    type(bempd_model) :: model
    type(listener), target :: heard

    call make_strip(model)
    call model%set_log(note, c_loc(heard))
    call model%prepare()
    call check(heard%calls > 0 .and. heard%line /= "", "preparing writes to the log")
    call model%set_log()
  end subroutine log_lines_arrive

  !> A square fixed at the left, ready for a traction on its right edge.
  subroutine make_square(model)
    type(bempd_model), intent(inout) :: model
    integer :: material

    call model%create()
    call model%add_material(1000._dp, .3_dp, material)
    call model%add_bem_region(material, rectangle(0._dp, 0._dp, 1._dp, 1._dp), .25_dp)
    call model%fix_edge(1, 4, BEMPD_X)
    call model%fix_point(0._dp, 0._dp, BEMPD_Y)
  end subroutine make_square

  subroutine boundary_functions_give_what_arrays_give()
    type(bempd_model) :: by_array, by_function
    type(listener), target :: heard
    real(dp), allocatable :: one(:, :), other(:, :)

    call make_square(by_array)
    call by_array%add_traction(1, 2, BEMPD_X, proportional=[3._dp, 4._dp])
    call by_array%step(1._dp)
    call by_array%copy_field(1, BEMPD_DISPLACEMENT, one)
    call make_square(by_function)
    call by_function%add_traction_function(1, 2, linear, c_loc(heard))
    call by_function%step(1._dp)
    call by_function%copy_field(1, BEMPD_DISPLACEMENT, other)
    call check(heard%calls > 0, "the function was called")
    call check(maxval(abs(one - other)) <= 1e-12_dp * maxval(abs(one)), "function and array give the same")
  end subroutine boundary_functions_give_what_arrays_give

  subroutine boundary_function_can_cancel()
    type(bempd_model) :: model
    type(listener), target :: heard
    character(300) :: message
    integer :: stat, support

    call make_square(model)
    heard%cancel_at = 1
    call model%prescribe_edge_function(1, 2, BEMPD_X, linear, c_loc(heard), support=support)
    call model%prepare(stat, message)
    call check_error(stat, BEMPD_ERROR_CANCELLED, message, "bempd_prepare: ")
    call check(support == 3 .and. heard%calls == 1, "the function was called once")
  end subroutine boundary_function_can_cancel

  subroutine restored_state_repeats_a_step_bit_by_bit()
    type(bempd_model) :: model, twin
    type(bempd_state) :: state, copy
    type(bempd_step_report) :: first, second, third
    integer(c_int8_t), allocatable :: bytes(:)
    real(dp), allocatable :: once(:, :), again(:, :), elsewhere(:, :)
    real(dp) :: limit

    call make_strip(model)
    call model%step_to_next_event(1e6_dp, first)
    limit = 1.2_dp * first%load_factor
    call model%state_save(state)
    call model%step(limit, first)
    call model%copy_field(2, BEMPD_DISPLACEMENT, once)
    call model%state_restore(state)
    call model%step(limit, second)
    call model%copy_field(2, BEMPD_DISPLACEMENT, again)
    call check(first%broken_bonds > 0, "the step breaks bonds")
    call check(same_bits(once, again) .and. first%broken_bonds == second%broken_bonds, &
      "a repeated step gives the same bits")

    call state%to_bytes(bytes)
    call state%free()
    call copy%from_bytes(bytes)
    call make_strip(twin)
    call twin%state_restore(copy)
    call twin%step(limit, third)
    call twin%copy_field(2, BEMPD_DISPLACEMENT, elsewhere)
    call check(same_bits(once, elsewhere) .and. third%broken_bonds == first%broken_bonds, &
      "the bytes of a state repeat the step in another model")
  end subroutine restored_state_repeats_a_step_bit_by_bit

  subroutine options_are_set_listed_and_read_back()
    type(bempd_model) :: model
    type(bempd_option), allocatable :: options(:)
    real(dp) :: number
    character(:), allocatable :: word
    integer :: k, texts

    call model%create()
    call model%set_option("crack.exponent ", 5._dp)
    call model%get_option("crack.exponent", number)
    call check(abs(number - 5) <= 0, "a number option is read back")
    call model%set_option("critical_stretch", "printed")
    call model%get_option("critical_stretch", word)
    call check(word == "printed", "a text option is read back")
    call bempd_get_options(options)
    texts = 0
    do k = 1, size(options)
      call check(len(options(k)%name) > 0 .and. len(options(k)%summary) > 0, "an option has a name and a sentence")
      if (options(k)%kind == BEMPD_OPTION_NUMBER) then
        call check(options(k)%minimum <= options(k)%default_value .and. &
          options(k)%default_value <= options(k)%maximum, options(k)%name // ": the default is within the range")
      else
        texts = texts + 1
        call check(index(options(k)%choices, options(k)%default_text) > 0, &
          options(k)%name // ": the default is a choice")
      end if
    end do
    call check(texts > 0 .and. size(options) > texts, "there are options of both kinds")
    word = bempd_build()
    call check(index(word, "bempd " // bempd_version()) == 1, "the build tells the version")
  end subroutine options_are_set_listed_and_read_back

  subroutine fields_fill_arrays_of_the_host()
    type(bempd_model) :: model
    real(dp), allocatable :: copy(:, :)
    real(dp) :: fixed(2, 121), whole(3, 0:200), small(2, 5)
    character(300) :: message
    integer :: stat

    call make_strip(model)
    call model%step(.1_dp)
    call model%copy_field(2, BEMPD_DISPLACEMENT, copy)
    call model%fill_field(2, BEMPD_DISPLACEMENT, fixed)
    call check(same_bits(copy, fixed), "a fixed array has the numbers of a copy")
    whole = -7
    call model%fill_field(2, BEMPD_DISPLACEMENT, whole(1:2, 10:130))
    call check(same_bits(copy, whole(1:2, 10:130)), "a part of an array is filled")
    call check(all(abs(whole(3, :) + 7) <= 0) .and. all(abs(whole(1, :9) + 7) <= 0), "and nothing around it")
    small = 5
    call model%fill_field(2, BEMPD_DISPLACEMENT, small, stat, message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "(2,5); the field has (2,121)")
    call model%fill_field(1, BEMPD_DAMAGE, small, stat, message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_field_size: ")
    call check(all(abs(small - 5) <= 0), "what is refused changes nothing")
  end subroutine fields_fill_arrays_of_the_host

  subroutine snapshots_of_another_run_are_kept()
    type(bempd_model) :: first, second
    character(300) :: message
    integer :: stat
    logical :: there

    call make_strip(first)
    call first%set_option("snapshots.existing", "replace")
    call first%write_snapshot("fortran_snapshot")
    call make_strip(second)
    call second%write_snapshot("fortran_snapshot", stat, message)
    call check_error(stat, BEMPD_ERROR_IO, message, "of another run")
    call second%set_option("snapshots.existing", "continue")
    call second%write_snapshot("fortran_snapshot")
    inquire (file="fortran_snapshot_0001_inside.vtu", exist=there)
    call check(there, "a continued series has the inside of boundary element regions")
    call first%free()
    call second%free()
  end subroutine snapshots_of_another_run_are_kept

  subroutine indices_count_from_one()
    type(bempd_model) :: model
    integer, allocatable :: cells(:, :), elements(:, :), bonds(:, :), states(:)
    real(dp), pointer :: position(:, :)
    integer(c_int64_t) :: count
    integer(c_int32_t) :: regions, edges
    integer :: stat
    character(200) :: message

    call make_strip(model)
    call model%prepare()
    call model%region_count(regions)
    call model%edge_count(2, edges)
    call check(regions == 3 .and. edges == 4, "three regions of four edges")
    call model%name_edge(2, 3, "lid")
    call model%edge_named(2, "lid", edges)
    call check(edges == 3, "an edge has its name")
    call model%name_region(2, "middle")
    call model%name_support(1, "clamp")
    call model%name_load(1, "wind", stat=stat, errmsg=message)
    call check(stat == BEMPD_ERROR_ARGUMENT .and. index(message, "load 1 does not exist") > 0, "a load that is not there")
    call model%edge_named(2, "floor", edges, stat=stat, errmsg=message)
    call check(stat == BEMPD_ERROR_ARGUMENT .and. index(message, 'region 2 ("middle")') > 0, "messages have names")
    call model%copy_elements(1, elements)
    call model%element_count(1, count)
    call check(size(elements, 1) == 3 .and. size(elements, 2) == count, "boundary elements have three nodes")
    call model%copy_elements(2, cells)
    call check(size(cells, 1) == 4 .and. size(cells, 2) == 100, "10 x 10 cells of four points")
    call model%view_field(2, BEMPD_POSITION, position)
    call check(minval(cells) == 1 .and. maxval(cells) == size(position, 2), "cells name points 1 .. n")
    call check(maxval(abs(position(:, cells(3, :)) - position(:, cells(1, :)) - .2_dp)) < 1e-12_dp, &
      "the diagonal of a cell is one spacing in x and y")
    call model%copy_bonds(2, bonds, states)
    call model%bond_count(2, count)
    call check(size(bonds, 2) == count .and. minval(bonds) == 1 .and. maxval(bonds) == size(position, 2), &
      "bonds join points 1 .. n")
    call check(any(states == BEMPD_BOND_CUT) .and. .not. any(states == BEMPD_BOND_BROKEN), "the crack cuts bonds")
  end subroutine indices_count_from_one

  subroutine pressure_in_a_crack_has_its_factor_and_opening()
    type(bempd_model) :: model
    type(bempd_crack_tip), allocatable :: found(:)
    real(dp), allocatable :: normal(:), tangential(:)
    integer(c_int32_t) :: material, crack, load
    integer(c_int64_t), allocatable :: events(:)
    real(dp), allocatable :: factors(:)
    real(dp), parameter :: expected = 3 * sqrt(acos(-1.0_dp) * .01_dp)
    integer :: stat
    character(200) :: message

    call model%create()
    call model%add_material(1.0_dp, .3_dp, material)
    call model%add_bem_region(material, reshape([-1, -1, 1, -1, 1, 1, -1, 1] * 1.0_dp, [2, 4]), .5_dp)
    call model%add_crack(reshape([-.01_dp, 0.0_dp, .01_dp, 0.0_dp], [2, 2]), crack)
    call model%fix_point(-1.0_dp, -1.0_dp, BEMPD_BOTH)
    call model%fix_point(1.0_dp, -1.0_dp, BEMPD_Y)
    call model%add_crack_traction(crack, BEMPD_PRESSURE, constant=[3.0_dp], load=load)
    call model%tips(found)
    call check(size(found) == 2, "a crack has two tips")
    call check(found(1)%end == BEMPD_CRACK_START .and. found(2)%crack == crack, "tips are sorted")
    call check(maxval(abs(found%stress_intensity_1 / expected - 1)) < 3e-4_dp, "pressure gives p sqrt(pi a)")
    call model%crack_opening(crack, [.5_dp, 1.0_dp], normal, tangential)
    call check(abs(normal(1) - 4 * 3 * .01_dp) < 1e-3_dp * normal(1) .and. abs(normal(2)) < 1e-12_dp, "it opens")
    call check(maxval(abs(tangential)) < 1e-6_dp * normal(1), "it does not slide")
    call check(all(found%method == BEMPD_TIP_ELEMENTS), "they have elements")
    call model%set_option("tips.record", 1.0_dp)
    call model%step(2._dp)
    call model%tip_history(found, events=events, load_factors=factors)
    call check(size(found) == 2 .and. all(events == 0) .and. all(abs(factors - 2) < 1e-12_dp), "tips are recorded")
    call check(maxval(abs(found%stress_intensity_1 / expected - 1)) < 3e-4_dp, "recorded tips have their factors")
    call model%write_tips("nowhere/at/all.csv", stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_IO, message, "bempd_write_tips: ")
    call model%grow_cracks(.001_dp, stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_UNSOLVABLE, message, "bempd_grow_cracks: ")
    call model%crack_opening(2, [.5_dp], normal, stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_crack_opening: ")
    call model%add_crack_traction(crack, 7, constant=[3.0_dp], stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ORDER, message, "bempd_add_crack_traction: ")
  end subroutine pressure_in_a_crack_has_its_factor_and_opening

  subroutine cracks_grow_by_cycles_and_by_lengths()
    type(bempd_model) :: model
    type(bempd_growth) :: growth
    type(bempd_growth_rate) :: rate
    type(bempd_fatigue) :: options
    type(bempd_fatigue_report) :: report
    type(bempd_fatigue_record), allocatable :: found(:)
    integer(c_int32_t) :: material, crack
    integer :: stat
    character(200) :: message

    call model%create()
    call model%add_material(1.0_dp, .3_dp, material)
    call model%add_bem_region(material, reshape([-1, -1, 1, -1, 1, 1, -1, 1] * 1.0_dp, [2, 4]), .5_dp)
    call model%add_crack(reshape([-.3_dp, 0.0_dp, .3_dp, 0.0_dp], [2, 2]), crack)
    call model%fix_point(-1.0_dp, -1.0_dp, BEMPD_BOTH)
    call model%fix_point(1.0_dp, -1.0_dp, BEMPD_Y)
    call model%add_crack_traction(crack, BEMPD_PRESSURE, proportional=[1.0_dp])
    call model%grow_fatigue([1.0_dp], [0.0_dp], stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_grow_fatigue: ")
    stat = bempd_growth_rate_init(rate, c_sizeof(rate))
    rate%coefficient = 1e-6_dp
    rate%exponent = 3
    call model%set_growth_rate(material, rate)
    stat = bempd_fatigue_init(options, c_sizeof(options))
    options%most_length = .7_dp
    call model%grow_fatigue([1.0_dp], [0.0_dp], options=options, report=report)
    call model%fatigue_records(found)
    call check(report%stop_reason == BEMPD_FATIGUE_LENGTH .and. abs(report%growth - .1_dp) < 1e-9_dp, "grown by cycles")
    call check(size(found) == 2 * (report%steps + 1), "a record for each tip and step")
    call check(abs(found(size(found))%cycles - report%cycles) <= 0, "the last record has the cycles of the report")
    call model%extend_cracks([crack], [int(BEMPD_CRACK_END, c_int32_t)], [.05_dp], growth)
    call check(growth%tips == 1 .and. abs(growth%length - .05_dp) < 1e-9_dp, "a tip has grown by a length")
  end subroutine cracks_grow_by_cycles_and_by_lengths

  subroutine load_cases_add_up()
    real(dp), parameter :: square(2, 4) = reshape([-1._dp, -1._dp, 1._dp, -1._dp, 1._dp, 1._dp, -1._dp, 1._dp], [2, 4])
    type(bempd_model) :: model
    type(bempd_crack_tip), allocatable :: one(:), other(:), both(:)
    real(dp), allocatable :: displacement(:, :), stress(:, :)
    real(dp) :: force(2)
    integer(c_int32_t) :: material, crack, held, loads(3), cases(2), count
    integer(c_int64_t) :: pressed

    call model%create()
    call model%add_material(1._dp, .3_dp, material, fracture_energy=1._dp)
    call model%set_resistance_curve(material, [0._dp, 1._dp], [1._dp, 2._dp])
    call model%set_resistance_directions(material, [0._dp, 1._dp], [1._dp, 1.5_dp])
    call model%add_bem_region(material, square, .5_dp)
    call model%add_crack(reshape([-.3_dp, 0._dp, .3_dp, 0._dp], [2, 2]), crack)
    call model%fix_point(-1._dp, -1._dp, BEMPD_BOTH, held)
    call model%fix_point(1._dp, -1._dp, BEMPD_Y)
    call model%add_traction(1, 3, BEMPD_Y, proportional=[1._dp], load=loads(1))
    call model%add_traction(1, 1, BEMPD_Y, proportional=[-1._dp], load=loads(2))
    call model%add_crack_traction(crack, BEMPD_PRESSURE, proportional=[1._dp], load=loads(3))
    call model%add_load_case(loads(1:2), load_case=cases(1))
    call model%add_load_case(loads(3:3), load_case=cases(2))
    call model%load_case_count(count)
    call check(count == 2 .and. cases(2) == 2, "there are two load cases")
    call model%combined_tips([1._dp, 0._dp], one)
    call model%combined_tips([0._dp, 1._dp], other)
    call model%combined_tips([2._dp, .5_dp], both)
    call check(abs(2 * one(1)%stress_intensity_1 + .5_dp * other(1)%stress_intensity_1 - both(1)%stress_intensity_1) < 1e-9_dp, &
      "factors add up")
    call model%combined_reaction([1._dp], held, force)
    call model%combined_values([1._dp], reshape([.5_dp, .5_dp], [2, 1]), displacement, stress)
    call model%pressed_faces([1._dp], pressed)
    call check(maxval(abs(force)) < 1e-9_dp .and. stress(2, 1) > .5_dp .and. pressed == 0, "the plate is pulled")
    call model%free()
  end subroutine load_cases_add_up

  subroutine cracks_grow_between_load_cases()
    type(bempd_model) :: model
    type(bempd_growth_rate) :: rate
    type(bempd_fatigue) :: options
    type(bempd_fatigue_report) :: report
    type(bempd_fatigue_record), allocatable :: found(:)
    integer(c_int32_t) :: material, crack, pressure
    integer :: stat
    character(200) :: message

    call model%create()
    call model%add_material(1.0_dp, .3_dp, material)
    call model%add_bem_region(material, reshape([-1, -1, 1, -1, 1, 1, -1, 1] * 1.0_dp, [2, 4]), .5_dp)
    call model%add_crack(reshape([-.3_dp, 0.0_dp, .3_dp, 0.0_dp], [2, 2]), crack)
    call model%fix_point(-1.0_dp, -1.0_dp, BEMPD_BOTH)
    call model%fix_point(1.0_dp, -1.0_dp, BEMPD_Y)
    call model%add_crack_traction(crack, BEMPD_PRESSURE, proportional=[1.0_dp], load=pressure)
    call model%add_load_case([pressure])
    stat = bempd_growth_rate_init(rate, c_sizeof(rate))
    rate%coefficient = 1e-6_dp
    rate%exponent = 3
    call model%set_growth_rate(material, rate)
    stat = bempd_fatigue_init(options, c_sizeof(options))
    options%most_length = .7_dp
    call model%grow_fatigue_cases(reshape([1.0_dp, 2.0_dp], [2, 1]), reshape([0.0_dp, 0.0_dp], [2, 1]), stat=stat, &
      errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_grow_fatigue_cases: ")
    call model%grow_fatigue_cases(reshape([.5_dp, 1.0_dp], [1, 2]), reshape([0.0_dp, .5_dp], [1, 2]), &
      [100.0_dp, 100.0_dp], options, report)
    call check(report%stop_reason == BEMPD_FATIGUE_LENGTH .and. abs(report%growth - .1_dp) < 1e-9_dp, "grown between cases")
    call model%fatigue_records(found)
    call check(all(abs(found%ratio) < 1e-6_dp), "the ranges of both blocks begin at 0")
  end subroutine cracks_grow_between_load_cases

  subroutine functions_give_resistances()
    type(bempd_model) :: model
    real(dp), parameter :: energies(3) = [1.0_dp, 4.0_dp, -1.0_dp]
    real(dp) :: loads(3)
    real(c_double), target :: energy
    integer(c_int32_t) :: material
    integer :: k, stat
    character(200) :: message

    do k = 1, 3
      energy = energies(k)
      call model%create()
      call model%add_material(1.0_dp, .3_dp, material, fracture_energy=1.0_dp)
      call model%add_bem_region(material, reshape([-1, -1, 1, -1, 1, 1, -1, 1] * 1.0_dp, [2, 4]), .5_dp)
      call model%add_crack(reshape([-.3_dp, 0.0_dp, .3_dp, 0.0_dp], [2, 2]))
      call model%fix_edge(1, 1, BEMPD_BOTH)
      call model%prescribe_edge(1, 3, BEMPD_Y, proportional=[1.0_dp])
      call model%set_resistance_function(material, resistance, c_loc(energy))
      call model%step_to_next_event(1e9_dp, stat=stat, errmsg=message)
      call model%load_factor(loads(k))
      call model%free()
    end do
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_step_to_next_event: ")
    call check(abs(loads(2) / loads(1) - 2) < 1e-9_dp, "the load goes with the root of the fracture energy")
  end subroutine functions_give_resistances

  subroutine cracks_grow_where_they_are_not_frozen()
    type(bempd_model) :: model
    type(bempd_growth) :: growth
    type(bempd_crack_extension), allocatable :: found(:)
    type(bempd_path_vertex), allocatable :: path(:)
    real(dp) :: length
    integer(c_int64_t) :: cracks
    integer(c_int32_t) :: material, crack
    integer :: stat
    character(200) :: message

    call model%create()
    call model%add_material(1.0_dp, .3_dp, material, fracture_energy=1.0_dp)
    call model%add_bem_region(material, reshape([-1, -1, 1, -1, 1, 1, -1, 1] * 1.0_dp, [2, 4]), .5_dp)
    call model%add_crack(reshape([-.3_dp, 0.0_dp, .3_dp, 0.0_dp], [2, 2]), crack)
    call model%fix_point(-1.0_dp, -1.0_dp, BEMPD_BOTH)
    call model%fix_point(1.0_dp, -1.0_dp, BEMPD_Y)
    call model%add_crack_traction(crack, BEMPD_PRESSURE, proportional=[1.0_dp])
    call model%set_tip_frozen(crack, BEMPD_CRACK_START, .true.)
    call model%grow_cracks(.1_dp, growth)
    call model%extensions(found)
    call check(size(found) == 1 .and. growth%tips == 1, "one tip grows")
    call check(found(1)%end == BEMPD_CRACK_END .and. abs(found(1)%x - .4_dp) < 1e-6_dp, "it is the one that is not frozen")
    call check(abs(found(1)%energy_release_rate_before - 1) < 1e-9_dp, "it grows at its fracture energy")
    call check(abs(found(1)%length - growth%length) < 1e-12_dp, "the lengths are the same")
    call model%crack_count(cracks)
    call model%crack_length(crack, length)
    call model%crack_path(crack, path)
    call check(cracks == 1 .and. abs(length - .7_dp) < 1e-6_dp, "the crack is longer")
    call check(size(path) == 3 .and. path(3)%event == 1 .and. path(3)%end == BEMPD_CRACK_END, "its path tells who grew")
    call check(abs(path(3)%stress_intensity_1 - 1) < 1e-6_dp, "and by which stress intensity factor")
    call model%crack_path(2, path, stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_crack_path_count: ")
    call model%set_tip_frozen(2, BEMPD_CRACK_START, .true., stat, message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_set_tip_frozen: ")
  end subroutine cracks_grow_where_they_are_not_frozen

  subroutine pressure_and_moments_balance()
    type(bempd_model) :: model
    real(dp) :: force(2), moment

    call make_square(model)
    call model%add_pressure(1, 2, proportional=[-10._dp])
    call model%step(1._dp)
    call model%reaction(1, force)
    call check(abs(force(1) + 10) < 1e-9_dp, "a negative pressure pulls")
    call model%reaction_moment(1, 0._dp, 0._dp, moment)
    call check(abs(moment - 5) < 1e-9_dp, "the support's force acts at half height")
    call model%reaction_moment(1, 0._dp, .5_dp, moment)
    call check(abs(moment) < 1e-9_dp, "it has no moment about its middle")
  end subroutine pressure_and_moments_balance

  subroutine edges_sides_arcs_and_singular_places()
    type(bempd_model) :: model
    type(bempd_singularity), allocatable :: singular(:)
    real(dp), allocatable :: stress(:, :), errors_u(:), errors_s(:)
    real(dp) :: force(2), moment
    integer(c_int32_t) :: disc, spiral
    integer :: stat
    character(200) :: message

    call make_square(model)
    call model%add_traction(1, 2, BEMPD_X, constant=[0._dp], proportional=[10._dp])
    call model%add_bem_disc(1, .5_dp, 3._dp, .5_dp, .2_dp, region=disc)
    call model%set_edge_arc_about(disc, 1, .5_dp, 3._dp, .5_dp, BEMPD_COUNTER_CLOCKWISE)
    call model%set_edge_arc_about(disc, 1, .5_dp, 3._dp, .6_dp, BEMPD_CLOCKWISE, stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_set_edge_arc_about: edge 1 of region 2 begins 0.5")
    call model%fix_edge(disc, 1, BEMPD_BOTH)
    ! A spiral whose edges have chords that cross.
    call model%add_bem_region(1, reshape([6._dp, 0._dp, 8._dp, 0._dp, 6._dp, 1._dp, 8._dp, 1._dp], [2, 4]), .2_dp, &
      bulges=[0._dp, 1._dp, 0._dp], stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_add_bem_region: there are 3 bulges for 4 edges")
    call model%add_bem_region(1, reshape([6._dp, 0._dp, 8._dp, 0._dp, 6._dp, 1._dp, 8._dp, 1._dp], [2, 4]), .2_dp, &
      region=spiral, bulges=[0._dp, tan(3 * acos(-1._dp) / 8), 0._dp, 0._dp])
    call model%add_hole(spiral, reshape([6.8_dp, 1.6_dp, 7.1_dp, 2.2_dp, 7.4_dp, 1.6_dp], [2, 3]), &
      bulges=[0._dp, 0._dp, .2_dp])
    call model%fix_edge(spiral, 1, BEMPD_BOTH)
    call model%step(1._dp)
    call model%edge_reaction(1, 4, 0._dp, .5_dp, force, moment)
    call check(abs(force(1) + 10) < 1e-9_dp .and. abs(moment) < 1e-9_dp, "the edge holds the traction")
    call model%edge_reaction(1, 1, 0._dp, .5_dp, force, moment, stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_edge_reaction: no support holds edge 1")
    call model%evaluate_in(1, reshape([1._dp, .5_dp], [2, 1]), stress=stress)
    call check(abs(stress(1, 1) - 10) < 1e-7_dp, "the region has its stress on its boundary")
    call model%evaluate_errors(reshape([1._dp, .5_dp], [2, 1]), errors_u, errors_s)
    call check(errors_u(1) < 1e-6_dp .and. errors_s(1) < 1e-6_dp, "uniform stress has no error")
    call model%evaluate_in(disc, reshape([1._dp, .5_dp], [2, 1]), stress=stress, face=BEMPD_FACE_RIGHT, stat=stat, &
      errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_evaluate_in: point 1")
    call model%singularities(singular)
    call check(count(singular%region == disc .and. singular%kind == BEMPD_SINGULAR_CORNER) == 2, "a clamp has two ends")
    call check(all(singular%exponent < 1), "stress is unbounded there")
  end subroutine edges_sides_arcs_and_singular_places

  subroutine reactions_and_evaluation_agree_with_a_uniform_bar()
    type(bempd_model) :: model
    real(dp), allocatable :: displacement(:, :), stress(:, :)
    real(dp) :: force(2)
    integer(c_int32_t), allocatable :: regions(:)
    integer :: load

    call make_square(model)
    call model%add_traction(1, 2, BEMPD_X, constant=[0._dp], proportional=[10._dp], load=load)
    call model%step(1._dp)
    call model%reaction(1, force)
    call check(abs(force(1) + 10) < 1e-9_dp, "the support holds the traction")
    call model%evaluate(reshape([.5_dp, .5_dp, .25_dp, .75_dp], [2, 2]), displacement, stress, regions)
    call check(maxval(abs(displacement(1, :) - [.005_dp, .0025_dp])) < 1e-9_dp, "u = sigma x / E")
    call check(maxval(abs(stress(1, :) - 10)) < 1e-6_dp .and. all(regions == 1), "stress is the traction")
    call model%set_load_values(load, proportional=[20._dp])
    call model%step(1._dp)
    call model%reaction(1, force)
    call check(abs(force(1) + 20) < 1e-9_dp, "a load with new values acts from the next step on")
  end subroutine reactions_and_evaluation_agree_with_a_uniform_bar

  subroutine what_is_removed_leaves_no_trace()
    type(bempd_model) :: model
    real(c_double) :: force(2)
    integer :: region, crack, support, load, stat

    call make_square(model)
    call model%add_bem_region(1, reshape([5._dp, 0._dp, 6._dp, 0._dp, 6._dp, 1._dp, 5._dp, 1._dp], [2, 4]), .5_dp, &
      region=region)
    call model%fix_edge(region, 4, BEMPD_BOTH, support=support)
    call model%remove_region(region, stat)
    call check(stat == BEMPD_ERROR_ARGUMENT, "a region that bears a support stays")
    call model%remove_support(support)
    call model%add_crack(reshape([.5_dp, 0._dp, .5_dp, .5_dp], [2, 2]), crack=crack)
    call model%remove_crack(crack)
    call model%remove_region(region)
    call model%add_traction(1, 2, BEMPD_X, constant=[1e3_dp], load=load)
    call model%remove_load(load)
    call model%add_traction(1, 2, BEMPD_X, constant=[10._dp])
    call model%step(1._dp)
    call model%reaction(1, force)
    call check(abs(force(1) + 10) < 1e-9_dp, "only the last traction acts")
    call model%remove_load(load + 1, stat)
    call check(stat == BEMPD_ERROR_ORDER, "a prepared model keeps what it has")
  end subroutine what_is_removed_leaves_no_trace

  subroutine history_and_statistics_belong_together()
    type(bempd_model) :: model
    type(bempd_step_report) :: report
    type(bempd_history_entry), allocatable :: lines(:)
    type(bempd_statistics) :: statistics

    call make_strip(model)
    call model%run_to_separation(1e6_dp, report)
    call model%history(lines)
    call model%get_statistics(statistics)
    call check(report%stop_reason == BEMPD_STOP_SEPARATED, "the strip is in two")
    call check(maxval(lines%event) == report%total_events, "the history has every event")
    call check(statistics%broken_bonds == report%total_broken_bonds, "the statistics count the broken bonds")
    call check(lines(size(lines))%total_broken_bonds == report%total_broken_bonds, "and so does the last line")
  end subroutine history_and_statistics_belong_together

  subroutine the_path_of_equilibrium_costs_what_bonds_take()
    type(bempd_model) :: held, path
    type(bempd_step_report) :: at_load, on_path
    real(dp) :: lowest, highest

    call make_strip(held)
    call held%admissible_load_factors(lowest, highest)
    call check(lowest < 0 .and. highest > 0, "the body bears no load at all")
    call held%run_to_separation(1e6_dp, at_load)
    call make_strip(path)
    call path%set_option("stepping.control", "path")
    call path%run_to_separation(1e6_dp, on_path)
    call check(on_path%unstable_event == 0 .and. at_load%unstable_event > 0, "only a held load loses equilibrium")
    call check(abs(on_path%bond_energy / at_load%bond_energy - 1) < 1e-9_dp, "the new area takes the same on both ways")
  end subroutine the_path_of_equilibrium_costs_what_bonds_take

  subroutine models_are_freed_and_created_again()
    type(bempd_model) :: models(2)
    integer :: k, stat

    do k = 1, 2
      call make_strip(models(k))
    end do
    call make_strip(models(1))
    call models(2)%free()
    call models(2)%free()
    call models(2)%prepare(stat)
    call check(stat == BEMPD_ERROR_ARGUMENT, "a freed model is refused")
    call models(1)%prepare(stat)
    call check(stat == BEMPD_OK, "the other one lives")
  end subroutine models_are_freed_and_created_again
end program fortran_runs
