"""Looks for a counterexample to each claim that a planted fault breaks: refute.py FAULTS PROVER FOLDER

Random and extreme numbers find most; Bitwuzla looks for the others. Fails if a fault refutes no claim, or a claim has no fault."""
import os
import pathlib
import subprocess
import sys

from plant import rows
from solve import solve


def main(faults, prover, folder):
    folder = pathlib.Path(folder)
    names = subprocess.run([prover, "names"], capture_output=True, text=True, check=True).stdout.split()
    refuted, standing = {}, []
    for number, (_, where, new, claims) in enumerate(rows(faults)):
        for claim in claims.split():
            run = lambda *arguments: subprocess.run(
                [prover, *arguments], env={**os.environ, "PLANTED": str(number)}, capture_output=True, text=True
            ).stdout
            found = [line for line in run("prove", claim).splitlines() if " refuted by " in line]
            if not found:
                queries = folder / str(number) / claim
                run("queries", str(queries), claim)
                texts = [path.read_text() for path in sorted(queries.glob("*.F32.*"))]
                found = ["Bitwuzla finds one"] if any(solve((text, 60))[0] == "sat" for text in texts) else []
            if found:
                refuted[claim] = found[0]
            else:
                standing.append(f"{claim} stands in spite of {new} instead of {where}")
    for complaint in [*standing, *(f"{name} has no fault" for name in names if name not in refuted)]:
        print(complaint)
    print(f"faults: {len(refuted)} of {len(names)} claims refuted, each with a counterexample")
    sys.exit(len(refuted) < len(names) or bool(standing))


if __name__ == "__main__":
    main(*sys.argv[1:])
