"""Plants faults in a copy of the source, each chosen by its number in the environment variable PLANTED.

    plant.py LIST FOLDER        prints how many there are

A line of a list: file, function, operator, which one of these in the function, what becomes of it, and claims. An operator is
one of + - * / < <= > >= == && ||, the unary neg and not, or the name of a method. It becomes another operator, one of its
operands (left, right; drop for what a method is called on; then, otherwise), or a name. For the prover, whose rules are more than
operators, a line is: file ¦ where, with what is replaced in « » ¦ what stands there instead. One build has all faults.
(pip install tree-sitter tree-sitter-rust)"""
import pathlib
import sys

import tree_sitter
import tree_sitter_rust

SWITCH = """
extern crate std;
/// Whether this fault was chosen.
pub(crate) fn planted(number: usize) -> bool {
    static CHOSEN: std::sync::OnceLock<usize> = std::sync::OnceLock::new();
    let chosen = || std::env::var("PLANTED").ok().and_then(|text| text.parse().ok());
    *CHOSEN.get_or_init(|| chosen().unwrap_or(usize::MAX)) == number
}
"""
PARSER = tree_sitter.Parser(tree_sitter.Language(tree_sitter_rust.language()))
BINARY = ["+", "-", "*", "/", "<", "<=", ">", ">=", "==", "&&", "||"]


def text(node):
    return node.text.decode()


def functions(node, of=""):
    """The functions that may be changed, with their names: not those of constants, nor those that only convert a number type."""
    if node.type in ("impl_item", "trait_item"):
        of = text(node.child_by_field_name("type") or node.child_by_field_name("name")).split("<")[0] + "::"
    if node.type == "function_item":
        modifiers = [text(child) for child in node.children if child.type == "function_modifiers"]
        if "const" not in " ".join(modifiers) and text(node.child_by_field_name("name")) != "cast":
            yield of + text(node.child_by_field_name("name")), node
    elif node.type != "macro_definition":
        for child in node.children:
            yield from functions(child, of)


def operators(node):
    """Each operator with its node, in the order of the text."""
    found = []
    if node.type == "binary_expression":
        sign = node.child_by_field_name("operator")
        found.append((sign.start_byte, sign.type, node))
    elif node.type == "unary_expression" and node.children[0].type in "-!":
        found.append((node.start_byte, {"-": "neg", "!": "not"}[node.children[0].type], node))
    elif node.type == "call_expression" and node.child_by_field_name("function").type == "field_expression":
        name = node.child_by_field_name("function").child_by_field_name("field")
        found.append((name.start_byte, text(name), node))
    for child in node.children:
        if child.type not in ("const_item", "const_block"):
            found += operators(child)
    return sorted(found, key=lambda entry: entry[0])


def becomes(node, new):
    """What stands there instead."""
    field = lambda name: text(node.child_by_field_name(name))
    if new in ("left", "right"):
        return field(new)
    if new == "drop":
        return text(node.children[1]) if node.type == "unary_expression" else text(node.child_by_field_name("function").child_by_field_name("value"))
    if new in ("then", "otherwise"):
        return text(node.child_by_field_name("arguments").named_children[new == "otherwise"])
    return f"{field('left')} {new} {field('right')}" if new in BINARY else new


def render(node, faults):
    """The text with a choice at each node that has faults; another may lie within it."""
    out, at = "", node.start_byte
    source = node.text
    for child in node.children:
        out += source[at - node.start_byte : child.start_byte - node.start_byte].decode() + render(child, faults)
        at = child.end_byte
    out += source[at - node.start_byte :].decode()
    for number, new in faults.get((node.start_byte, node.end_byte), []):
        out = f"(if crate::planted({number}) {{ {becomes(node, new)} }} else {{ {out} }})"
    return out


def rows(path):
    """file, function, operator, which, becomes, claims"""
    lines = pathlib.Path(path).read_text().splitlines()
    return [line.split(maxsplit=5) for line in lines if line and not line.startswith("#")]


def quote(folder, lines):
    """Plants what lines with ¦ say."""
    changes = {}
    for number, line in enumerate(lines):
        file, where, new = line.split(" ¦ ")
        changes.setdefault((file, where), []).append((number, new))
    originals = {file: (folder / f"{file}.rs").read_text() for file, _ in changes}
    # the longest first, for another may lie within it
    for (file, where), of_it in sorted(changes.items(), key=lambda change: -len(change[0][1])):
        before, old, after = where.replace("\\n", "\n").replace("«", "»").split("»")
        assert originals[file].count(before + old + after) == 1, f"{file} has not exactly one {where}"
        path = folder / f"{file}.rs"
        text = path.read_text()
        assert before + old + after in text, f"another line changes {file} around {where}"
        start = text.rfind(before + old + after) + len(before)
        choice = " else ".join(f"if crate::planted({number}) {{ {new} }}" for number, new in of_it)
        path.write_text(f"{text[:start]}({choice} else {{ {old} }}){text[start + len(old):]}")


def plant(folder, faults):
    by_file = {}
    for number, (file, name, operator, which, new, *_) in enumerate(faults):
        by_file.setdefault(file, []).append((number, name, operator, int(which), new))
    for file, changes in by_file.items():
        path = folder / f"{file}.rs"
        root = PARSER.parse(path.read_bytes()).root_node
        found = {}
        for name, function in functions(root):
            found.setdefault(name, []).extend(operators(function))
        at = {}
        for number, name, operator, which, new in changes:
            nodes = [node for _, sign, node in found.get(name, []) if sign == operator]
            assert which <= len(nodes), f"{file} has no {operator} {which} in {name}"
            node = nodes[which - 1]
            at.setdefault((node.start_byte, node.end_byte), []).append((number, new))
        path.write_text(render(root, at))


def main(list_, folder):
    folder = pathlib.Path(folder)
    lines = pathlib.Path(list_).read_text().splitlines()
    quoted = [line for line in lines if " ¦ " in line and line[0] != "#"]
    if quoted:
        quote(folder, quoted)
    else:
        plant(folder, rows(list_))
    root = folder / "lib.rs"
    root.write_text(root.read_text() + SWITCH)
    print(len(quoted or rows(list_)))


if __name__ == "__main__":
    main(*sys.argv[1:])
