#!/usr/bin/env python3
"""A sweep of 200 cells gives the same table, bit for bit, from one process, from one that is killed at
random moments and started again, and through Snakemake on local cores, with a job that is killed.

Exits 77, so that this was not tested, where there is no snakemake.

usage: snakemake.py UMBRASCOPE
"""
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

PLAN = {
    "format": "umbrascope-sweep/1",
    "base": {"source": {"scene": "two-planes"}, "size": [96, 64], "frame": {"mapSize": 64}},
    "axes": [
        {"setting": "technique", "values": ["vsm", "esm", "lvsm", "msm", "evsm4"]},
        {"setting": "kernel.radius", "range": [0, 9, 10]},
        {"setting": "kernel.shape", "values": ["box", "gaussian"]},
        {"setting": "map.format", "values": ["half", "float"]},
    ],
}


def table(folder):
    return [(folder / name).read_bytes() for name in ("cells.csv", "cells.jsonl")]


def killed_and_resumed(program, plan, folder):
    """Ends the process at random moments until it has finished by itself."""
    random.seed(3)
    kills = 0
    while True:
        process = subprocess.Popen((program, "sweep", plan, "-o", folder), stderr=subprocess.DEVNULL)
        try:
            process.wait(random.uniform(0.3, 1.5))
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
            kills += 1
            continue
        return process.returncode, kills


def kill_a_job(plan):
    """Ends one process that measures a batch of the plan; false where there is none."""
    for process in pathlib.Path("/proc").iterdir():
        try:
            words = (process / "cmdline").read_bytes().split(b"\0")
        except OSError:
            continue
        if words[1:2] == [b"sweep"] and str(plan).encode() in words and b"--cells" in words:
            os.kill(int(process.name), signal.SIGKILL)
            return True
    return False


def main(program):
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        plan = root / "plan.json"
        plan.write_text(json.dumps(PLAN))
        subprocess.run((program, "sweep", plan, "-o", root / "whole"), check=True)
        whole = table(root / "whole")
        assert whole[1].count(b"\n") == 200, whole[1].count(b"\n")
        status, kills = killed_and_resumed(program, plan, root / "killed")
        assert status == 0 and kills > 0, (status, kills)
        assert table(root / "killed") == whole, "a killed run gives another table"
        print(f"{kills} kills, the same table")
        if not shutil.which("snakemake"):
            print("snakemake is not there")
            return 77
        flow = root / "flow"
        subprocess.run((program, "sweep", plan, "--snakemake", flow, "--batch", "25"), check=True)
        command = ("snakemake", "--cores", "2", "--keep-going", "--quiet", "all")
        first = subprocess.Popen(command, cwd=flow, stderr=subprocess.DEVNULL)
        while not kill_a_job(plan):
            assert first.poll() is None, "snakemake ended before a job could be killed"
            time.sleep(0.02)
        assert first.wait() != 0, "the killed job was not noticed"
        results = next(flow.glob("results-*"))
        before = {part: part.stat().st_mtime_ns for part in results.glob("cells-*.jsonl")}
        assert 0 < len(before) < 8, before
        subprocess.run(command, cwd=flow, check=True)
        assert table(results) == whole, "Snakemake gives another table"
        after = {part: part.stat().st_mtime_ns for part in before}
        assert after == before, "a batch that was done was done again"
        print("the same table through Snakemake")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
