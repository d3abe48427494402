"""python_prints_the_same.py PROGRAM SCRIPT: a program and its Python version print the same."""

import subprocess
import sys

program, script = sys.argv[1:]
expected, found = (subprocess.run(command, check=True, capture_output=True, text=True).stdout
                   for command in ([program], [sys.executable, script]))
print(expected + found, end="")
sys.exit(0 if expected and found == expected else "they differ")
