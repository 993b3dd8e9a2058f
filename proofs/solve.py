"""Gives the queries of the claims to Bitwuzla: solve.py FOLDER ANSWERS [SECONDS [BUDGET [FIRST]]]

FOLDER has the queries, NAME.FORMAT.NUMBER.smt2. A claim is proved in a format if no query of it has a solution. ANSWERS
remembers, by the hash of all queries of a claim, what was proved; only the others are solved again, a query in at most SECONDS,
and none after BUDGET seconds, but for the claims and formats in the lines of FIRST, which come first. Prints what is open and what
is refuted. (pip install bitwuzla)"""
import hashlib
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


def read(path):
    """A line: claim, format, hash, queries, seconds of the slowest, what became of it."""
    rows = [line.split() for line in path.read_text().splitlines()] if path.exists() else []
    return {(row[0], row[1]): row for row in rows}


def remember(answers, rows):
    answers.write_text("".join(" ".join(rows[key]) + "\n" for key in sorted(rows)))


def main(folder, answers, limit="180", budget="inf", first=None):
    answers, start = pathlib.Path(answers), time.time()
    first = [tuple(line.split()) for line in pathlib.Path(first).read_text().splitlines()] if first else []
    claims = {}
    for path in sorted(pathlib.Path(folder).glob("*.smt2")):
        name, form, _ = path.name.split(".", 2)
        claims.setdefault((name, form), []).append(path.read_text())
    known, solved = read(answers), {}
    results = {key: known[key] for key in known if key not in claims}
    with multiprocessing.Pool() as pool:
        # the claims with the fewest queries first, so that an interrupted run has most to show
        for key, texts in sorted(claims.items(), key=lambda claim: (claim[0] not in first, len(claim[1]))):
            digest = hashlib.sha256("".join(sorted(texts)).encode()).hexdigest()[:16]
            if known.get(key, [""] * 3)[2] == digest:
                results[key] = known[key]
                continue
            if time.time() - start > float(budget) and key not in first:
                results[key] = [*key, digest, str(len(texts)), "0", "unasked"]
                continue
            status, slowest = "proved", 0.0
            for result, seconds in pool.imap_unordered(solve, [(text, int(limit)) for text in texts]):
                slowest = max(slowest, seconds)
                if result != "unsat":
                    status = {"sat": "refuted"}.get(result, "open")
                    if status == "refuted":
                        break
            results[key] = solved[key] = [*key, digest, str(len(texts)), f"{slowest:.0f}", status]
            print(*results[key], flush=True)
            remember(answers, {**known, **results})
    remember(answers, {key: row for key, row in results.items() if key in claims and row[5] != "unasked"})
    of = lambda status: sum(results[key][5] == status for key in claims)
    print(f"{of('proved')} proved by Bitwuzla, {of('open')} open, {of('unasked')} not asked, {of('refuted')} refuted; "
          f"{len(solved)} were solved in {time.time() - start:.0f} s")
    sys.exit(of("refuted") > 0)


if __name__ == "__main__":
    main(*sys.argv[1:])
