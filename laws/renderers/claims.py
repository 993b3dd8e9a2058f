"""Asks a renderer for the scenes that the pages work out by hand, and compares: claims.py RENDERER COMMAND..."""
import json
import math
import subprocess
import sys
from pathlib import Path

renderer, command = sys.argv[1], sys.argv[2:]
lines = [line.split(" ", 2) for line in (Path(__file__).parent / "claims.txt").read_text().splitlines()]
claims = [(color, scene) for name, color, scene in lines if name == renderer]
asked = ['{"shading-laws":1}', *(scene for _, scene in claims), "", ""]
answer = subprocess.run(command, input="\n".join(asked), capture_output=True, text=True).stdout.splitlines()[1:]
failed = len(answer) != len(claims)
for (expected, scene), color in zip(claims, answer):
    pairs = zip(json.loads(expected), json.loads(color))
    if not all(a == b or math.isclose(a, b, rel_tol=1e-5, abs_tol=1e-8) for a, b in pairs):
        print(f"{renderer}: {color}, not {expected}: {scene}", file=sys.stderr)
        failed = True
print(f"{renderer}: {len(claims)} scenes that are worked out by hand")
sys.exit(failed)
