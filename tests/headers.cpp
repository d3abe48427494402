// Nothing of its own: its precompiled headers serve the tests.
