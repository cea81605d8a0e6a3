#!/usr/bin/env python3
"""Fails when an include runs against the layers and rooms of ARCHITECTURE.md.

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
# The rooms of a layer: each may include itself and those before it.
ROOMS = {
    "filters/core": ["support", "scene", "settings", "maps", "technique", "prefilter", "frame"],
    "analysis": ["stored", "probe", "frame", "errors", "cost", "rays", "surfaces", "plots"],
    "datasets": ["json", "meshes", "maps", "scenes", "session", "session/file", "plans", "lessons", "figures"],
    "ui": ["plots", "widgets/base", "widgets/forms", "widgets/maps", "widgets/plots", "widgets/tables",
           "session", "picture", "probe", "panes", "errors", "layers", "lessons", "window/files",
           "window/docks", "window/menus", "window"],
    "app": ["output", "reports", "options", "frames", "bench", "sweep", "lessons", "reproduce", "commands", "start"],
}
# A room that may include more than its layer may: the plots of one technique's mathematics use that
# mathematics.
ROOM_MAY_INCLUDE = {"analysis/plots": {"filters/techniques"}}
LIBRARIES = {
    "VTK": re.compile(r"^(vtk|QVTK)"),
    "Qt": re.compile(r"^(Q[A-Z]|Qt|qwt)"),
    "OpenGL": re.compile(r"^(GL/|EGL/|vtk_gl(ew|ad)|filters/gpu/gl/OpenGL)"),
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
# VTK 9.4 brings another header of OpenGL's functions than VTK before it: one file chooses.
FUNCTIONS = re.compile(r"^vtk_gl(ew|ad)")
CHOOSES_FUNCTIONS = "filters/gpu/gl/OpenGL.h"
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^">]+)[">]')


def layer_of(path):
    """The deepest layer whose folder holds `path`: app/display, not app."""
    return max((layer for layer in MAY_INCLUDE if path.startswith(layer + "/")), key=len, default=None)


def room_of(path):
    """The room that holds `path`, and its place in its layer; None where the layer has no rooms."""
    layer, folder = layer_of(path), path.rpartition("/")[0]
    if layer not in ROOMS:
        return None
    room = folder[len(layer) + 1:]
    return room, ROOMS[layer].index(room) if room in ROOMS[layer] else None


def problems_in(path, text):
    """Each include of `text`, the file at `path` below the root, that its layer or room forbids."""
    layer, room = layer_of(path), room_of(path)
    is_test = path.endswith("Test.cpp")
    if room and room[1] is None:
        yield f"{path}: lies in no room of {layer}; its rooms are {', '.join(ROOMS[layer])}"
        return
    for number, line in enumerate(text.splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        included = match.group(2)
        target = layer_of(included)
        # A unit test beside its subject may reach down to anything that has no display.
        allowed = MAY_INCLUDE[layer] | ROOM_MAY_INCLUDE.get(path.rpartition("/")[0], set())
        if is_test:
            allowed = allowed | {"filters/core", "filters/techniques", "analysis", "datasets"}
        if target and target != layer and target not in allowed:
            yield f"{path}:{number}: {layer} must not include {target} ({included})"
        below = room_of(included) if target == layer and not is_test else None
        if room and below and (below[1] is None or below[1] > room[1]):
            yield f"{path}:{number}: the room {room[0]} must not include {below[0]} ({included})"
        if FUNCTIONS.match(included) and path != CHOOSES_FUNCTIONS:
            yield f"{path}:{number}: only {CHOOSES_FUNCTIONS} may include {included}"
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
        "analysis/probe/A.cpp": '#include <vtkObject.h>',
        "filters/core/support/B.h": '#include "analysis/probe/Probe.h"',
        "filters/techniques/vsm/C.cpp": '#include <QWidget>',
        "filters/gpu/D.cpp": '#include "filters/techniques/vsm/Vsm.h"',
        "filters/gpu/W.cpp": '#include <vtk_glew.h>',
        "datasets/maps/E.cpp": '  #  include "filters/gpu/ShadowRenderer.h"',
        "ui/window/F.cpp": '#include "app/display/Display.h"',
        "app/start/J.cpp": '#include <QApplication>',
        "app/commands/K.cpp": '#include <vtkRenderWindow.h>',
        "app/options/L.h": '#include <vtk_glew.h>',
        "app/commands/M.cpp": '#include "ui/window/MainWindow.h"',
        "app/start/N.cpp": '#include <EGL/egl.h>',
        "datasets/session/O.cpp": '#include "app/display/Display.h"',
        "ui/picture/S.cpp": '#include "ui/probe/Prober.h"',
        "analysis/T.cpp": '#include "analysis/probe/Probe.h"',
        "filters/core/maps/U.h": '#include "filters/core/technique/Technique.h"',
        "analysis/errors/W.cpp": '#include "filters/techniques/csm/FourierSeries.h"',
    }
    good = {
        "ui/picture/G.cpp": '#include <QWidget>\n#include "filters/gpu/ShadowRenderer.h"',
        "filters/gpu/H.cpp": '#include <vtkActor.h>\n#include "filters/core/maps/Image.h"',
        "app/display/P.cpp": '#include <QApplication>\n#include <vtkRenderWindow.h>\n#include "ui/window/MainWindow.h"',
        "app/commands/R.cpp": '#include "app/display/Display.h"\n#include "datasets/session/Session.h"',
        "ui/probe/V.cpp": '#include "ui/picture/SceneView.h"',
        "analysis/errors/ITest.cpp": '#include "analysis/plots/PlanesForm.h"',
        "analysis/plots/X.cpp": '#include "filters/techniques/csm/FourierSeries.h"',
        "analysis/errors/I.cpp": '#include <vector>\n#include "filters/core/maps/Region.h"',
    }
    missed = [path for path, text in bad.items() if not list(problems_in(path, text))]
    wrong = [path for path, text in good.items() if list(problems_in(path, text))]
    print(f"missed: {missed}, wrongly reported: {wrong}")
    return 1 if missed or wrong else 0


if __name__ == "__main__":
    sys.exit(self_test() if sys.argv[1] == "--self-test" else check(pathlib.Path(sys.argv[1])))
