"""Plants changes in a copy of the source, each chosen by its number in the environment variable PLANTED.

    plant.py LIST FOLDER CRATE_ROOT FIRST

A line of the list: file ¦ where, with what is replaced in « » ¦ what stands there instead. Further columns are ignored, and a
line that begins with a space continues the one before. One build has all changes; the first has the number FIRST."""
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


def plant(text, where, new, number):
    """The expression between the marks becomes a choice. It may lie within one that has been planted already."""
    before, old, after = where.replace("«", "»").split("»")
    at = text.rfind(before + old + after)
    assert at >= 0, f"there is no {where}"
    start = at + len(before)
    choice = f"(if crate::planted({number}) {{ {new} }} else {{ {old} }})"
    return text[:start] + choice + text[start + len(old):]


def main(list_, folder, root, first):
    folder = pathlib.Path(folder)
    originals = {}
    numbered = list(enumerate(rows(list_), int(first)))
    # the longest first, for another may lie within it
    for number, (file, where, new, *_) in sorted(numbered, key=lambda row: -len(row[1][1])):
        path = folder / f"{file}.rs"
        original = originals.setdefault(file, path.read_text())
        assert original.count(where.replace("«", "").replace("»", "")) == 1, f"{file} has not exactly one {where}"
        path.write_text(plant(path.read_text(), where, new, number))
    root = folder / root
    root.write_text(root.read_text() + SWITCH)
    print(int(first) + len(numbered))


if __name__ == "__main__":
    main(*sys.argv[1:])
