#!/usr/bin/env python3
"""Fails when an include runs against the layers of ARCHITECTURE.md.

usage: check_layers.py SOURCE_ROOT | --self-test
"""
import pathlib
import re
import sys

# What each layer may include, beside itself.
MAY_INCLUDE = {
    "filters/core": set(),
    "filters/techniques": {"filters/core"},
    "analysis": {"filters/core"},
    "datasets": {"filters/core"},
    "filters/gpu": {"filters/core"},
    "ui": {"filters/core", "filters/gpu", "filters/techniques", "analysis", "datasets"},
    # The one place where all meet, as a library that is loaded when it is needed.
    "app/display": {"filters/core", "filters/gpu", "filters/techniques", "analysis", "datasets", "ui", "app"},
    # What starts without Qt and OpenGL, and asks the display through its interface.
    "app": {"filters/core", "filters/techniques", "analysis", "datasets", "app/display"},
}
LIBRARIES = {
    "VTK": re.compile(r"^(vtk|QVTK)"),
    "Qt": re.compile(r"^(Q[A-Z]|Qt|qwt)"),
    "OpenGL": re.compile(r"^(GL/|EGL/|vtk_glew)"),
}
# Layers that know no display library at all, and those that know VTK and OpenGL but no Qt.
FORBIDDEN = {
    "filters/core": {"VTK", "Qt", "OpenGL"},
    "filters/techniques": {"VTK", "Qt", "OpenGL"},
    "analysis": {"VTK", "Qt", "OpenGL"},
    "datasets": {"VTK", "Qt", "OpenGL"},
    "filters/gpu": {"Qt"},
    "ui": set(),
    "app/display": set(),
    "app": {"VTK", "Qt", "OpenGL"},
}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^">]+)[">]')


def layer_of(path):
    """The deepest layer whose folder holds `path`: app/display, not app."""
    return max((layer for layer in MAY_INCLUDE if path.startswith(layer + "/")), key=len, default=None)


def problems_in(path, text):
    """Each include of `text`, the file at `path` below the root, that its layer forbids."""
    layer = layer_of(path)
    is_test = path.endswith("Test.cpp")
    for number, line in enumerate(text.splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        included = match.group(2)
        target = layer_of(included)
        # A unit test beside its subject may reach down to anything that has no display.
        allowed = MAY_INCLUDE[layer] | ({"filters/core", "filters/techniques", "analysis", "datasets"} if is_test else set())
        if target and target != layer and target not in allowed:
            yield f"{path}:{number}: {layer} must not include {target} ({included})"
        for library in FORBIDDEN[layer]:
            if LIBRARIES[library].match(included):
                yield f"{path}:{number}: {layer} must not include {library} ({included})"


def check(root):
    problems, files = [], 0
    for layer in MAY_INCLUDE:
        for file in sorted((root / layer).rglob("*")):
            if file.suffix in (".h", ".cpp"):
                if layer_of(str(file.relative_to(root))) != layer:
                    continue
                files += 1
                problems += problems_in(str(file.relative_to(root)), file.read_text())
    for problem in problems:
        print(problem)
    print(f"{files} files, {len(problems)} includes against the layers")
    return 1 if problems or files == 0 else 0


def self_test():
    """The check must see what it is there for."""
    bad = {
        "analysis/A.cpp": '#include <vtkObject.h>',
        "filters/core/B.h": '#include "analysis/Probe.h"',
        "filters/techniques/vsm/C.cpp": '#include <QWidget>',
        "filters/gpu/D.cpp": '#include "filters/techniques/vsm/Vsm.h"',
        "datasets/E.cpp": '  #  include "filters/gpu/ShadowRenderer.h"',
        "ui/F.cpp": '#include "app/display/Display.h"',
        "app/J.cpp": '#include <QApplication>',
        "app/commands/K.cpp": '#include <vtkRenderWindow.h>',
        "app/options/L.h": '#include <vtk_glew.h>',
        "app/commands/M.cpp": '#include "ui/MainWindow.h"',
        "app/N.cpp": '#include <EGL/egl.h>',
        "datasets/O.cpp": '#include "app/display/Display.h"',
    }
    good = {
        "ui/G.cpp": '#include <QWidget>\n#include "filters/gpu/ShadowRenderer.h"',
        "filters/gpu/H.cpp": '#include <vtkActor.h>\n#include "filters/core/Image.h"',
        "app/display/P.cpp": '#include <QApplication>\n#include <vtkRenderWindow.h>\n#include "ui/MainWindow.h"',
        "app/commands/R.cpp": '#include "app/display/Display.h"\n#include "datasets/Session.h"',
        "analysis/I.cpp": '#include <vector>\n#include "filters/core/Region.h"',
    }
    missed = [path for path, text in bad.items() if not list(problems_in(path, text))]
    wrong = [path for path, text in good.items() if list(problems_in(path, text))]
    print(f"missed: {missed}, wrongly reported: {wrong}")
    return 1 if missed or wrong else 0


if __name__ == "__main__":
    sys.exit(self_test() if sys.argv[1] == "--self-test" else check(pathlib.Path(sys.argv[1])))
