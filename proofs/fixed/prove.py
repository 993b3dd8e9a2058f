"""Proves the claims of harness.rs: that each returns true for every input, and that nothing in it panics.

The claims are translated from LLVM's code, as rustc writes it, to formulas over bit-vectors, which Bitwuzla decides. A
call of a function is put in its place; a loop that is not unrolled needs an invariant, which must be true when it begins and
stay true; an overflow is a call of a function that panics.

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
ATTRIBUTES = r"noalias|nonnull|readonly|writeonly|writable|dead_on_unwind|noundef|zeroext|signext|align \d+"
OF_POINTERS = r"captures\([\w, ]+\)|dereferenceable\(\d+\)|sret\(\[\d+ x i8\]\)"
FLAGS = rf"\b({ATTRIBUTES}|{OF_POINTERS}|nuw|nsw|nneg|exact|disjoint|samesign|inreg|tail|fastcc|range\(i\d+ -?\d+, -?\d+\)) "


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
        named = re.search(r"@([\w.$]+)\((.*?)\)(?: unnamed_addr| local_unnamed_addr| #|$)", head)
        if not named:
            continue  # of the standard library, and inlined
        name, parameters = named.groups()
        parameters = re.findall(r"(?:^|, )(?:i(\d+)|ptr)[^%]*?(%[\w.]+)", parameters)
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


def targets(lines):
    return re.findall(r"label %([\w.]+)", lines[-1])


def in_order(blocks):
    """The labels of blocks, each after what leads to it, but for the ends of loops."""
    order, seen = [], set()

    def visit(label):
        seen.add(label)
        for to in targets(blocks[label]):
            if to not in seen:
                visit(to)
        order.append(label)

    visit(next(iter(blocks)))
    return order[::-1]


class Run:
    """What is found on the way through a claim: what must not be, and what is assumed. Pointers are a name and an offset."""

    def __init__(self, program, factor=None, is_abstract=False):
        self.program, self.wrong, self.assumed, self.memory, self.long = program, [], [], {}, {}
        self.is_abstract = is_abstract
        long = tm.mk_bv_sort(64)
        self.product = tm.mk_const(tm.mk_fun_sort([long, long], long), "product")
        self.root = tm.mk_const(tm.mk_fun_sort([tm.mk_bv_sort(32)], tm.mk_bv_sort(32)), "reciprocal_root")
        self.products = Products(factor, self.assumed) if factor is not None else None


class Products:
    """The products with one factor, as a function of which is known what follows from the distributive law."""

    def __init__(self, factor, assumed):
        self.factor, self.assumed, self.known = factor, assumed, []
        self.function = tm.mk_const(tm.mk_fun_sort([tm.mk_bv_sort(32)], tm.mk_bv_sort(64)), "product")

    def of(self, number):
        product = tm.mk_term(Kind.APPLY, [self.function, number])
        if number not in self.known:
            self.known.append(number)
            for other in self.known:
                self.relate(number, other)
                self.relate(other, number)
        return product

    def relate(self, a, b):
        """What is known of two numbers, which are below 2³², and their products with one of at most 2³¹."""
        [of_a, of_b] = [tm.mk_term(Kind.APPLY, [self.function, x]) for x in (a, b)]
        factor = longer(self.factor, 32)
        [a, b] = [longer(x, 32) for x in (a, b)]
        twice, of_twice = [tm.mk_term(Kind.BV_ADD, [x, x]) for x in (b, of_b)]
        one = bits(64, 1)
        self.assumed += [
            implies(equal(a, twice), equal(of_a, of_twice)),
            implies(equal(a, plus(twice, one)), equal(of_a, plus(of_twice, factor))),
            implies(equal(a, plus(b, one)), equal(of_a, plus(of_b, factor))),
            implies(tm.mk_term(Kind.BV_ULE, [a, b]), tm.mk_term(Kind.BV_ULE, [of_a, of_b])),
            implies(equal(a, bits(64, 0)), equal(of_a, bits(64, 0))),
            tm.mk_term(Kind.BV_ULT, [of_a, bits(64, 2**63)]),
        ]


def longer(number, by):
    return tm.mk_term(Kind.BV_ZERO_EXTEND, [number], [by])


def plus(a, b):
    return tm.mk_term(Kind.BV_ADD, [a, b])


def equal(a, b):
    return tm.mk_term(Kind.EQUAL, [a, b])


def implies(a, b):
    return tm.mk_term(Kind.IMPLIES, [a, b])


def negated(boolean):
    return tm.mk_term(Kind.NOT, [boolean])


def all_of(*terms):
    return tm.mk_term(Kind.AND, list(terms))


def is_extended(number):
    """Whether it is one of 32 bits, with its sign."""
    return number.kind() == Kind.BV_SIGN_EXTEND and number.children()[0].sort().bv_size() <= 32


def zeros_above(number):
    """How many zeros are above the highest bit."""
    width = number.sort().bv_size()
    count = bits(width, width)
    for place in range(width):
        is_set = is_true(tm.mk_term(Kind.BV_EXTRACT, [number], [place, place]))
        count = tm.mk_term(Kind.ITE, [is_set, bits(width, width - 1 - place), count])
    return count


def is_large(number, digits):
    """Whether it is 2^digits or more, or −2^digits or less."""
    limits = [(Kind.BV_SGE, 2**digits), (Kind.BV_SLE, -(2**digits))]
    return any_of([tm.mk_term(kind, [number, bits(64, limit)]) for kind, limit in limits])


def choice(when, value, otherwise):
    if isinstance(value, list):
        return [choice(when, *pair) for pair in zip(value, otherwise)]
    return tm.mk_term(Kind.ITE, [when, value, otherwise])


def is_below(number, digits):
    return tm.mk_term(Kind.BV_ULT, [number, bits(64, 2**digits)])


def magnitude(number):
    is_negative = tm.mk_term(Kind.BV_SLT, [number, bits(number.sort().bv_size(), 0)])
    return tm.mk_term(Kind.ITE, [is_negative, tm.mk_term(Kind.BV_NEG, [number]), number])


def digits_of_quotient(run, arguments, values):
    """The dividend without its last `count` digits is the quotient so far times the divisor, and the rest. If the divisor is 0,
    each digit is 1."""
    dividend, divisor = [magnitude(arguments[name]) for name in ("%dividend", "%divisor")]
    count, quotient, rest = [values[name] for name in ("count", "quotient", "rest")]
    done = tm.mk_term(Kind.BV_SUB, [bits(32, 48), count])
    steps = tm.mk_term(Kind.BV_SHL, [longer(dividend, 32), bits(64, 16)])
    so_far = tm.mk_term(Kind.BV_SHR, [steps, longer(count, 32)])
    ones = tm.mk_term(Kind.BV_SHR, [bits(32, -1), tm.mk_term(Kind.BV_SUB, [count, bits(32, 16)])])
    is_zero = equal(divisor, bits(32, 0))
    # the digits that are left, which are 0 if the first 32 are divided at once
    left = values.get("bits", values.get("dividend"))
    most = 16 if left is None else 48
    return all_of(
        tm.mk_term(Kind.BV_UGE, [count, bits(32, 1)]),
        tm.mk_term(Kind.BV_ULE, [count, bits(32, most)]),
        tm.mk_true() if left is None else equal(left, tm.mk_term(Kind.BV_SHL, [dividend, done])),
        implies(is_zero, all_of(tm.mk_term(Kind.BV_UGE, [count, bits(32, 16)]), equal(quotient, ones))),
        tm.mk_term(Kind.OR, [is_zero, all_of(
            tm.mk_term(Kind.BV_ULT, [rest, divisor]),
            equal(so_far, plus(run.products.of(quotient), longer(rest, 32))),
        )]),
    )


def bits_of_denominator(run, arguments, values):
    """Three words are shifted up by what is taken from the shift, and no bit of them is lost."""
    before, now = [tm.mk_term(Kind.BV_CONCAT, words) for words in (
        [arguments[name] for name in ("%0", "%1", "%2")], [values[name] for name in ("high", "middle", "low")])]
    shift = values["shift"]
    by = longer(tm.mk_term(Kind.BV_SUB, [arguments["%3"], shift]), 64)
    return all_of(
        tm.mk_term(Kind.BV_SLE, [shift, arguments["%3"]]),
        tm.mk_term(Kind.BV_SGT, [shift, bits(32, -64)]),
        tm.mk_term(Kind.BV_SGE, [values["high"], bits(32, 0)]),
        equal(now, tm.mk_term(Kind.BV_SHL, [before, by])),
        equal(before, tm.mk_term(Kind.BV_SHR, [now, by])),
    )


# the claims for which long products need not be multiplied out
ABSTRACT = ["claim_arrives", "claim_direction", "claim_dot_of_long", "claim_length", "claim_product"]
# what stays true in a loop, by the function that it is in
INVARIANTS = {"8quotient": digits_of_quotient, "6beyond": bits_of_denominator}


class Call:
    """A call of a function: the value it returns, and what is wrong on the way."""

    def __init__(self, run, name, arguments, reached):
        self.run, self.name, self.returned, self.ends = run, name, None, []
        parameters, blocks = run.program[name]
        self.arguments = {name: value for (_, name), value in zip(parameters, arguments)}
        self.values = dict(self.arguments)
        self.edges = {}  # (from, to) → when
        self.loops = {}  # where a loop begins → its names
        blocks = dict(blocks)
        order = in_order(blocks)
        for at, label in enumerate(order):
            into = [when for (_, to), when in self.edges.items() if to == label]
            self.when = reached if at == 0 else any_of(into)
            self.label = label
            lines = blocks[label]
            if any(label in targets(blocks[other]) for other in order[at:]):
                lines = self.enter_loop(lines)
            for line in lines:
                self.step(line)

    def is_kept(self, values):
        """Whether the invariant of this loop is true of its values."""
        [invariant] = [invariant for name, invariant in INVARIANTS.items() if name in self.name]
        return invariant(self.run, self.arguments, {name[1:].split(".")[0]: value for name, value in values.items()})

    def enter_loop(self, lines):
        """Forgets the values of a loop but for what the invariant says of them."""
        phis = [line.split(" = ", 1) for line in lines if " = phi " in line]
        first = {name: self.operation(text) for name, text in phis}
        for name, text in phis:
            self.values[name] = tm.mk_const(first[name].sort())
        self.loops[self.label] = phis
        self.run.wrong.append(all_of(self.when, negated(self.is_kept(first))))
        self.run.assumed.append(implies(self.when, self.is_kept({name: self.values[name] for name, _ in phis})))
        return lines[len(phis):]

    def value(self, text, width):
        text = text.strip()
        if text.startswith("%"):
            return self.values[text]
        return bits(int(width), {"true": 1, "false": 0}.get(text) if text in ("true", "false") else int(text))

    def edge(self, to, when):
        when = tm.mk_term(Kind.AND, [self.when, when])
        if to not in self.loops:
            self.edges[self.label, to] = when
            return
        again = {}
        for name, text in self.loops[to]:
            width = re.match(r"phi i(\d+)", text)[1]
            [value] = re.findall(rf"\[ (\S+), %{re.escape(self.label)} \]", text)
            again[name] = self.value(value, width)
        self.run.wrong.append(all_of(when, negated(self.is_kept(again))))

    def step(self, line):
        if line.startswith("br label"):
            self.edge(line.split("%")[1], tm.mk_true())
        elif line.startswith("br i1"):
            test, then, otherwise = re.fullmatch(r"br i1 (\S+), label %([\w.]+), label %([\w.]+)", line).groups()
            test = is_true(self.value(test, 1))
            self.edge(then, test)
            self.edge(otherwise, negated(test))
        elif line == "ret void":
            self.ends.append(self.when)
        elif line.startswith("ret"):
            self.ends.append(self.when)
            width, value = re.fullmatch(r"ret (?:i(\d+)|\{.*?\}) (\S+)", line).groups()
            value = self.value(value, width)
            self.returned = value if self.returned is None else choice(self.when, value, self.returned)
        elif line == "unreachable":
            self.run.wrong.append(self.when)
        elif line.startswith("store"):
            width, value, to = re.match(r"store i(\d+) (\S+), ptr (\S+),", line).groups()
            place, value = self.values[to], self.value(value, width)
            if place in self.run.memory:
                value = tm.mk_term(Kind.ITE, [self.when, value, self.run.memory[place]])
            self.run.memory[place] = value
        elif "panicking" in line or "@llvm.lifetime" in line or "@llvm.experimental" in line:
            pass  # what follows a panic is unreachable
        elif line.startswith("call void"):
            self.operation(line)
        else:
            name, operation = line.split(" = ", 1)
            self.values[name] = self.operation(operation)

    def operation(self, text):
        word = text.split()[0]
        if word in BINARY:
            width, a, b = re.fullmatch(r"\w+ i(\d+) (\S+), (\S+)", text).groups()
            [a, b] = [self.value(x, width) for x in (a, b)]
            return self.of_factor(word, a, b) or tm.mk_term(BINARY[word], [a, b])
        if word == "alloca":
            return (len(self.values), id(self)), 0
        if word == "getelementptr":
            base, offset = re.search(r"i8, ptr (\S+), i\d+ (\d+)$", text).groups()
            name, at = self.values[base]
            return name, at + int(offset)
        if word == "load":
            return self.run.memory[self.values[re.match(r"load i\d+, ptr ([^\s,]+)", text)[1]]]
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
            width, ways = re.fullmatch(r"phi (?:i(\d+)|\{.*?\}) (.*)", text).groups()
            ways = [way for way in re.findall(r"\[ (\S+), %([\w.]+) \]", ways) if (way[1], self.label) in self.edges]
            chosen = self.value(ways[0][0], width)
            for value, label in ways[1:]:
                chosen = choice(self.edges[label, self.label], self.value(value, width), chosen)
            return chosen
        if word == "extractvalue":
            pair, index = re.fullmatch(r"extractvalue \{.*?\} (\S+), (\d)", text).groups()
            return self.values[pair][int(index)]
        if word == "insertvalue":
            pair, width, value, index = re.fullmatch(r"insertvalue \{.*?\} (\S+), i(\d+) (\S+), (\d)", text).groups()
            value = self.value(value, width)
            before = [value, value] if pair == "poison" else self.values[pair]
            return [value if i == int(index) else old for i, old in enumerate(before)]
        if word == "freeze":
            return self.value(*reversed(re.fullmatch(r"freeze i(\d+) (\S+)", text).groups()))
        if word == "call":
            called, arguments = re.search(r"@([\w.$]+)\((.*)\)", text).groups()
            arguments = [a.split(" ") for a in re.split(r", (?=i\d|ptr)", arguments)]
            return self.call(called, [self.value(a[-1], a[0][1:]) for a in arguments])
        raise NotImplementedError(text)

    def of_factor(self, word, a, b):
        """A product with the factor that is known, or the quotient, or nothing. A long product of numbers with a sign is any
        number of its range and sign, but always the same."""
        products, width = self.run.products, a.sort().bv_size()
        if word == "mul" and self.run.is_abstract and width == 64:
            return self.long(a, b) if is_extended(a) and is_extended(b) else self.long_unsigned(a, b)
        if products is None or word not in ("mul", "udiv"):
            return None
        factor = products.factor if width == 32 else longer(products.factor, 32)
        if word == "udiv":
            assert b == factor
            quotient, rest = [tm.mk_const(tm.mk_bv_sort(32)) for _ in range(2)]
            is_zero = equal(b, bits(32, 0))
            whole = equal(longer(a, 32), plus(products.of(quotient), longer(rest, 32)))
            self.run.assumed.append(tm.mk_term(Kind.OR, [is_zero, all_of(whole, tm.mk_term(Kind.BV_ULT, [rest, b]))]))
            return quotient
        other = a if b == factor else b
        assert factor in (a, b)
        if width == 32:
            return tm.mk_term(Kind.BV_EXTRACT, [products.of(other)], [31, 0])
        [short] = other.children()
        assert other == longer(short, 32)
        return products.of(short)

    def long(self, a, b):
        if (a, b) not in self.run.long:
            [product, other] = [tm.mk_term(Kind.APPLY, [self.run.product, *factors]) for factors in ((a, b), (b, a))]
            self.run.long[a, b] = product
            self.run.assumed.append(equal(product, other))
            limits = [(Kind.BV_SGE, -(2**62) + 2**31), (Kind.BV_SLE, 2**62)]
            zero = bits(64, 0)
            is_positive = equal(*[tm.mk_term(Kind.BV_SLT, [x, zero]) for x in (a, b)])
            above, below = [tm.mk_term(kind, [product, zero]) for kind in (Kind.BV_SGE, Kind.BV_SLE)]
            self.run.assumed += [tm.mk_term(kind, [product, bits(64, limit)]) for kind, limit in limits]
            self.run.assumed += [implies(is_positive, above), implies(negated(is_positive), below)]
            is_zero = any_of([equal(x, zero) for x in (a, b)])
            self.run.assumed += [implies(is_zero, equal(product, zero))]
            self.run.assumed += [implies(all_of(is_large(a, 29), is_large(b, 29)), is_large(product, 58))]
        return self.run.long[a, b]

    def long_unsigned(self, a, b):
        """The same without signs, if the numbers are below 2³²."""
        [product, other] = [tm.mk_term(Kind.APPLY, [self.run.product, *factors]) for factors in ((a, b), (b, a))]
        is_zero = any_of([equal(x, bits(64, 0)) for x in (a, b)])
        is_low = all_of(*[is_below(x, 32) for x in (a, b)])
        is_at_most = tm.mk_term(Kind.BV_ULE, [product, bits(64, (2**31 - 1) * (2**32 - 1))])
        self.run.assumed += [
            equal(product, other),
            implies(is_zero, equal(product, bits(64, 0))),
            implies(all_of(is_low, is_large(a, 26), is_large(b, 26)), negated(is_below(product, 52))),
            implies(all_of(is_low, any_of([is_below(x, 31) for x in (a, b)])), is_at_most),
            implies(all_of(*[is_below(x, 31) for x in (a, b)]), is_below(product, 62)),
        ]
        return product

    def reciprocal_root(self, number):
        """One of which is known what `every.rs` finds of it."""
        root = tm.mk_term(Kind.APPLY, [self.run.root, number])
        is_normal = tm.mk_term(Kind.BV_UGE, [number, bits(32, 2**30)])
        limits = [(Kind.BV_UGE, 2**27 - 8), (Kind.BV_ULE, 2**28 + 8)]
        self.run.assumed += [implies(is_normal, tm.mk_term(kind, [root, bits(32, limit)])) for kind, limit in limits]
        return root

    def upper(self, a, b, _round):
        """The upper half of a product, of which is known what `claim_upper_signed` says of its range."""
        if (a, b) not in self.run.long:
            self.run.long[a, b] = upper = tm.mk_const(tm.mk_bv_sort(32))
            zero = bits(32, 0)
            of_signs = [tm.mk_term(Kind.ITE, [tm.mk_term(Kind.BV_SLT, [x, zero]), y, zero]) for x, y in ((a, b), (b, a))]
            signed = tm.mk_term(Kind.BV_SUB, [upper, plus(*of_signs)])
            limits = [(Kind.BV_SGE, -(2**30)), (Kind.BV_SLE, 2**30)]
            self.run.assumed += [tm.mk_term(kind, [signed, bits(32, limit)]) for kind, limit in limits]
        return self.run.long[a, b]

    def call(self, called, arguments):
        if self.run.is_abstract and "upper_rounded" in called:
            return self.upper(*arguments)
        if "10reciprocal17h" in called:
            # every one from 2¹⁶ to 2³¹ is tried
            [number] = arguments
            is_tried = all_of(tm.mk_term(Kind.BV_UGT, [number, bits(32, 2**16)]), tm.mk_term(Kind.BV_SGT, [number, bits(32, 0)]))
            self.run.wrong.append(all_of(self.when, negated(is_tried)))
            return tm.mk_const(tm.mk_bv_sort(32))
        if "reciprocal_root" in called:
            return self.reciprocal_root(*arguments)
        if not called.startswith("llvm."):
            call = Call(self.run, called, arguments, self.when)
            self.when = any_of(call.ends)  # a loop goes round once, and may not have ended
            return call.returned
        name, *rest = called.split(".")[1:]
        if name in EXTREMES:
            return tm.mk_term(Kind.ITE, [tm.mk_term(EXTREMES[name], arguments), *arguments])
        if rest[:2] == ["with", "overflow"]:
            operation, overflow = OVERFLOWS[name]
            return [tm.mk_term(operation, arguments), true(tm.mk_term(overflow, arguments))]
        if name == "ctlz":
            return zeros_above(arguments[0])
        if name == "abs":
            return magnitude(arguments[0])
        if name == "fshl":
            high, low, by = arguments
            width = high.sort().bv_size()
            both = tm.mk_term(Kind.BV_SHL, [tm.mk_term(Kind.BV_CONCAT, [high, low]), longer(by, width)])
            return tm.mk_term(Kind.BV_EXTRACT, [both], [2 * width - 1, width])
        if called.startswith("llvm.sadd.sat"):
            width = arguments[0].sort().bv_size()
            is_low = tm.mk_term(Kind.BV_SLT, [arguments[0], bits(width, 0)])
            end = choice(is_low, bits(width, -(2 ** (width - 1))), bits(width, 2 ** (width - 1) - 1))
            return choice(tm.mk_term(Kind.BV_SADD_OVERFLOW, arguments), end, plus(*arguments))
        if called.startswith("llvm.uadd.sat"):
            most = bits(arguments[0].sort().bv_size(), -1)
            return tm.mk_term(Kind.ITE, [tm.mk_term(Kind.BV_UADD_OVERFLOW, arguments), most, plus(*arguments)])
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
        factor = magnitude(inputs[1]) if claim == "claim_quotient" else None
        run = Run(program, factor, claim in ABSTRACT)
        call = Call(run, function, inputs, tm.mk_true())
        solver = Bitwuzla(tm, Options())
        for assumption in run.assumed:
            solver.assert_formula(assumption)
        solver.assert_formula(any_of([*run.wrong, all_of(any_of(call.ends), negated(is_true(call.returned)))]))
        result = solver.check_sat()
        verdict = {Result.UNSAT: "proved", Result.SAT: "refuted"}.get(result, "open")
        is_proved &= verdict == "proved"
        print(f"{claim}: {verdict} in {time.time() - start:.1f} s", flush=True)
    return is_proved


if __name__ == "__main__":
    sys.exit(not main(*sys.argv[1:]))
