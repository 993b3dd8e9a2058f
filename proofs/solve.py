"""Gives scripts in SMT-LIB 2 to Bitwuzla: python solve.py SECONDS FOLDER

A claim is proved if no script of it has a solution. Prints how many are, and each that is not. (pip install bitwuzla)"""
import multiprocessing
import pathlib
import sys

import bitwuzla


def solve(path):
    options = bitwuzla.Options()
    options.set(bitwuzla.Option.TIME_LIMIT_PER, 1000 * int(sys.argv[1]))
    parser = bitwuzla.Parser(bitwuzla.TermManager(), options)
    parser.parse(path.read_text().replace("(check-sat)\n", ""), False, False)
    return parser.bitwuzla().check_sat()


def main():
    scripts = sorted(pathlib.Path(sys.argv[2]).glob("*.smt2"))
    claims = {}
    with multiprocessing.Pool() as pool:
        for path, result in zip(scripts, pool.map(solve, scripts)):
            claim = ".".join(path.name.split(".")[:2])
            proved = result == bitwuzla.Result.UNSAT
            claims[claim] = claims.get(claim, True) and proved
            if not proved:
                print(f"{path}: {result}")
    proved = sum(claims.values())
    print(f"{proved} by Bitwuzla, {len(claims) - proved} open")
    sys.exit(proved != len(claims))


if __name__ == "__main__":
    main()
