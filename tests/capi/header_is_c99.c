/* The header is the first and only include: it must stand alone. */
#include <bempd.h>

int main(void) { return bempd_version_string()[0] != '\0' ? 0 : 1; }
