"""Looks for a counterexample to each claim that a planted fault breaks: refute.py FAULTS PROVER FOLDER

Random and extreme numbers find most; Bitwuzla looks for the others. A claim after ~ must no longer be proved. Fails if a fault
breaks no claim, or a claim has no fault."""
import concurrent.futures
import os
import pathlib
import subprocess
import sys

from plant import rows
from solve import solve


def refuted(prover, folder, number, claim):
    """A counterexample to a claim with this fault, or nothing."""
    run = lambda *arguments: subprocess.run(
        [prover, *arguments], env={**os.environ, "PLANTED": str(number)}, capture_output=True, text=True
    ).stdout
    lines = run("prove", claim.lstrip("~")).splitlines()
    found = [line for line in lines if " refuted by " in line or claim[0] == "~" and " open: " in line]
    if found or claim[0] == "~":
        return "".join(found[:1])
    queries = folder / str(number) / claim
    run("queries", str(queries), claim)
    texts = [path.read_text() for path in sorted(queries.glob("*.F32.*"))]
    return "Bitwuzla finds one" if any(solve((text, 120))[0] == "sat" for text in texts) else ""


def main(faults, prover, folder):
    folder = pathlib.Path(folder)
    lines = subprocess.run([prover, "claims"], capture_output=True, text=True, check=True).stdout.splitlines()
    names = [line.split(":")[0] for line in lines]
    tasks = [(number, row, claim) for number, row in enumerate(rows(faults)) for claim in row[3].split()]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        results = list(pool.map(lambda task: refuted(prover, folder, task[0], task[2]), tasks))
    found = {claim.lstrip("~") for (_, _, claim), result in zip(tasks, results) if result}
    complaints = [f"{claim} stands in spite of {' ¦ '.join(row[:3])}" for (_, row, claim), result in zip(tasks, results) if not result]
    complaints += [f"{name} has no fault" for name in names if name not in found]
    unproved = sum(" open: " in result for result in results)
    summary = f"faults: {len(tasks)} break {len(found)} of {len(names)} claims, {unproved} of them without a counterexample"
    print("\n".join([*complaints, summary]))
    sys.exit(bool(complaints))


if __name__ == "__main__":
    main(*sys.argv[1:])
