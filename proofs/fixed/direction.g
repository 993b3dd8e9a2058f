# How far a direction and a length of `Fixed` are from exact, for every vector but the zero vector.
#
# A vector is shifted up until its largest component is 2^29 or more; c is a component of it. s is |v|^2 / 2^32 and S what is left
# of it where three squares are cut off, so that S = s (1 - t). The reciprocal root r is 2^43 / sqrt(S), and off by e of itself:
# its square, which every.rs tries, is off by 2^-24. n is the exact component of the direction, c / (2^16 sqrt(s)), and c r / 2^43
# are its steps. w is sqrt(s), and 2^11 w the length in units of 2^(5 - shift) steps, of which r makes S r / 2^32.
@cut = fixed<-11, dn>; # the upper half of a product
@whole = fixed<0, dn>;

k = sqrt(1 / (1 - t)) * (1 + e);
N = 65536 * n;
x = N * k;
y = cut(x);
u = whole(y + 0.5);

j = sqrt(1 - t) * (1 + e);
L = 2048 * w;
l = whole(L * j);

{ n in [-1, 1] /\ t in [0, 3b-26] /\ |e| <= 0x1.0001p-25 /\ w in [8192, 65536]
  -> |u - N| <= 0.5041 /\ |l -/ L| <= 1b-23 }

u - N -> (u - (y + 0.5)) + 0.5 + (y - x) + (x - N);
x - N -> N * (k - 1);
(L * j - L) / L -> j - 1 { L <> 0 };
