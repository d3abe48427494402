!> New values of loads and supports, as a host that couples gives them.
program fortran_new_values
  use fortran_checks
  implicit none

  call steps_to_values_break_what_one_proportional_load_breaks()
  call a_way_stops_at_an_event_and_goes_on()
  call a_program_loads_unloads_and_goes_on()
  call a_pressure_follows_a_crack()
  call a_region_turns_about_an_axis()
  call finish_checks()

contains

  subroutine steps_to_values_break_what_one_proportional_load_breaks()
    type(bempd_model) :: expected, host
    type(bempd_step_report) :: proportional, values
    integer :: part

    call make_strip(expected)
    call expected%step(12._dp, proportional)
    call make_strip(host)
    do part = 1, 4
      call host%set_support_values(2, constant=[3e-3_dp * part])
      call host%step_to_values(3._dp * part, report=values)
    end do
    call check(proportional%events > 3 .and. values%total_events == proportional%total_events, "as many events")
    call check(values%total_broken_bonds == proportional%total_broken_bonds, "as many bonds")
    call check(abs(values%released_energy - proportional%released_energy) < 1e-9_dp * proportional%released_energy, &
      "the same energy")
  end subroutine steps_to_values_break_what_one_proportional_load_breaks

  subroutine a_way_stops_at_an_event_and_goes_on()
    type(bempd_model) :: host
    type(bempd_step_report) :: report
    character(200) :: message
    integer :: stat

    call make_strip(host)
    call host%set_support_values(2, constant=[12e-3_dp])
    call host%step_to_values(1._dp, BEMPD_UNTIL_EVENT, report)
    call check(report%stop_reason == BEMPD_STOP_EVENT .and. report%load_factor < 1, "it stops at an event")
    call host%step_to_values(1._dp, BEMPD_UNTIL_VALUES, report)
    call check(abs(report%load_factor - 1) <= 0 .and. report%total_events > 3, "and goes on")
    call host%step_to_values(1._dp, report=report, stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_step_to_values: ")
  end subroutine a_way_stops_at_an_event_and_goes_on

  subroutine a_program_loads_unloads_and_goes_on()
    type(bempd_model) :: expected, host
    type(bempd_step_report) :: one_way, report
    character(200) :: message
    integer :: stat
    real(dp), parameter :: times(3) = [1._dp, 2._dp, 3._dp]
    real(dp), parameter :: factors(1, 3) = reshape([6._dp, 0._dp, 12._dp], [1, 3])

    call make_strip(expected)
    call expected%step(12._dp, one_way)
    call make_strip(host)
    call host%run_program(times, factors, kinds=[BEMPD_COLUMN_SUPPORT], ids=[2], report=report)
    call check(report%events > 3 .and. report%broken_bonds == one_way%broken_bonds, "as many bonds")
    call check(abs(report%load_factor - 3) <= 0 .and. report%energy_balance_error < 1e-9_dp, "at the last time")
    call host%run_program(times, factors, stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "bempd_run_program: ")
    call host%run_program(times(:2), factors, stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "run_program: ")
  end subroutine a_program_loads_unloads_and_goes_on

  !> Cut in two, the upper part feels the pressure along its whole length.
  subroutine a_pressure_follows_a_crack()
    type(bempd_model) :: model
    integer :: material, region, crack, top
    real(dp) :: force(2)

    call model%create()
    call model%add_material(1000._dp, 1 / 3._dp, material)
    call model%add_pd_region(material, rectangle(0._dp, 0._dp, 8._dp, 10._dp), 1._dp, 3, region)
    call model%add_crack(reshape([0._dp, 5.5_dp, 8._dp, 5.5_dp], [2, 2]), crack)
    call model%add_crack_pressure(crack, proportional=2._dp)
    call model%fix_edge(region, 3, BEMPD_BOTH, top)
    call model%fix_edge(region, 1, BEMPD_BOTH)
    call model%step(1._dp)
    call model%reaction(top, force)
    call check(abs(force(2) + 16) < 1e-9_dp, "pressure times length")
  end subroutine a_pressure_follows_a_crack

  !> Held at its lower edge, by all that drives it away from the axis.
  subroutine a_region_turns_about_an_axis()
    type(bempd_model) :: model
    integer :: material, region, edge
    real(dp) :: force(2)

    call model%create()
    call model%add_material(1000._dp, 0.2_dp, material)
    call model%add_bem_region(material, rectangle(1._dp, 0._dp, 9._dp, 10._dp), 2._dp, region)
    call model%add_rotation(region, [1._dp, 0._dp], proportional=0.5_dp)
    call model%fix_edge(region, 1, BEMPD_BOTH, edge)
    call model%step(1._dp)
    call model%reaction(edge, force)
    call check(abs(force(1) + 160) < 1e-6_dp .and. abs(force(2) + 200) < 1e-6_dp, "reaction of a turning region")
  end subroutine a_region_turns_about_an_axis

end program fortran_new_values
