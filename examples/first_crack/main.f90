! A strip of acrylic glass, 60 x 20 mm: boundary elements, a lattice around the crack,
! boundary elements.
program first_crack
  use, intrinsic :: iso_fortran_env, only: dp => real64
  use bempd
  implicit none
  real(dp), parameter :: left(2, 4) = reshape( &
    [0._dp, 0._dp, .02_dp, 0._dp, .02_dp, .02_dp, 0._dp, .02_dp], [2, 4])
  real(dp), parameter :: middle(2, 4) = reshape( &
    [.02_dp, 0._dp, .04_dp, 0._dp, .04_dp, .02_dp, .02_dp, .02_dp], [2, 4])
  real(dp), parameter :: right(2, 4) = reshape( &
    [.04_dp, 0._dp, .06_dp, 0._dp, .06_dp, .02_dp, .04_dp, .02_dp], [2, 4])
  real(dp), parameter :: crack(2, 2) = reshape( &
    [.0295_dp, 0._dp, .0295_dp, .0045_dp], [2, 2])
  real(dp), parameter :: pull = 1e-6_dp  ! m per unit of load factor
  type(bempd_model) :: model
  type(bempd_step_report) :: report
  integer :: glass

  call model%create()
  call model%add_material(3e9_dp, 1 / 3._dp, glass, thickness=.005_dp, &
    fracture_energy=300._dp)
  call model%add_bem_region(glass, left, .005_dp)      ! region 1, elements of 5 mm
  call model%add_pd_region(glass, middle, .001_dp, 4)  ! region 2, spacing 1 mm
  call model%add_bem_region(glass, right, .005_dp)     ! region 3
  call model%add_crack(crack)
  call model%fix_edge(1, 4, BEMPD_BOTH)                ! edge 4: the left end
  call model%prescribe_edge(3, 2, BEMPD_X, proportional=[pull])  ! the right end moves

  ! An error of any call stops the program with its sentence.
  call model%run_to_separation(1e4_dp, report)
  print '("in two at ", f0.2, " micrometres: ", i0, " bonds in ", i0, " events, ", &
    &f6.4, " J released")', report%load_factor, report%total_broken_bonds, &
    report%total_events, report%released_energy
  call model%free()
end program first_crack
