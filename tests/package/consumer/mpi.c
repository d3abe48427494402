/* A host of libbempd_mpi with one rank, which nobody has to start by mpirun. */
#include <bempd_mpi.h>
#include <stdio.h>

int main(int count, char** words) {
  bempd_model* model = NULL;
  bempd_status status = bempd_model_create(&model);
  MPI_Init(&count, &words);
  if (status == BEMPD_OK) status = bempd_mpi_attach(model, MPI_COMM_SELF);
  if (status == BEMPD_OK) status = bempd_mpi_detach(model);
  if (status != BEMPD_OK) fprintf(stderr, "%s\n", bempd_mpi_last_error());
  bempd_model_free(model);
  MPI_Finalize();
  printf("bempd %s\n", bempd_version_string());
  return status == BEMPD_OK ? 0 : 1;
}
