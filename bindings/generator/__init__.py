"""Reads include/bempd.h and writes the raw layer of each binding; see bindings/generate.py."""
