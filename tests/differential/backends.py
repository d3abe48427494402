"""The same random scenes through two built libraries, as with SuiteSparse and with Eigen's factorizations: both must break the
same bonds at the same loads.

    backends.py LIBRARY OTHER_LIBRARY [--first SEED] [--count N]

A process loads one library only, so each runs in a process of its own. Prints one line for every scene that differs and a
summary; exits with 1 if any does."""

from __future__ import annotations

import argparse
import os
import pickle
import subprocess
import sys
from typing import Any, Iterator


def outcomes(library: str, first: int, count: int) -> "subprocess.Popen[bytes]":
    environment = {**os.environ, "BEMPD_LIBRARY": os.path.abspath(library)}
    command = [sys.executable, __file__, "--child", "--first", str(first), "--count", str(count)]
    return subprocess.Popen(command, env=environment, stdout=subprocess.PIPE)


def run_child(first: int, count: int) -> None:
    import random_scenes
    for seed in range(first, first + count):
        outcome = random_scenes.run(seed, ("window", "plain")[seed % 2])
        pickle.dump((seed, outcome), sys.stdout.buffer)
    sys.stdout.buffer.flush()


def read(process: "subprocess.Popen[bytes]", count: int) -> Iterator[Any]:
    assert process.stdout is not None
    for _ in range(count):
        yield pickle.load(process.stdout)


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("libraries", nargs="*")
    parser.add_argument("--child", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--count", type=int, default=200)
    arguments = parser.parse_args()
    if arguments.child:
        run_child(arguments.first, arguments.count)
        return 0
    if len(arguments.libraries) != 2:
        parser.error("two libraries are needed")
    import random_scenes
    processes = [outcomes(library, arguments.first, arguments.count) for library in arguments.libraries]
    failed = events = 0
    for (seed, one), (_, other) in zip(*(read(process, arguments.count) for process in processes)):
        finding = random_scenes.difference(one, other)
        events += len(one.reports)
        failed += 1 if finding else 0
        if finding:
            print(f"scene {seed}: {finding} (the second library stands for windows)", flush=True)
    if any(process.wait() for process in processes):
        print("a process that ran the scenes failed")
        return 1
    print(f"{arguments.count} scenes by two libraries, {events} events compared, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
