"""What criteria for the break of a bond make of bodies that are pulled and pressed: the table of docs/materials.md.
Run it with benchmarks/run.sh compression."""

import os
import subprocess
from pathlib import Path

program = Path(os.environ["BEMPD_BENCHMARKS"]) / "bempd_compression"
table = subprocess.run([program], check=True, capture_output=True, text=True).stdout.strip()
print(table)
document = Path(__file__).resolve().parents[2] / "docs" / "materials.md"
begin, end = "<!-- compression -->", "<!-- end compression -->"
text = document.read_text()
document.write_text(text.split(begin)[0] + f"{begin}\n{table}\n{end}" + text.split(end)[1])
