!> An error ends a program that does not ask for stat; the argument chooses the error.
program fortran_stop
  use fortran_checks
  implicit none
  type(bempd_model) :: model, other
  character(16) :: way

  call get_command_argument(1, way)
  call model%create()
  select case (way)
  case ("library")
    call model%set_option("no.such.option", 1._dp)
  case ("shape")
    call model%add_crack(reshape([0._dp, 0._dp, 1._dp], [3, 1]))
  case ("copy")
    other = model
  end select
  print '(a)', "went on"
end program fortran_stop
