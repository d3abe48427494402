program consumer
  use bempd
  implicit none
  type(bempd_model) :: model
  call model%create()
  print '(2a)', 'bempd ', bempd_version()
end program consumer
