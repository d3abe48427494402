/**
 * @file bempd_mpi.h
 * One large body on several processes: the sparse factor of a model by MUMPS over MPI, in the library libbempd_mpi.
 *
 * All of a model lives on rank 0 of a communicator: scene, operators, events and results. The other ranks hold shares
 * of the factor only, and help whenever rank 0 factorizes or solves.
 *
 *   rank 0                                  other ranks
 *   bempd_mpi_attach(model, comm)           bempd_mpi_serve(comm)
 *   bempd_step(model, ...) and the like       works for rank 0
 *   bempd_mpi_detach(model)                 returns
 *
 * The host initializes and finalizes MPI; this library never does, and never aborts the job. MUMPS may do so after an
 * error of its own. Messages go over a copy of the communicator. Attach, detach and every call on an attached model
 * come from the thread that MPI allows: with MPI_THREAD_FUNNELED the one that initialized it. One model at a time can
 * be attached to a communicator. With one rank there is nobody to serve: MPI_COMM_SELF does.
 *
 * Statuses are those of bempd.h; bempd_mpi_last_error() has the sentence. This is the only header that includes mpi.h.
 */
#ifndef BEMPD_MPI_H
#define BEMPD_MPI_H

#include <mpi.h>
#include <stdint.h>

#include "bempd.h"

#ifdef __cplusplus
extern "C" {
#endif

/** @brief Let MUMPS factorize the whole body of a model, on all ranks of a communicator. Call it on rank 0 before the
 * model's first step or result, while the other ranks call bempd_mpi_serve(). If it fails, they return as well.
 * @param[in] model the model @param[in] comm the communicator @return status @since 0.4 */
BEMPD_API bempd_status bempd_mpi_attach(bempd_model* model, MPI_Comm comm);

/** @brief Work for rank 0 until it detaches or frees its model.
 * @param[in] comm the communicator @return status @since 0.4 */
BEMPD_API bempd_status bempd_mpi_serve(MPI_Comm comm);

/** @brief Take MUMPS away from a model, on rank 0; the other ranks return from bempd_mpi_serve(). The model can go on:
 * its next factorization is the library's own. Freeing an attached model detaches it too.
 * @param[in] model the model @return status @since 0.4 */
BEMPD_API bempd_status bempd_mpi_detach(bempd_model* model);

/** @brief bempd_mpi_attach() for languages in which a communicator is an integer, as Fortran's.
 * @param[in] model the model @param[in] comm handle of Fortran @return status @since 0.4 */
BEMPD_API bempd_status bempd_mpi_attach_handle(bempd_model* model, int32_t comm);

/** @brief bempd_mpi_serve() for languages in which a communicator is an integer.
 * @param[in] comm handle of Fortran @return status @since 0.4 */
BEMPD_API bempd_status bempd_mpi_serve_handle(int32_t comm);

/** @brief Sentence about the last error of a function of this header in this thread. @return never NULL; empty after no
 * error; valid until the next call @since 0.4 */
BEMPD_API const char* bempd_mpi_last_error(void);

/** @brief Version and licence of the MUMPS in use. @return constant string @since 0.4 */
BEMPD_API const char* bempd_mpi_build_info(void);

#ifdef __cplusplus
}
#endif

#endif
