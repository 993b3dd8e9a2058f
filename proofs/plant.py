"""Plants changes in a copy of the source, each chosen by its number in the environment variable PLANTED.

    plant.py LIST FOLDER CRATE_ROOT

A line of the list: file ¦ where, with what is replaced in « » ¦ what stands there instead. Further columns are ignored, and a
line that begins with a space continues the one before. One build has all changes."""
import pathlib
import sys

SWITCH = """
extern crate std;
/// Whether this change was chosen.
pub(crate) fn planted(number: usize) -> bool {
    static CHOSEN: std::sync::OnceLock<usize> = std::sync::OnceLock::new();
    let chosen = || std::env::var("PLANTED").ok().and_then(|text| text.parse().ok());
    *CHOSEN.get_or_init(|| chosen().unwrap_or(usize::MAX)) == number
}
"""


def rows(path):
    text = pathlib.Path(path).read_text().replace("\n ", "\x00 ")
    lines = [line.replace("\x00", "\n") for line in text.splitlines() if not line.startswith("#")]
    return [line.split(" ¦ ") for line in lines]


def plant(text, where, changes):
    """The expression between the marks becomes a choice. It may lie within one that has been planted already."""
    before, old, after = where.replace("«", "»").split("»")
    at = text.rfind(before + old + after)
    assert at >= 0, f"there is no {where}"
    start = at + len(before)
    choice = " else ".join(f"if crate::planted({number}) {{ {new} }}" for number, new in changes)
    return f"{text[:start]}({choice} else {{ {old} }}){text[start + len(old):]}"


def main(list_, folder, root):
    folder = pathlib.Path(folder)
    changes, originals = {}, {}
    for number, (file, where, new, *_) in enumerate(rows(list_)):
        changes.setdefault((file, where), []).append((number, new))
    # the longest first, for another may lie within it
    for (file, where), of_it in sorted(changes.items(), key=lambda change: -len(change[0][1])):
        path = folder / f"{file}.rs"
        original = originals.setdefault(file, path.read_text())
        assert original.count(where.replace("«", "").replace("»", "")) == 1, f"{file} has not exactly one {where}"
        path.write_text(plant(path.read_text(), where, of_it))
    root = folder / root
    root.write_text(root.read_text() + SWITCH)
    print(len(rows(list_)))


if __name__ == "__main__":
    main(*sys.argv[1:])
