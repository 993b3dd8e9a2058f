"""Proves the claims of harness.rs: that each returns true for every input, and that nothing in it panics.

The claims are translated from LLVM's code, as rustc writes it, to formulas over bit-vectors, which Bitwuzla decides. A
call of a function is put in its place; a loop must have been unrolled; an overflow is a call of a function that panics.

    prove.py HARNESS.ll [CLAIM]…
"""

import re
import sys
import time

from bitwuzla import Bitwuzla, Kind, Options, Result, TermManager

tm = TermManager()
BINARY = {
    "add": Kind.BV_ADD, "sub": Kind.BV_SUB, "mul": Kind.BV_MUL, "and": Kind.BV_AND, "or": Kind.BV_OR, "xor": Kind.BV_XOR,
    "shl": Kind.BV_SHL, "lshr": Kind.BV_SHR, "ashr": Kind.BV_ASHR, "udiv": Kind.BV_UDIV, "urem": Kind.BV_UREM,
}
COMPARISONS = {
    "eq": Kind.EQUAL, "ne": Kind.DISTINCT, "ult": Kind.BV_ULT, "ule": Kind.BV_ULE, "ugt": Kind.BV_UGT,
    "uge": Kind.BV_UGE, "slt": Kind.BV_SLT, "sle": Kind.BV_SLE, "sgt": Kind.BV_SGT, "sge": Kind.BV_SGE,
}
EXTREMES = {"smin": Kind.BV_SLT, "smax": Kind.BV_SGT, "umin": Kind.BV_ULT, "umax": Kind.BV_UGT}
OVERFLOWS = {
    "sadd": (Kind.BV_ADD, Kind.BV_SADD_OVERFLOW), "uadd": (Kind.BV_ADD, Kind.BV_UADD_OVERFLOW),
    "ssub": (Kind.BV_SUB, Kind.BV_SSUB_OVERFLOW), "usub": (Kind.BV_SUB, Kind.BV_USUB_OVERFLOW),
    "smul": (Kind.BV_MUL, Kind.BV_SMUL_OVERFLOW), "umul": (Kind.BV_MUL, Kind.BV_UMUL_OVERFLOW),
}
# what LLVM adds to an operation; none changes its value, if LLVM is right
FLAGS = r"\b(nuw|nsw|nneg|exact|disjoint|samesign|noundef|zeroext|signext|inreg|tail|fastcc|range\(i\d+ -?\d+, -?\d+\)) "


def unflagged(line):
    return re.sub(FLAGS, "", line)


def bits(width, value):
    return tm.mk_bv_value(tm.mk_bv_sort(width), value % 2**width)


def true(boolean):
    return tm.mk_term(Kind.ITE, [boolean, bits(1, 1), bits(1, 0)])


def is_true(bit):
    return tm.mk_term(Kind.EQUAL, [bit, bits(1, 1)])


def functions(text):
    """Name → (parameters, blocks), where blocks are (label, lines)."""
    found = {}
    for head, body in re.findall(r"^define (.*?) \{\n(.*?)^\}", text, re.M | re.S):
        head = unflagged(head)
        name, parameters = re.search(r"@([\w.$]+)\((.*?)\)(?: unnamed_addr| local_unnamed_addr| #|$)", head).groups()
        parameters = re.findall(r"i(\d+)[^,%]*(%[\w.]+)", parameters)
        blocks = []
        for line in body.splitlines():
            line = unflagged(line.split(" ;")[0].split(", !")[0]).strip()
            label = re.match(r"([\w.]+):", line)
            if label:
                blocks.append((label[1], []))
            elif line and not line.startswith(";"):
                blocks[-1][1].append(line)
        found[name] = (parameters, blocks)
    return found


