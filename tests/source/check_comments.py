#!/usr/bin/env python3
"""Fails when a comment begins with "Of": it then has no subject, and a reader has to look for one in
what comes after it or stood before it.

usage: check_comments.py SOURCE_ROOT | --self-test
"""
import pathlib
import re
import sys

FOLDERS = ("app", "filters", "analysis", "ui", "datasets", "tests")
SUFFIXES = (".h", ".cpp", ".glsl")
# Code before a comment, which may have strings with slashes in them; a comment's text.
LINE = re.compile(r'^(?P<code>(?:"(?:\\.|[^"\\])*"|(?!//)[^"])*)//\s?(?P<text>.*)$')


def problems_in(path, text):
    """Each comment of `text`, the file at `path` below the root, that begins with "Of"."""
    before = False  # whether the line before is a comment by itself, which this one goes on with
    for number, line in enumerate(text.splitlines(), 1):
        match = LINE.match(line)
        alone = bool(match) and not match.group("code").strip()
        if match and not (alone and before) and re.match(r"Of\s", match.group("text")):
            yield f'{path}:{number}: the comment begins with "Of" and has no subject: {match.group("text")}'
        before = alone


def check(root):
    problems, files = [], 0
    for folder in FOLDERS:
        for file in sorted((root / folder).rglob("*")):
            if file.suffix in SUFFIXES:
                files += 1
                problems += problems_in(file.relative_to(root), file.read_text())
    for problem in problems:
        print(problem)
    print(f"{files} files, {len(problems)} comments without a subject")
    return 1 if problems or files == 0 else 0


def self_test():
    """The check must see what it is there for."""
    bad = ["// Of the last frame.\nint a;", "int a;  // Of the frame", "  //Of one class", "//\n\nint a;\n// Of b"]
    good = ["// The depths\n// Of a region are sorted.", 'const char* a = "// Of b";', "// Often", "int a;  // of the frame"]
    missed = [text for text in bad if not list(problems_in("a.h", text))]
    wrongly = [text for text in good if list(problems_in("a.h", text))]
    print(f"missed: {missed}, wrongly reported: {wrongly}")
    return 1 if missed or wrongly else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(self_test() if sys.argv[1] == "--self-test" else check(pathlib.Path(sys.argv[1])))
