! A sheet of aluminium, 120 x 240 mm, with a crack of 8 mm under a spectrum of two blocks.
program smallest
  use, intrinsic :: iso_fortran_env, only: dp => real64
  use, intrinsic :: iso_c_binding, only: c_sizeof
  use bempd
  implicit none
  real(dp), parameter :: sheet(2, 4) = reshape( &
    [-.06_dp, -.12_dp, .06_dp, -.12_dp, .06_dp, .12_dp, -.06_dp, .12_dp], [2, 4])
  real(dp), parameter :: crack(2, 2) = reshape([-.004_dp, 0._dp, .004_dp, 0._dp], [2, 2])
  type(bempd_model) :: model
  type(bempd_growth_rate) :: rate
  type(bempd_fatigue_report) :: life
  real(dp) :: length
  integer :: aluminium, status

  call model%create()
  call model%add_material(72e9_dp, .33_dp, aluminium)
  call model%add_bem_region(aluminium, sheet, .03_dp)
  call model%add_crack(crack)
  call model%fix_point(-.06_dp, -.12_dp, BEMPD_BOTH)
  call model%fix_point(.06_dp, -.12_dp, BEMPD_Y)
  call model%add_traction(1, 3, BEMPD_Y, proportional=[80e6_dp])  ! 80 MPa at load factor 1
  call model%add_traction(1, 1, BEMPD_Y, proportional=[-80e6_dp])

  status = bempd_growth_rate_init(rate, c_sizeof(rate))  ! Paris and Walker, MPa m^(1/2) and m
  rate%coefficient = 2e-11_dp
  rate%exponent = 3
  rate%unit_intensity = 1e6_dp
  rate%walker = .6_dp
  rate%critical_intensity = 35
  call model%set_growth_rate(aluminium, rate)
  call model%grow_fatigue([1._dp, .7_dp], [.1_dp, .2_dp], [10._dp, 500._dp], report=life)
  call model%crack_length(1, length)
  print '("breaks after ", i0, " cycles, at a length of ", f0.1, " mm")', nint(life%cycles), 1e3_dp * length
  call model%free()
end program smallest
