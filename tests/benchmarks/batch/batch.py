#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reducing a log beside copying it with MRPT's rawlog-edit, as Markdown on stdout."""
import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time

STAGES = ["survey", "unpack", "read", "reduce", "order", "serialise", "cut", "pack", "write"]


def run(command, repeats):
    """[s] wall time, [s] processor time, [MiB] largest resident set: medians of several runs."""
    walls, works, peaks = [], [], []
    for _ in range(repeats):
        begin = time.monotonic()
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        _, status, usage = os.wait4(process.pid, 0)
        walls.append(time.monotonic() - begin)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            sys.exit(f"batch.py: exit code {process.returncode} of: {' '.join(command)}")
        works.append(usage.ru_utime + usage.ru_stime)
        peaks.append(usage.ru_maxrss / 1024)
    return statistics.median(walls), statistics.median(works), statistics.median(peaks)


class Bench:
    def __init__(self, offmap, folder, repeats):
        self.offmap, self.folder, self.repeats = offmap, folder, repeats
        self.out = os.path.join(folder, "out.rawlog")

    def simulated(self, name, *options):
        folder = os.path.join(self.folder, name)
        subprocess.run([self.offmap, "simulate", "office_room", "-o", folder, "--quiet", *options], check=True)
        os.remove(os.path.join(folder, "truth.csv.gz"))
        return folder

    def reduce(self, log, threads, *more, repeats=None):
        command = [self.offmap, "reduce", f"{log}/scans.rawlog", "--map", f"{log}/map.lines", "-o", self.out,
                   "--force", "--quiet", "--compression", "1", "--threads", str(threads), *more]
        return run(command, repeats or self.repeats)

    def copy(self, log):
        return run(["rawlog-edit", "--keep-label", ",LIDAR,LOCALIZATION", "-w", "-q",
                    "-i", f"{log}/scans.rawlog", "-o", self.out], self.repeats)

    def size(self):
        return os.path.getsize(self.out) / 1e6

    def compare(self, title, log):
        wall, work, peak = copy = self.copy(log)
        print(f"| {title} | `rawlog-edit` | {wall:.2f} | 1 | {work:.2f} | {peak:.0f} | {self.size():.0f} |")
        for threads in (1, 2):
            wall, work, peak = self.reduce(log, threads)
            print(f"| | `offmap`, {threads} thread{'s'[:threads - 1]} | {wall:.2f} | {wall / copy[0]:.2f} "
                  f"| {work:.2f} | {peak:.0f} | {self.size():.0f} |", flush=True)

    def profile(self, title, log):
        report = os.path.join(self.folder, "report.json")
        _, work, _ = self.reduce(log, 1, "--report", report, repeats=1)
        with open(report, encoding="utf-8") as file:
            stages = json.load(file)["stage_seconds"]
        shares = " | ".join(f"{stages[stage]:.2f}" for stage in STAGES)
        print(f"| {title} | {shares} | {work - sum(stages.values()):.2f} | {work:.2f} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("offmap", help="the program")
    parser.add_argument("--repeats", type=int, default=5, help="of each measurement (5)")
    parser.add_argument("--share", type=float, default=1, help="of the logs' length (1)")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="offmap-batch-") as folder:
        bench = Bench(arguments.offmap, folder, arguments.repeats)
        turns = [max(round(n * arguments.share), 1) for n in (300, 1000, 3000)]
        vlp16 = [bench.simulated(f"vlp16-{n}", "--class", "velodyne", "--scanner", "vlp16", "--scans", str(n))
                 for n in turns]
        dense = bench.simulated("dense", "--scanner", "dense", "--scans", str(turns[0]))
        names = [f"{turns[1]} VLP-16 turns", f"{turns[0]} clouds of 262,144"]

        print(f"Load average {os.getloadavg()[0]:.1f} before, medians of {arguments.repeats} runs.\n")
        print("| log | program | wall [s] | of the copy | processors [s] | peak [MiB] | written [MB] |")
        print("|---|---|--:|--:|--:|--:|--:|")
        for name, log in zip(names, (vlp16[1], dense)):
            bench.compare(name, log)
        print("\n| [s] of processors, 1 thread | " + " | ".join(STAGES) + " | before and after | in all |")
        print("|---|" + "--:|" * (len(STAGES) + 2))
        for name, log in zip(names, (vlp16[1], dense)):
            bench.profile(name, log)
        print("\n| VLP-16 turns | " + " | ".join(f"{n:,}" for n in turns) + " |")
        print("|---|" + "--:|" * len(turns))
        for threads in (1, 2):
            peaks = [bench.reduce(log, threads, repeats=1)[2] for log in vlp16]
            print(f"| peak [MiB], {threads} thread{'s'[:threads - 1]} | " + " | ".join(f"{p:.0f}" for p in peaks) + " |")
        print(f"\nLoad average {os.getloadavg()[0]:.1f} after.")


main()
