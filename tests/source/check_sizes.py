#!/usr/bin/env python3
"""Fails when a source file is longer than 400 lines, since two ideas live in it; when more than 40
sources lie flat in one folder; or when the members of one class are cut over several .cpp files. A
technique's explanation may stand beside it, Csm::explain in CsmExplain.cpp.

usage: check_sizes.py SOURCE_ROOT | --self-test
"""
import collections
import pathlib
import re
import sys

LONGEST = 400
MOST_FLAT = 40
# The definition of a member function, at the start of a line: "void Probe::read(" is of Probe.
MEMBER = re.compile(r"^(?!\s)(?:[\w:<>,&*\s~]+?[\s&*])?(\w+)::~?\w+\(")
FOLDERS = ("app", "filters", "analysis", "ui", "datasets", "tests")
SUFFIXES = (".h", ".cpp", ".glsl", ".py")


def members(text):
    """The classes whose members `text` defines."""
    return {match.group(1) for match in map(MEMBER.match, text.splitlines()) if match}


def problems_in(sources):
    """What is too large in `sources`, the text of each file by its path below the root."""
    for path, text in sources.items():
        if (lines := len(text.splitlines())) > LONGEST:
            yield f"{path}: {lines} lines, {LONGEST} are allowed"
    flat = collections.Counter(path.rpartition("/")[0] for path in sources)
    for folder, count in flat.items():
        if count > MOST_FLAT:
            yield f"{folder}: {count} files lie flat, {MOST_FLAT} are allowed: make rooms"
    headers = {path.rpartition("/")[2][:-2] for path in sources if path.endswith(".h")}
    files = collections.defaultdict(list)
    for path, text in sources.items():
        if path.endswith(".cpp"):
            for name in members(text) & headers:
                files[name].append(path)
    for name, paths in files.items():
        cut = [path for path in paths if not path.endswith(f"/{name}Explain.cpp")]
        if len(cut) > 1:
            yield f"{name}: its members lie in {len(cut)} files ({', '.join(sorted(cut))}): divide what it does"


def main(root):
    sources = {str(f.relative_to(root)): f.read_text() for folder in FOLDERS
               for f in sorted((root / folder).rglob("*")) if f.suffix in SUFFIXES}
    problems = list(problems_in(sources))
    for problem in problems:
        print(problem)
    print(f"{len(sources)} files, {len(problems)} problems")
    return 1 if problems or not sources else 0


def self_test():
    """The check must see what it is there for."""
    part = "void Wide::run() {\n}\n"
    bad = [
        {"ui/Long.cpp": "\n" * 401},
        {f"ui/F{i}.h": "" for i in range(41)},
        {"ui/Wide.h": "class Wide;", "ui/WideFirst.cpp": part, "ui/WideSecond.cpp": part},
    ]
    good = [
        {"ui/Wide.h": "class Wide;", "ui/Wide.cpp": part, "ui/Other.cpp": "int f() {}\n" * 200},
        {"filters/Wide.h": "class Wide;", "filters/Wide.cpp": part, "filters/WideExplain.cpp": part},
    ]
    missed = [i for i, sources in enumerate(bad) if not list(problems_in(sources))]
    wrong = [i for i, sources in enumerate(good) if list(problems_in(sources))]
    print(f"missed: {missed}, wrongly reported: {wrong}")
    return 1 if missed or wrong else 0


if __name__ == "__main__":
    sys.exit(self_test() if sys.argv[1] == "--self-test" else main(pathlib.Path(sys.argv[1])))
