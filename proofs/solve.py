"""Asks Bitwuzla about the queries of claims: solve.py FOLDER SECONDS

FOLDER has the queries, NAME.FORMAT.NUMBER.smt2. A claim is proved in a format if no query of it has a solution. A query gets so
many SECONDS at most. Fails unless each claim is proved in both formats. (pip install bitwuzla)"""
import collections
import importlib.metadata
import multiprocessing
import pathlib
import sys
import time

import bitwuzla


def solve(query):
    """Whether it has a solution, and in how many seconds that was decided."""
    text, limit = query
    start = time.time()
    options = bitwuzla.Options()
    options.set(bitwuzla.Option.TIME_LIMIT_PER, 1000 * limit)
    parser = bitwuzla.Parser(bitwuzla.TermManager(), options)
    parser.parse(text.replace("(check-sat)\n", ""), False, False)
    result = parser.bitwuzla().check_sat()
    return str(result).split(".")[-1].lower(), time.time() - start


def main(folder, limit):
    paths = sorted(pathlib.Path(folder).glob("*.smt2"))
    claims = [tuple(path.name.split(".")[:2]) for path in paths]
    missing = {(name, form) for name, _ in claims for form in ("F32", "F64")} - set(claims)
    wrong, seconds = [f"no query of {key}" for key in missing], collections.Counter()
    with multiprocessing.Pool(2) as pool:
        answers = pool.imap(solve, [(path.read_text(), int(limit)) for path in paths])
        for key, path, (result, taken) in zip(claims, paths, answers):
            seconds[key] += taken
            if result != "unsat":
                wrong.append(f"{path.name}: {'refuted' if result == 'sat' else 'open'}")
    slowest = ", ".join(f"{' '.join(key)} {taken:.1f} s" for key, taken in seconds.most_common(3))
    print("\n".join([*wrong, f"Bitwuzla {importlib.metadata.version('bitwuzla')}: {len(seconds)} claims by {len(paths)} queries; slowest {slowest}"]))
    sys.exit(bool(wrong) or not paths)


if __name__ == "__main__":
    main(*sys.argv[1:])
