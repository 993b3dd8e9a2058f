"""Proves what fixed point promises from its integers: fixed.py OPERANDS

Products, dot products and sums over lights of `src/fixed` as bit vectors, asked of Bitwuzla for all operands. The lines of
OPERANDS, which a test prints, are what the source gives for some operands: an equation (= (mul #x… #x…) #x…) each. The definitions
below must give the same. A statement that is false is among them, and must be refuted. (pip install bitwuzla)"""
import pathlib
import sys

from solve import solve

WORD, LONG = "(_ BitVec 32)", "(_ BitVec 64)"
DEFINITIONS = f"""(set-logic QF_BV)
(define-fun long ((x {WORD})) {LONG} ((_ sign_extend 32) x))
(define-fun most () {WORD} #x7fffffff)
(define-fun least () {WORD} #x80000000)
(define-fun one () {WORD} #x00010000)
(define-fun rounded16 ((p {LONG}) (sign {WORD})) {WORD}
  (let ((x (bvadd p #x0000000000008000))) (let ((up ((_ extract 63 32) x)))
  (ite (= (bvashr (bvshl up #x00000010) #x00000010) up) ((_ extract 31 0) (bvashr x #x0000000000000010))
       (bvxor (bvashr sign #x0000001f) most)))))
(define-fun rounded15 ((p {LONG}) (sign {WORD})) {WORD}
  (let ((x (bvadd p #x0000000000004000))) (let ((up ((_ extract 63 32) x)))
  (ite (= (bvashr (bvshl up #x00000011) #x00000011) up) ((_ extract 31 0) (bvashr x #x000000000000000f))
       (bvxor (bvashr sign #x0000001f) most)))))
(define-fun mul ((a {WORD}) (b {WORD})) {WORD} (rounded16 (bvmul (long a) (long b)) (bvxor a b)))
(define-fun half ((a {WORD}) (b {WORD})) {LONG} (bvashr (bvmul (long a) (long b)) #x0000000000000001))
(define-fun dot ((a {WORD}) (b {WORD}) (c {WORD}) (x {WORD}) (y {WORD}) (z {WORD})) {WORD}
  (let ((sum (bvadd (bvadd (half a x) (half b y)) (half c z)))) (let ((steps (rounded15 sum ((_ extract 63 32) sum))))
  (ite (and (= steps #x00000000) (bvsgt sum #x0000000000000000)) #x00000001 steps))))
(define-fun faces ((a {WORD}) (b {WORD}) (c {WORD}) (x {WORD}) (y {WORD}) (z {WORD})) Bool
  (bvsgt (bvadd (bvmul (long a) (long x)) (bvmul (long b) (long y)) (bvmul (long c) (long z))) #x0000000000000000))
(define-fun lit ((light {WORD}) (factor {WORD})) {WORD}
  (let ((light (ite (bvslt light #x00000000) #x00000000 light))
        (factor (ite (bvslt factor #x00000000) #x00000000 (ite (bvsgt factor one) one factor))))
  (let ((steps (bvlshr (bvadd (bvmul (long light) (long factor)) #x0000000000008000) #x0000000000000010)))
  (ite (= (bvlshr steps #x000000000000001f) #x0000000000000000) ((_ extract 31 0) steps) most))))
(define-fun clamped ((x {LONG})) {WORD}
  (ite (bvsgt x (long most)) most (ite (bvslt x (long least)) least ((_ extract 31 0) x))))
"""
NUMBERS = "".join(f"(declare-const {name} {WORD})" for name in "abcxyz")
AT_LEAST_0 = "(bvsge {} #x00000000)"
PRODUCTS = f"(declare-const p {LONG})(declare-const q {LONG})"
SIGN = "(= (bvslt {} #x0000000000000000) (bvslt {} #x00000000))"
# what is assumed, what follows, and whether it is true; p and q are products, which are at most 2^62 in size
STATEMENTS = {
    "a product is rounded to the nearest number, or to the nearest end": (
        ["(bvsle p #x4000000000000000)", "(bvsge p #xc000000000000000)", SIGN.format("p", "a")],
        "(= (rounded16 p a) (clamped (bvashr (bvadd p #x0000000000008000) #x0000000000000010)))", True),
    "of two products, the lesser is not rounded to more": (
        ["(bvsle p q)", "(bvsle q #x4000000000000000)", "(bvsge p #xc000000000000000)", SIGN.format("p", "a"), SIGN.format("q", "b")],
        "(bvsle (rounded16 p a) (rounded16 q b))", True),
    "a product of numbers that are not negative is not": (["a", "b"], "(bvsge (mul a b) #x00000000)", True),
    "a product that is at most a times 1 is rounded to at most a": (
        ["a", "(bvsle #x0000000000000000 p)", "(bvsle p (bvshl (long a) #x0000000000000010))"], "(bvsle (rounded16 p #x00000000) a)", True),
    "a product does not depend on the order": ([], "(= (mul a b) (mul b a))", True),
    "a dot product of components that are not negative is not": (list("abcxyz"), "(bvsge (dot a b c x y z) #x00000000)", True),
    "what a light adds, whatever the factor, is not negative": ([], "(bvsge (lit a b) #x00000000)", True),
    "the opposite of a product is the product with the opposite (false: ties round up)": (
        ["(bvsgt a least)"], "(= (bvneg (mul a b)) (mul (bvneg a) b))", False),
}


def main(operands):
    wrong = []
    equations = pathlib.Path(operands).read_text().split("\n")[:-1]
    assert len(equations) > 1000, "too few operands"
    agreement = f"{DEFINITIONS}(assert (not (and {' '.join(equations)})))"
    result, seconds = solve((agreement, 60))
    print(f"the source and the definitions agree for {len(equations)} operands: {result == 'unsat'}, {seconds:.1f} s")
    if result != "unsat":
        wrong.append("agreement")
    for statement, (assumed, follows, is_true) in STATEMENTS.items():
        facts = "".join(f"(assert {AT_LEAST_0.format(fact) if len(fact) == 1 else fact})" for fact in assumed)
        result, seconds = solve((f"{DEFINITIONS}{NUMBERS}{PRODUCTS}{facts}(assert (not {follows}))", 300))
        verdict = {"unsat": "proved", "sat": "refuted"}.get(result, "open")
        print(f"{verdict} in {seconds:.1f} s: {statement}", flush=True)
        if verdict != ("proved" if is_true else "refuted"):
            wrong.append(statement)
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main(*sys.argv[1:])
