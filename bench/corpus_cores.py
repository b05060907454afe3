#!/usr/bin/env python3
"""How well two workers use two cores, on a machine that others use, too.

Usage: corpus_cores.py RECTILIN [--meshes 10000] [--faces 500] [--parts 10]

The meshes are done part by part, into stores. Each part is done by one worker and by two, and beside these runs stands a
plain loop in two processes, which gets what the machine can give in that minute. Processor time over wall-clock time of
the workers is compared with that of the loops before and after.
"""
import argparse
import multiprocessing
import os
import subprocess
import tempfile
import time
from pathlib import Path


def spin(seconds):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        sum(range(10_000))


def plain_loops(seconds):
    loops = [multiprocessing.Process(target=spin, args=(seconds,)) for _ in range(2)]
    for loop in loops:
        loop.start()
    for loop in loops:
        loop.join()


def clocked(action):
    """Wall-clock seconds and processor seconds of the processes that the action starts and waits for."""
    wall, before = time.monotonic(), os.times()
    action()
    after = os.times()
    return (time.monotonic() - wall,
            after.children_user + after.children_system - before.children_user - before.children_system)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('rectilin')
    parser.add_argument('--meshes', type=int, default=10_000)
    parser.add_argument('--faces', type=int, default=500)
    parser.add_argument('--parts', type=int, default=10)
    options = parser.parse_args()
    totals = {name: [0.0, 0.0] for name in ('loops', 1, 2)}
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        meshes = folder / 'list.txt'
        meshes.write_text(''.join(f'shape:blob?faces={options.faces}&seed={i}\n' for i in range(options.meshes)))
        for part in range(options.parts):
            for name in ('loops', 2, 'loops', 1):
                if name == 'loops':
                    times = clocked(lambda: plain_loops(2))
                else:
                    command = [options.rectilin, 'measure', meshes, '-o', folder / f'{name}.db', '--threads', str(name),
                               '--shard', f'{part}/{options.parts}']
                    times = clocked(lambda: subprocess.run(command, check=True, capture_output=True))
                for i in range(2):
                    totals[name][i] += times[i]
    for name, label in (('loops', 'plain loop in two processes'), (1, 'one worker'), (2, 'two workers')):
        wall, cpu = totals[name]
        rate = '' if name == 'loops' else \
            f', {options.meshes / wall:.0f} meshes a second, {1e3 * cpu / options.meshes:.3f} ms of processor time each'
        print(f'{label}: {cpu / wall:.3f} cores{rate}')
    used = [totals[name][1] / totals[name][0] for name in (2, 'loops')]
    print(f'two workers use {100 * used[0] / used[1]:.1f} % of what plain loops get')


if __name__ == '__main__':
    main()
