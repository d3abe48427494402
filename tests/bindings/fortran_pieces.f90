!> What a torn body consists of.
program fortran_pieces
  use fortran_checks
  use, intrinsic :: iso_c_binding, only: c_int32_t, c_int64_t
  implicit none

  call a_torn_strip_is_in_pieces()
  call a_loose_piece_moves_as_its_edge_does()
  call finish_checks()

contains

  subroutine a_torn_strip_is_in_pieces()
    type(bempd_model) :: model
    type(bempd_step_report) :: report
    integer(c_int64_t) :: count
    integer(c_int32_t), allocatable :: pieces(:)
    integer(c_int32_t) :: left, right
    logical :: connected

    call make_strip(model)
    call model%are_connected(1, 2, connected)
    call model%piece_count(count)
    call check(connected .and. count == 1, "it is one at first")
    call model%run_to_separation(1e6_dp, report)
    call model%are_connected(1, 2, connected)
    call check(report%separated == 1 .and. (report%hanging == 1 .eqv. connected), "it tears")
    call check(report%resistance < .02_dp * report%peak_resistance, "next to nothing is borne")
    call model%support_piece(1, left)
    call model%support_piece(2, right)
    call check((left == right .eqv. connected) .and. min(left, right) == 1, "pieces have numbers")
    call model%node_pieces(1, pieces)
    call check(size(pieces) > 0 .and. all(pieces == left), "a boundary element region is one piece")
  end subroutine a_torn_strip_is_in_pieces

  subroutine a_loose_piece_moves_as_its_edge_does()
    type(bempd_model) :: model
    type(bempd_piece) :: piece
    character(200) :: message
    integer(c_int32_t) :: number
    integer :: material, stat

    call model%create()
    call model%add_material(1000._dp, 1 / 3._dp, material, critical_stretch=1e-3_dp)
    call model%add_pd_region(material, rectangle(0._dp, 0._dp, 8._dp, 4._dp), 1._dp, 2)
    call model%add_crack(reshape([4.5_dp, 0._dp, 4.5_dp, 4._dp], [2, 2]))
    call model%fix_edge(1, 4, BEMPD_BOTH)
    call model%prescribe_edge(1, 2, BEMPD_X, constant=[.01_dp, .05_dp])
    call model%add_traction(1, 1, BEMPD_Y, constant=[0._dp])
    call model%load_piece(1, number)
    call check(number == 0, "the bottom belongs to both")
    call model%piece(2, piece)
    call check(piece%nodes == 20 .and. piece%supports == 1 .and. piece%loads == 1, "a piece knows what is on it")
    call check(abs(piece%rotation + .01_dp) < 1e-12_dp .and. piece%deviation < 1e-12_dp, "and how it moves")
    call model%piece(3, piece, stat, message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "piece 3")
  end subroutine a_loose_piece_moves_as_its_edge_does

end program fortran_pieces
