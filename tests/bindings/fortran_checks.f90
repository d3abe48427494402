!> Checks that go on after a failure and are counted, and the scene that the tests of the Fortran module share.
module fortran_checks
  use, intrinsic :: iso_fortran_env, only: dp => real64, error_unit, int64
  use bempd
  implicit none
  integer :: check_count = 0, check_failures = 0

contains

  subroutine check(good, what)
    logical, intent(in) :: good
    character(*), intent(in) :: what

    check_count = check_count + 1
    if (good) return
    check_failures = check_failures + 1
    write (error_unit, '(2a)') "failed: ", what
  end subroutine check

  !> Checks that a call failed in the way and with the words expected.
  subroutine check_error(stat, expected, message, words)
    integer, intent(in) :: stat, expected
    character(*), intent(in) :: message, words

    call check(stat == expected, words // ": status " // bempd_status_word(stat))
    call check(index(message, words) > 0, "'" // trim(message) // "' has the words '" // words // "'")
  end subroutine check_error

  logical function same_bits(one, other)
    real(dp), intent(in) :: one(:, :), other(:, :)

    same_bits = all(shape(one) == shape(other))
    if (same_bits) same_bits = all(transfer(one, [0_int64]) == transfer(other, [0_int64]))
  end function same_bits

  function rectangle(left, bottom, right, top) result(vertices)
    real(dp), intent(in) :: left, bottom, right, top
    real(dp) :: vertices(2, 4)

    vertices = reshape([left, bottom, right, bottom, right, top, left, top], [2, 4])
  end function rectangle

  !> A strip 6 x 2 with a lattice between two boundary element regions and an edge crack, pulled at its right end.
  subroutine make_strip(model)
    type(bempd_model), intent(inout) :: model
    integer :: material

    call model%create()
    call model%add_material(1000._dp, 1 / 3._dp, material, critical_stretch=1e-3_dp)
    call model%add_bem_region(material, rectangle(0._dp, 0._dp, 2._dp, 2._dp), 1._dp)
    call model%add_pd_region(material, rectangle(2._dp, 0._dp, 4._dp, 2._dp), .2_dp, 3)
    call model%add_bem_region(material, rectangle(4._dp, 0._dp, 6._dp, 2._dp), 1._dp)
    call model%add_crack(reshape([2.9_dp, 0._dp, 2.9_dp, .5_dp], [2, 2]))
    call model%fix_edge(1, 4, BEMPD_BOTH)
    call model%prescribe_edge(3, 2, BEMPD_X, proportional=[1e-3_dp])
  end subroutine make_strip

  subroutine finish_checks()
    print '(i0, " checks, ", i0, " failed")', check_count, check_failures
    if (check_failures > 0 .or. check_count == 0) error stop 1
  end subroutine finish_checks
end module fortran_checks
