! A strip of acrylic glass, 60 x 20 mm, with a hole and an edge crack.
program first_crack
  use, intrinsic :: iso_fortran_env, only: dp => real64
  use bempd
  implicit none
  real(dp), parameter :: outline(2, 4) = reshape( &
    [0._dp, 0._dp, .06_dp, 0._dp, .06_dp, .02_dp, 0._dp, .02_dp], [2, 4])
  real(dp), parameter :: crack(2, 2) = reshape([.03_dp, 0._dp, .03_dp, .005_dp], [2, 2])
  real(dp), parameter :: pull = 1e-6_dp  ! m per unit of load factor
  type(bempd_model) :: model
  type(bempd_step_report) :: report
  integer :: glass, strip

  call model%create()
  call model%set_option("error.wanted", .01_dp)        ! the elements follow from it
  call model%add_material(3e9_dp, 1 / 3._dp, glass, thickness=.005_dp, &
    fracture_energy=300._dp)
  call model%add_body(glass, outline, strip)
  call model%add_circular_hole(strip, .034_dp, .013_dp, .003_dp)
  call model%add_crack(crack)
  call model%fix_edge(strip, 4, BEMPD_BOTH)            ! edge 4: the left end
  call model%prescribe_edge(strip, 2, BEMPD_X, proportional=[pull])  ! the right end

  ! An error of any call stops the program with its sentence.
  call model%run_to_separation(1e4_dp, report)
  print '("growth at ", f0.1, " micrometres, ", i0, " N")', report%load_factor, &
    nint(report%peak_resistance)
  call model%free()
end program first_crack
