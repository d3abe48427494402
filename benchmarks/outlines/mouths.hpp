#pragma once

// Prints how many long outlines with mouths of cracks have networks, as a table.
void print_mouths();
