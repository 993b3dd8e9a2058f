"""Looks for a counterexample to each claim that a planted fault breaks: refute.py FAULTS PROVER FOLDER

Random and extreme numbers find most; Bitwuzla looks for the others. Fails if a fault refutes no claim, or a claim has no fault."""
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys

from plant import rows
from solve import solve


def refuted(prover, folder, number, claim):
    """A counterexample to a claim with this fault, or nothing."""
    run = lambda *arguments: subprocess.run(
        [prover, *arguments], env={**os.environ, "PLANTED": str(number)}, capture_output=True, text=True
    ).stdout
    found = [line for line in run("prove", claim).splitlines() if " refuted by " in line]
    if found:
        return found[0]
    queries = folder / str(number) / claim
    run("queries", str(queries), claim)
    texts = [path.read_text() for path in sorted(queries.glob("*.F32.*"))]
    return "Bitwuzla finds one" if any(solve((text, 20))[0] == "sat" for text in texts) else ""


def main(faults, prover, folder):
    folder = pathlib.Path(folder)
    table = subprocess.run([prover, "claims"], capture_output=True, text=True, check=True).stdout
    names = re.findall(r"^\| `(\w+)`", table, re.M)
    tasks = [(number, row, claim) for number, row in enumerate(rows(faults)) for claim in row[5].split()]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        results = list(pool.map(lambda task: refuted(prover, folder, task[0], task[2]), tasks))
    found = {claim for (_, _, claim), result in zip(tasks, results) if result}
    complaints = [f"{claim} stands in spite of {' '.join(row[:5])}" for (_, row, claim), result in zip(tasks, results) if not result]
    complaints += [f"{name} has no fault" for name in names if name not in found]
    print("\n".join(complaints + [f"faults: {len(tasks)} refute {len(found)} of {len(names)} claims, each with a counterexample"]))
    sys.exit(bool(complaints))


if __name__ == "__main__":
    main(*sys.argv[1:])
