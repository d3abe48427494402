#include <bempd.h>
#include <stdio.h>

int main(void) {
  printf("bempd %s\n", bempd_version_string());
  return 0;
}
