#pragma once

// Prints how the networks of bodies along lattice rows differ from those that the builder for any outline makes of the
// same points without templates, as a table.
void print_rows();
