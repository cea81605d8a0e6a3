#!/usr/bin/env python3
"""Fails when a source file is longer than 400 lines: two ideas live in it.

usage: check_sizes.py SOURCE_ROOT
"""
import pathlib
import sys

LONGEST = 400
FOLDERS = ("app", "filters", "analysis", "ui", "datasets", "tests")
SUFFIXES = (".h", ".cpp", ".glsl", ".py")


def main(root):
    files = [f for folder in FOLDERS for f in (root / folder).rglob("*") if f.suffix in SUFFIXES]
    too_long = 0
    for file in files:
        lines = len(file.read_text().splitlines())
        if lines > LONGEST:
            too_long += 1
            print(f"{file.relative_to(root)}: {lines} lines, {LONGEST} are allowed")
    print(f"{len(files)} files, {too_long} too long")
    return 1 if too_long or not files else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
