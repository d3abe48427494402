!> New values of loads and supports, as a host that couples gives them.
program fortran_new_values
  use fortran_checks
  implicit none

  call steps_to_values_break_what_one_proportional_load_breaks()
  call a_way_stops_at_an_event_and_goes_on()
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

end program fortran_new_values
