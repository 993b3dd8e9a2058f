"""Plants faults in a copy of the source, each chosen by its number in the environment variable PLANTED.

    plant.py LIST FOLDER        prints how many there are

A line of a list is: file ¦ where, with the expression that is replaced in « » ¦ what stands there instead ¦ what it breaks. One
build has all faults. Spaces stand for any spaces and line breaks."""
import pathlib
import re
import sys

SWITCH = """
extern crate std;
/// Whether this fault was chosen.
pub(crate) fn planted(number: usize) -> bool {
    static CHOSEN: std::sync::OnceLock<usize> = std::sync::OnceLock::new();
    let chosen = || std::env::var("PLANTED").ok().and_then(|text| text.parse().ok());
    *CHOSEN.get_or_init(|| chosen().unwrap_or(usize::MAX)) == number
}
"""


def rows(path):
    """file, where, what stands there instead, what it breaks"""
    lines = pathlib.Path(path).read_text().splitlines()
    return [line.split(" ¦ ") for line in lines if not line.startswith("#")]


def plant(folder, faults):
    changes = {}
    for number, (file, where, new, *_) in enumerate(faults):
        changes.setdefault((file, *re.split("[«»]", where)), []).append(f"if crate::planted({number}) {{ {new} }} else ")
    originals = {file: (folder / f"{file}.rs").read_text() for file, *_ in changes}
    # the longest first, for another may lie within it
    for (file, *parts), choices in sorted(changes.items(), key=lambda change: -len(change[0][2])):
        where = re.compile("".join(f"({re.escape(part)})" for part in parts).replace("\\ ", r"\s+"))
        assert len(where.findall(originals[file])) == 1, f"{file} has not exactly one {''.join(parts)}"
        path = folder / f"{file}.rs"
        text = path.read_text()
        *_, last = [None, *where.finditer(text)]
        assert last, f"another line changes {file} around {''.join(parts)}"
        start, end = last.span(2)
        path.write_text(f"{text[:start]}({''.join(choices)}{{ {last[2]} }}){text[end:]}")


def main(list_, folder):
    folder, faults = pathlib.Path(folder), rows(list_)
    plant(folder, faults)
    root = folder / "lib.rs"
    root.write_text(root.read_text() + SWITCH)
    print(len(faults))


if __name__ == "__main__":
    main(*sys.argv[1:])
