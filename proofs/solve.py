"""Gives the queries of claims to Bitwuzla: solve.py FOLDER ANSWERS SECONDS needed|repeat|search NAME…

FOLDER has the queries, NAME.FORMAT.NUMBER.smt2. A claim is proved in a format if no query of it has a solution. ANSWERS lists
what was proved: claim, format, a hash of its queries, how many there are, and the seconds of the slowest. A query gets so many
SECONDS at most.

needed: the claims with these names must be proved in both formats. Those that ANSWERS has with the same hash are not asked again.
repeat: what ANSWERS lists, and the claims with these names, must be proved anew.
search: the claims with these names, or all, are asked, and ANSWERS lists those that are proved. (pip install bitwuzla)"""
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
    rows = [line.split() for line in path.read_text().splitlines()] if path.exists() else []
    return {(row[0], row[1]): row for row in rows}


def queries(folder):
    """The queries of each claim and format."""
    claims = {}
    for path in sorted(pathlib.Path(folder).glob("*.smt2")):
        name, form, _ = path.name.split(".", 2)
        claims.setdefault((name, form), []).append(path.read_text())
    return claims


def main(folder, answers, limit, mode, *names):
    answers, claims = pathlib.Path(answers), queries(folder)
    known, wrong, count = read(answers), [], 0
    named = [key for key in claims if key[0] in names or not names and mode == "search"]
    missing = [name for name in names if not any(key[0] == name for key in claims)]
    assert not missing, f"no queries of {missing}"
    asked = sorted({*named, *(known if mode == "repeat" else [])}, key=lambda key: (len(claims.get(key, [])), key))
    with multiprocessing.Pool(2) as pool:
        for key in asked:
            texts = claims.get(key, [])
            digest = hashlib.sha256("".join(sorted(texts)).encode()).hexdigest()[:16]
            if mode != "repeat" and known.get(key, [""] * 3)[2] == digest:
                continue
            status, slowest = "proved" if texts else "without a query", 0.0
            results = pool.imap_unordered(solve, [(text, int(limit)) for text in texts])
            for result, seconds in results:
                slowest = max(slowest, seconds)
                if result != "unsat" and status == "proved":
                    status = {"sat": "refuted"}.get(result, "open")
            row = [*key, digest, str(len(texts)), f"{slowest:.0f}"]
            print(*row, status, flush=True)
            count += status == "proved"
            if status == "refuted" or status != "proved" and mode != "search":
                wrong.append(key)
            if mode == "search":
                known = {**known, key: row} if status == "proved" else {k: v for k, v in known.items() if k != key}
                answers.write_text("".join(" ".join(known[key]) + "\n" for key in sorted(known)))
    print(f"{count} proved by Bitwuzla, {len(asked) - count - len(wrong)} not asked again or open, {len(wrong)} wrong")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main(*sys.argv[1:])
