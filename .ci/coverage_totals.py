"""Print the covered share of lines and of branches; exit with 1 if either is below 95 %."""

import json
import sys
from pathlib import Path

LEAST = 95.0

totals = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))["totals"]
lines = 100.0 * totals["covered_lines"] / totals["num_statements"]
branches = 100.0 * totals["covered_branches"] / totals["num_branches"]
print(f"covered: {lines:.1f} % of lines, {branches:.1f} % of branches")
sys.exit(min(lines, branches) < LEAST)
