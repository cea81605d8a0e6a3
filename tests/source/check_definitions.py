#!/usr/bin/env python3
"""Fails when a type or a function of one qualified name is defined in more than one file. C++'s
one-definition rule forbids it across a program, and no compiler or linker has to say so; to a
reader one name for two things is a trap in any case.

usage: check_definitions.py SOURCE_ROOT | --self-test
"""
import collections
import pathlib
import re
import sys

FOLDERS = ("app", "filters", "analysis", "ui", "datasets", "tests")
SUFFIXES = (".h", ".cpp")
# What says nothing about names: comments, strings, characters, raw strings, lines for the
# preprocessor.
SILENT = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<end>[^()\s]*)\(.*?\)(?P=end)"|"(?:\\.|[^"\\\n])*"'
    r"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'|^[ \t]*#(?:\\\n|[^\n])*", re.S | re.M)
NAMESPACE = re.compile(r"(?:inline\s+)?namespace\s*([\w:]*)\s*$")
TYPE = re.compile(r"\b(?:class|struct|union|enum(?:\s+class|\s+struct)?)\s+(?:\[\[.*?\]\]\s*)*([\w:]+)\s*"
                  r"(?:final\s*)?(?::(?!:)[^;{}]*)?$", re.S)
# The head of a function: its name, its parameters and what may follow them.
FUNCTION = re.compile(r"(?P<before>[\w:<>,&*\s\[\]]+?[\s&*])(?P<name>[A-Za-z_]\w*|operator\s*[^\s\w(]+)\s*"
                      r"\((?P<parameters>[^{};]*)\)\s*(?:const|noexcept|->[\w:<>,&*\s]+|\s)*$", re.S)


def types_of(parameters):
    """The types of `parameters` without names, defaults and spaces: those that tell overloads apart."""
    depth, parts, part = 0, [], ""
    for c in parameters:
        depth += (c in "(<[{") - (c in ")>]}")
        if c == "," and depth == 0:
            parts.append(part)
            part = ""
        else:
            part += c
    parts.append(part)
    types = []
    for text in parts:
        text = " ".join(text.split("=")[0].split())
        named = re.match(r"(.*[\w>&*])[\s&*]*\b(?<!::)[a-z]\w*$", text)
        bare = text if not named or text in ("int", "double", "float", "bool", "char") else text[:text.rindex(
            re.search(r"\w+$", text).group())]
        types.append(re.sub(r"\s+", "", bare))
    return ",".join(types)


def definitions(text):
    """The qualified names that `text` defines outside unnamed namespaces: types as "umbra::Probe",
    functions with the types of their parameters. Members count with their class, functions that
    only their file sees (static) not at all."""
    text = SILENT.sub(lambda match: " " if match.group()[0] != '"' else '""', text)
    scopes = []  # of each open brace: the name that it adds, "" for none, None where nothing counts
    head = ""
    for c in text:
        if c == "{":
            namespace, type_, function = NAMESPACE.search(head), TYPE.search(head), FUNCTION.match(head)
            names = [scope for scope in scopes if scope]
            if None in scopes or head.count("(") != head.count(")"):  # within a function, or a default argument
                scopes.append(None)
            elif namespace:
                scopes.append(namespace.group(1) or None)
            elif type_ and not re.search(r"\btemplate\s*<\s*>", head):
                yield "::".join(names + [type_.group(1)])
                scopes.append(type_.group(1) + "<type>")
            else:
                member = any(scope.endswith("<type>") for scope in names)
                if function and names and not member and not re.search(r"\bstatic\b", head):
                    yield "::".join(names + [function.group("name")]) + f"({types_of(function.group('parameters'))})"
                scopes.append(None)
            head = ""
        elif c == "}":
            if scopes:
                scopes.pop()
            head = ""
        elif c == ";":
            head = ""
        else:
            head += c


def files_by_name(sources):
    """The files that define each name in `sources`, the text of each file by its path below the root."""
    files = collections.defaultdict(set)
    for path, text in sources.items():
        for name in definitions(text):
            files[name.replace("<type>", "")].add(path)
    return files


def problems_in(files):
    """What is defined twice, by files_by_name."""
    for name, paths in sorted(files.items()):
        if len(paths) > 1:
            yield f"{name} is defined in {len(paths)} files: {', '.join(sorted(paths))}"


def main(root):
    sources = {str(f.relative_to(root)): f.read_text() for folder in FOLDERS
               for f in sorted((root / folder).rglob("*")) if f.suffix in SUFFIXES}
    files = files_by_name(sources)
    problems = list(problems_in(files))
    for problem in problems:
        print(problem)
    print(f"{len(files)} names in {len(sources)} files, {len(problems)} problems")
    return 1 if problems or not files else 0


def self_test():
    """The check must see what it is there for."""
    wrap = "namespace umbra {{\n{}\n}}  // namespace umbra\n".format
    bad = [
        {"ui/A.h": wrap("struct Report {\n  int a;\n};"), "app/A.h": wrap("class Report final : public Base<int> {\n};")},
        {"ui/A.h": wrap("enum class Kind { A, B };"), "app/B.cpp": wrap("struct Kind {};")},
        {"a/A.cpp": wrap("int f(const Probe& probe, int n = 3) {\n  return 1;\n}"),
         "b/A.cpp": wrap('std::string g() { return "{"; }\nint f(const Probe& p, int) { return 2; }')},
        {"a/A.cpp": wrap("namespace plot {\nstruct S {};\n}"), "b/A.cpp": "namespace umbra::plot {\nstruct S {};\n}"},
        {"a/A.h": wrap("struct Outer {\n  struct Inner {\n  };\n};"), "b/A.h": wrap("struct Outer {\n  int x;\n};")},
        {"a/A.h": wrap("inline std::vector<int> h(std::pair<int, int> p) {\n}"),
         "b/A.h": wrap("std::vector<int> h(std::pair<int, int> other) noexcept {\n}")},
        {"a/A.h": wrap("const Value* find(const Map& map, std::string_view id) {\n}"),
         "b/A.h": wrap("const Value*\nfind(const Map& all, std::string_view name) {\n}")},
    ]
    good = [
        {"a/A.cpp": wrap("namespace {\nstruct Local {};\nint f() { return 1; }\n}"),
         "b/A.cpp": wrap("namespace {\nstruct Local {};\nint f() { return 2; }\n}")},
        {"a/A.h": wrap("struct S;\nint f(int a);"), "b/A.h": wrap("struct S {};"), "b/A.cpp": wrap("int f(int a) {\n  return a;\n}")},
        {"a/A.cpp": wrap("double f(int a) {\n  return a;\n}"), "b/A.cpp": wrap("double f(double a) {\n  return a;\n}")},
        {"a/A.cpp": wrap("void A::run() {\n}"), "b/A.cpp": wrap("void B::run() {\n}")},
        {"a/A.h": wrap("struct A {\n  void run() {}\n  struct Part {};\n};"), "b/A.h": wrap("struct B {\n  void run() {}\n  struct Part {};\n};")},
        {"a/A.cpp": wrap("static int f() {\n  return 1;\n}"), "b/A.cpp": wrap("// struct S {\nint f() {\n  return 1;\n}")},
        {"a/A.cpp": wrap('const char* text = "struct S {";\nchar c = \'{\';'), "b/A.cpp": wrap("struct S {};\n#define S struct S {\n")},
        {"a/A.h": wrap("int f(const Run& run = [](int) {});"), "a/A.cpp": wrap("int f(const Run& run) {\n}")},
        {"a/A.cpp": wrap("A::A(int n) : Base(n), n_(n) {\n}"), "b/A.cpp": wrap("B::B(int n) : Base(n), n_(n) {\n}")},
        {"a/A.cpp": "int main() {\n}", "b/A.cpp": "int main() {\n}"},
    ]
    missed = [i for i, sources in enumerate(bad) if not list(problems_in(files_by_name(sources)))]
    wrong = [i for i, sources in enumerate(good) if list(problems_in(files_by_name(sources)))]
    print(f"missed: {missed}, wrongly reported: {wrong}")
    return 1 if missed or wrong else 0


if __name__ == "__main__":
    sys.exit(self_test() if sys.argv[1] == "--self-test" else main(pathlib.Path(sys.argv[1])))
