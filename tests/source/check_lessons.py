#!/usr/bin/env python3
"""Fails when a lesson names a control, a pane or a key that the window does not have. Lessons write
such names **bold**, and nothing else.

usage: check_lessons.py SOURCE_ROOT | --self-test
"""
import json
import pathlib
import re
import sys

LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
BOLD = re.compile(r"\*\*(.+?)\*\*")
KEY = re.compile(r"Qt::Key_(\w+)")
SHORT = {"Escape": "Esc"}  # what Qt calls a key in the code, and in a menu
DIGIT_KEYS = "techniqueKey"  # gives the first techniques the digits as keys


def literals(text):
    """The string literals of C++ `text`, without those of includes."""
    lines = (line for line in text.splitlines() if not line.lstrip().startswith("#include"))
    return LITERAL.findall("\n".join(lines))


def names_in(window, settings, parameters):
    """What can be called by a name in the window: of `window` (the sources of its widgets), of
    `settings` (rows of the tables) and of `parameters` (fields of techniques, in kebab-case)."""
    names = {literal.replace("&", "").removesuffix("…").rstrip() for literal in literals(window) + literals(settings)}
    names |= {SHORT.get(key, key) for key in KEY.findall(window)}
    names |= {name.replace("-", " ").capitalize() for name in literals(parameters)
              if re.fullmatch(r"[a-z]+(-[a-z]+)*", name)}
    if DIGIT_KEYS in window:
        names |= set("0123456789")
    return names


def texts_of(lesson):
    """Where it stands, and the text, of all that a lesson says."""
    for number, step in enumerate(lesson["steps"], 1):
        question = step.get("question", {})
        for text in (step["text"], step.get("look", ""), question.get("text", ""), question.get("explanation", "")):
            yield f"step {number}", text if isinstance(text, str) else "\n".join(text)


def problems_in(lessons, names):
    """The bold words of `lessons`, by file, that are not among `names`."""
    for file, lesson in lessons.items():
        for place, text in texts_of(lesson):
            for bold in BOLD.findall(text):
                if bold not in names:
                    yield f"{file}: {place}: the window has no '{bold}'"


def read(paths):
    return "\n".join(path.read_text() for path in sorted(paths) if not path.name.endswith("Test.cpp"))


def main(root):
    names = names_in(read((root / "ui").rglob("*.cpp")), read((root / "filters/core/settings").glob("*Rows.cpp")),
                     read((root / "filters/techniques").rglob("*.h")))
    lessons = {path.name: json.loads(path.read_text()) for path in sorted((root / "datasets/lessons").glob("*.json"))}
    problems = list(problems_in(lessons, names))
    for problem in problems:
        print(problem)
    print(f"{len(lessons)} lessons, {len(problems)} problems")
    return 1 if problems or not lessons else 0


def self_test():
    """The check must see what it is there for."""
    names = names_in('#include "ui/Gone.h"\nadd(tr("&Save session …"), QKeySequence("K"), Qt::Key_Escape, Qt::Key_F4);\n'
                     "QString techniqueKey(int place);",
                     '{.name = "read.sat-precision",\n .title = "Sums"}', 'field(&P::a, "bleed-reduction", "a")')
    bad = ["Press **F5**.", "**ui/Gone.h**", ["A line", "and **Darken this region**"], "**bleed-reduction**", "**sums**"]
    good = ["Press **F4**, **Esc**, **K** or **2**.", "*emphasis*", ["**Bleed reduction**", "of **Sums**"], "**Save session**"]
    where = [lambda t: {"text": t}, lambda t: {"text": "", "look": t},
             lambda t: {"text": "", "question": {"text": t}}, lambda t: {"text": "", "question": {"explanation": t}}]

    def seen(text):
        return [bool(list(problems_in({"a.json": {"steps": [put(text)]}}, names))) for put in where]

    missed = [text for text in bad if not all(seen(text))]
    wrong = [text for text in good if any(seen(text))]
    print(f"missed: {missed}, wrongly reported: {wrong}")
    return 1 if missed or wrong else 0


if __name__ == "__main__":
    sys.exit(self_test() if sys.argv[1] == "--self-test" else main(pathlib.Path(sys.argv[1])))
