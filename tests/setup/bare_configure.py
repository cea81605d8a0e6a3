#!/usr/bin/env python3
"""Configures what `run` does, as on a machine that has the [build] packages and no other.

This machine has more: what the tests need, and whatever its owner installed. Each of those packages
is taken away in a view of /usr that this process alone has (an overlay in a mount namespace), and
/usr/local is empty there. Needs root; without it the exit status is 77, which CTest calls skipped.

usage: bare_configure.py SOURCE_ROOT [--without PACKAGE]
  --without  also hides PACKAGE, one of [build], and succeeds where configuring then fails: proof
             that what is hidden cannot be found.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77


def section(root, wanted):
    """The packages of one section of the list."""
    packages, current = [], ""
    for line in (root / "cmake/debian-packages.txt").read_text().splitlines():
        if line.startswith("["):
            current = line.strip("[]")
        elif line and not line.startswith("#") and current == wanted:
            packages.append(line)
    return packages


def installed():
    """Each installed package with the names it answers to, those it needs, and its priority."""
    output = subprocess.check_output(
        ["dpkg-query", "-W", "-f", "${db:Status-Status}\t${Package}\t${Essential}\t${Priority}\t"
         "${Provides}\t${Pre-Depends}\t${Depends}\n"], text=True)
    packages = {}
    for line in output.splitlines():
        status, name, essential, priority, provides, before, needs = line.split("\t")
        if status != "installed":
            continue
        packages[name] = {
            "base": essential == "yes" or priority in ("required", "important"),
            "provides": [word(p) for p in provides.split(",") if p.strip()],
            # Any of several that would do may be the one that is there.
            "needs": [word(one) for part in (before, needs) for each in part.split(",")
                      for one in each.split("|") if one.strip()],
        }
    return packages


def word(relation):
    """'libfoo:any (>= 1)' is libfoo."""
    return relation.split("(")[0].strip().split(":")[0]


def reachable(packages, start):
    """What `start` and all that they need are, as names of installed packages."""
    providers = {}
    for name, package in packages.items():
        for answer in [name, *package["provides"]]:
            providers.setdefault(answer, []).append(name)
    seen, queue = set(), [name for wanted in start for name in providers.get(wanted, [])]
    while queue:
        name = queue.pop()
        if name not in seen:
            seen.add(name)
            queue += [each for need in packages[name]["needs"] for each in providers.get(need, [])]
    return seen


def files_of(packages):
    """The files below /usr that these packages own."""
    if not packages:
        return set()
    listed = subprocess.run(["dpkg", "-L", *sorted(packages)], capture_output=True, text=True).stdout
    # Debian 12 still knows some files by their place before /lib moved below /usr.
    return {"/usr" + line if line.startswith(("/lib", "/bin", "/sbin")) else line
            for line in listed.splitlines() if line.startswith(("/usr/", "/lib", "/bin", "/sbin"))}


def hide(files, scratch):
    """Lays a view of /usr over it and removes the files there; the machine keeps them."""
    upper, work = scratch / "upper", scratch / "work"
    upper.mkdir()
    work.mkdir()
    mount("-t", "overlay", "overlay", "-o", f"lowerdir=/usr,upperdir={upper},workdir={work}", "/usr")
    mount("-t", "tmpfs", "tmpfs", "/usr/local")
    folders = set()
    for file in files:
        if os.path.isdir(file) and not os.path.islink(file):
            folders.add(file)
        elif os.path.lexists(file):
            os.unlink(file)
    for folder in sorted(folders, key=len, reverse=True):
        if os.path.isdir(folder) and not os.path.ismount(folder) and not os.listdir(folder):
            os.rmdir(folder)


def mount(*arguments):
    subprocess.run(["mount", *arguments], check=True)


def configure(root, scratch):
    """What `run` does before it builds, with a build folder of its own."""
    build = scratch / "build"
    build.mkdir()
    (root / "build").mkdir(exist_ok=True)
    mount("--bind", str(build), str(root / "build"))
    environment = {"PATH": "/usr/bin:/bin:/usr/sbin:/sbin", "HOME": str(scratch), "LC_ALL": "C.UTF-8"}
    return subprocess.run(["bash", "-c", ". cmake/setup.sh && configure"], cwd=root, env=environment,
                          capture_output=True, text=True)


def main(root, without):
    if os.geteuid() != 0:
        print("skipped: hiding packages needs root; CI has it, and so has `sudo ./test -R setup`")
        return SKIPPED
    packages = installed()
    kept = reachable(packages, [name for name, package in packages.items() if package["base"]])
    kept |= reachable(packages, section(root, "build"))
    hidden = set(packages) - kept
    if without:
        hidden |= {without}
    files = files_of(hidden) - files_of(set(packages) - hidden)
    mount("--make-rprivate", "/")
    scratch = pathlib.Path(tempfile.mkdtemp(prefix="umbra-bare-"))
    try:
        hide(files, scratch)
        result = configure(root, scratch)
    finally:
        subprocess.run(["umount", str(root / "build")])
        subprocess.run(["umount", "--lazy", "/usr/local", "/usr"])
        shutil.rmtree(scratch, ignore_errors=True)
    print(f"{len(hidden)} packages and {len(files)} files hidden; configuring "
          f"{'succeeded' if result.returncode == 0 else 'failed'}")
    if without:
        return 0 if result.returncode != 0 else 1
    if result.returncode != 0:
        print(result.stdout + result.stderr)
    return result.returncode


if __name__ == "__main__":
    root = pathlib.Path(sys.argv[1]).resolve()
    # A process of its own has the view; Python 3.11 cannot ask for one by itself.
    if os.geteuid() == 0 and "UMBRA_BARE_VIEW" not in os.environ:
        os.environ["UMBRA_BARE_VIEW"] = "1"
        os.execvp("unshare", ["unshare", "--mount", sys.executable, *sys.argv])
    sys.exit(main(root, sys.argv[3] if "--without" in sys.argv else None))