class Call:
    """A call of a function: the value it returns, and when it panics."""

    def __init__(self, program, name, arguments, reached):
        self.program, self.panics, self.returned = program, [], None
        parameters, blocks = program[name]
        self.values = {name: value for (_, name), value in zip(parameters, arguments)}
        self.edges = {}  # (from, to) → when
        for label, lines in blocks:
            into = [when for (_, to), when in self.edges.items() if to == label]
            self.when = reached if not self.edges else any_of(into)
            self.label = label
            for line in lines:
                self.step(line)

    def value(self, text, width):
        text = text.strip()
        if text.startswith("%"):
            return self.values[text]
        return bits(int(width), {"true": 1, "false": 0}.get(text) if text in ("true", "false") else int(text))

    def edge(self, to, when):
        self.edges[self.label, to] = tm.mk_term(Kind.AND, [self.when, when])

    def step(self, line):
        if line.startswith("br label"):
            self.edge(line.split("%")[1], tm.mk_true())
        elif line.startswith("br i1"):
            test, then, otherwise = re.fullmatch(r"br i1 (\S+), label %([\w.]+), label %([\w.]+)", line).groups()
            test = is_true(self.value(test, 1))
            self.edge(then, test)
            self.edge(otherwise, tm.mk_term(Kind.NOT, [test]))
        elif line.startswith("ret"):
            _, width, value = re.split(r"\s+i?", line, maxsplit=2)
            value = self.value(value, width)
            self.returned = value if self.returned is None else tm.mk_term(Kind.ITE, [self.when, value, self.returned])
        elif line == "unreachable":
            self.panics.append(self.when)
        elif "panicking" in line:
            pass  # what follows is unreachable
        else:
            name, operation = line.split(" = ", 1)
            self.values[name] = self.operation(operation)

    def operation(self, text):
        word = text.split()[0]
        if word in BINARY:
            width, a, b = re.fullmatch(r"\w+ i(\d+) (\S+), (\S+)", text).groups()
            return tm.mk_term(BINARY[word], [self.value(a, width), self.value(b, width)])
        if word == "icmp":
            test, width, a, b = re.fullmatch(r"icmp (\w+) i(\d+) (\S+), (\S+)", text).groups()
            return true(tm.mk_term(COMPARISONS[test], [self.value(a, width), self.value(b, width)]))
        if word == "select":
            test, width, a, b = re.fullmatch(r"select i1 (\S+), i(\d+) (\S+), i\d+ (\S+)", text).groups()
            return tm.mk_term(Kind.ITE, [is_true(self.value(test, 1)), self.value(a, width), self.value(b, width)])
        if word in ("zext", "sext", "trunc"):
            width, a, to = re.fullmatch(r"\w+ i(\d+) (\S+) to i(\d+)", text).groups()
            a, more = self.value(a, width), int(to) - int(width)
            if word == "trunc":
                return tm.mk_term(Kind.BV_EXTRACT, [a], [int(to) - 1, 0])
            return tm.mk_term(Kind.BV_ZERO_EXTEND if word == "zext" else Kind.BV_SIGN_EXTEND, [a], [more])
        if word == "phi":
            width, ways = re.fullmatch(r"phi i(\d+) (.*)", text).groups()
            ways = [way for way in re.findall(r"\[ (\S+), %([\w.]+) \]", ways) if (way[1], self.label) in self.edges]
            chosen = self.value(ways[0][0], width)
            for value, label in ways[1:]:
                chosen = tm.mk_term(Kind.ITE, [self.edges[label, self.label], self.value(value, width), chosen])
            return chosen
        if word == "extractvalue":
            pair, index = re.fullmatch(r"extractvalue \{.*?\} (\S+), (\d)", text).groups()
            return self.values[pair][int(index)]
        if word == "freeze":
            return self.value(*reversed(re.fullmatch(r"freeze i(\d+) (\S+)", text).groups()))
        if word == "call":
            called, arguments = re.search(r"@([\w.$]+)\((.*)\)", text).groups()
            arguments = [self.value(a, width) for width, a in re.findall(r"i(\d+) ([^,]+)", arguments)]
            return self.call(called, arguments)
        raise NotImplementedError(text)

    def call(self, called, arguments):
        if not called.startswith("llvm."):
            call = Call(self.program, called, arguments, self.when)
            self.panics += call.panics
            return call.returned
        name, *rest = called.split(".")[1:]
        if name in EXTREMES:
            return tm.mk_term(Kind.ITE, [tm.mk_term(EXTREMES[name], arguments), *arguments])
        if rest[:2] == ["with", "overflow"]:
            operation, overflow = OVERFLOWS[name]
            return [tm.mk_term(operation, arguments), true(tm.mk_term(overflow, arguments))]
        if name == "abs":
            zero = bits(arguments[0].sort().bv_size(), 0)
            return tm.mk_term(Kind.ITE, [tm.mk_term(Kind.BV_SLT, [arguments[0], zero]), tm.mk_term(Kind.BV_NEG, [arguments[0]]), arguments[0]])
        raise NotImplementedError(called)


def any_of(terms):
    return terms[0] if len(terms) == 1 else tm.mk_term(Kind.OR, terms) if terms else tm.mk_false()


def main(path, *names):
    text = open(path).read()
    program = functions(text)
    is_proved = True
    # two functions with one code are one, with an alias
    aliases = dict(re.findall(r"^@(claim_\w+) = .*alias .* @(\w+)$", text, re.M))
    for claim in sorted([*(name for name in program if name.startswith("claim_")), *aliases]):
        if names and claim not in names:
            continue
        start = time.time()
        function = aliases.get(claim, claim)
        inputs = [tm.mk_const(tm.mk_bv_sort(int(width)), name) for width, name in program[function][0]]
        call = Call(program, function, inputs, tm.mk_true())
        options = Options()
        solver = Bitwuzla(tm, options)
        solver.assert_formula(any_of([*call.panics, tm.mk_term(Kind.NOT, [is_true(call.returned)])]))
        result = solver.check_sat()
        verdict = {Result.UNSAT: "proved", Result.SAT: "refuted"}.get(result, "open")
        is_proved &= verdict == "proved"
        print(f"{claim}: {verdict} in {time.time() - start:.1f} s", flush=True)
    return is_proved


if __name__ == "__main__":
    sys.exit(not main(*sys.argv[1:]))
