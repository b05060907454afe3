#!/usr/bin/env python3
"""How long a job array takes on a cluster, from the times that the meshes of a store took.

The store is what `rectilin measure -o FILE.db` writes: the columns `faces` and `seconds` of its finished rows are the
distribution that times are drawn from, with replacement. With --faces MEDIAN,SPREAD sizes are drawn first, from a
log-normal distribution (SPREAD is the standard deviation of the logarithm to base e), and each takes the time of a
stored mesh of about that size; sizes beyond the store's cost in proportion. Same store, same options, same output.

What is simulated: a shard is a task of the array and runs on one node, with as many workers as the node has cores, each
taking the next mesh. Nodes fail at random moments; the task is requeued, waits, and goes on, on any node, with what its
store does not have: only the meshes in work are done again. A task whose time is over is submitted again. Some tasks
meet a slow node. At the end, one process merges the shards.

Columns: hours from the first task to the merged store, of these the hours of the merge, the efficiency (processor time
of all meshes over that of all cores until the last shard is done), tasks interrupted, meshes begun twice, gigabytes.

Example: simulate.py psb.db --meshes 1e6 --nodes 1 16 256 --faces 5000,1.5
"""
import argparse
import bisect
import heapq
import math
import random
import sqlite3
import sys
from pathlib import Path

DONE = 3  # status of a row, as in corpus/include/rectilin/corpus/store.h
SAMPLES = 100_000  # drawn once; meshes then draw from these
NEIGHBOURS = 16  # stored meshes of about a size that may lend their time


def positive(text):
    value = float(text)
    if not (value > 0 and math.isfinite(value)):
        raise argparse.ArgumentTypeError(f"'{text}' is not a positive number")
    return value


def count(text):
    value = positive(text)
    if value != int(value):
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number")
    return int(value)


def share(text):
    value = float(text)
    if not 0 <= value <= 1:
        raise argparse.ArgumentTypeError(f"'{text}' is not between 0 and 1")
    return value


def sizes(text):
    try:
        median, spread = (positive(part) for part in text.split(','))
    except (ValueError, argparse.ArgumentTypeError):
        raise argparse.ArgumentTypeError(f"'{text}' is not MEDIAN,SPREAD") from None
    return median, spread


def parse():
    title, rest = __doc__.split('\n', 1)
    parser = argparse.ArgumentParser(description=title + '\n' + rest,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    add = parser.add_argument
    add('store', help='FILE.db')
    add('--meshes', type=count, default=1_000_000)
    add('--nodes', type=count, nargs='+', default=[1, 16, 256], help='a line for each')
    add('--cores', type=count, default=16, help='of a node')
    add('--shards', type=count, help='tasks of the array (default: four for each node)')
    add('--faces', type=sizes, metavar='MEDIAN,SPREAD', help='sizes of the meshes (default: as in the store)')
    add('--speed', type=positive, default=1, help='of a core, relative to the one that filled the store')
    add('--hours', type=positive, default=24, help='time limit of a task')
    add('--limit-seconds', type=positive, default=600, help='time limit of a mesh')
    add('--start-seconds', type=positive, default=10, help='from a free node to the first mesh')
    add('--requeue-seconds', type=positive, default=180, help='until a failed node and its task are back')
    add('--days-between-failures', type=positive, default=30, help='of one node')
    add('--slow-share', type=share, default=0.02, help='share of the tasks that meet a slow node')
    add('--slow-factor', type=positive, default=2, help='how much longer everything takes there')
    add('--merge-microseconds', type=positive, default=10, help='for each row')
    add('--together', type=count, default=1, metavar='N',
        help='let workers take N meshes at a time, for fewer steps of the simulation where they are small')
    add('--seed', type=int, default=1)
    options = parser.parse_args()
    if options.together * options.limit_seconds * options.slow_factor >= 3600 * options.hours:
        parser.error('a mesh could take longer than a task may: it would be begun for ever')
    return options


def rows_of(store):
    """(faces, seconds) of all finished rows, sorted, and the bytes that a row takes."""
    database = sqlite3.connect(Path(store).resolve().as_uri() + '?mode=ro', uri=True)
    rows = database.execute('SELECT faces, seconds FROM meshes WHERE status = ? AND seconds > 0 AND faces > 0 '
                            'ORDER BY faces, seconds', (DONE,)).fetchall()
    everything = database.execute('SELECT count(*) FROM meshes').fetchone()[0]
    pages = [database.execute(f'PRAGMA {name}').fetchone()[0] for name in ('page_count', 'page_size')]
    if not rows:
        raise SystemExit(f'{store}: no finished meshes')
    return rows, pages[0] * pages[1] / everything


def sample_times(rows, options, rng):
    if not options.faces:
        return [min(options.limit_seconds, s / options.speed) for s in rng.choices([s for _, s in rows], k=SAMPLES)]
    median, spread = options.faces
    stored = [faces for faces, _ in rows]
    times = []
    for _ in range(SAMPLES):
        faces = median * math.exp(rng.gauss(0, spread))
        first = min(max(0, bisect.bisect(stored, faces) - NEIGHBOURS // 2), max(0, len(rows) - NEIGHBOURS))
        like, seconds = rows[rng.randrange(first, min(len(rows), first + NEIGHBOURS))]
        if faces > stored[-1]:
            seconds *= faces / like
        times.append(min(options.limit_seconds, seconds / options.speed))
    return times


class Task:
    def __init__(self, meshes):
        self.new = meshes  # not begun yet
        self.again = []  # seconds of those that were in work when the task was interrupted

    def run(self, begin, stop, slow, cores, times, rng):
        """Works until all is done or time is `stop`; the moment at which the node is free."""
        running = [(begin, 0.0)] * min(cores, self.new + len(self.again))  # end and seconds of each worker's mesh
        unit, number = rng.random, len(times)
        while (self.new or self.again) and running[0][0] < stop:
            if self.again:
                seconds = self.again.pop()
            else:
                seconds = times[int(unit() * number)]
                self.new -= 1
            heapq.heapreplace(running, (running[0][0] + slow * seconds, seconds))
        self.again += [seconds for end, seconds in running if end > stop]
        return min(stop, max(end for end, _ in running))

    def is_done(self):
        return not self.new and not self.again


def simulate(nodes, times, options):
    """Seconds until the last shard is done, tasks interrupted, meshes begun twice."""
    rng = random.Random(f'{options.seed} {nodes}')
    steps = -(-options.meshes // options.together)
    shards = min(steps, options.shards or 4 * nodes)
    ready = [(0.0, i, Task(steps // shards + (i < steps % shards))) for i in range(shards)]
    failure_rate = 1 / (86400 * options.days_between_failures)
    free = [(0.0, node) for node in range(nodes)]
    failure = [rng.expovariate(failure_rate) for _ in range(nodes)]
    wall, interrupted, twice = 0.0, 0, 0
    while ready:
        since, number, task = heapq.heappop(ready)
        free_at, node = heapq.heappop(free)
        begin = max(since, free_at) + options.start_seconds
        while failure[node] <= begin:  # it failed while it had nothing to do
            failure[node] += rng.expovariate(failure_rate)
        limit = begin + 3600 * options.hours
        slow = options.slow_factor if rng.random() < options.slow_share else 1
        end = task.run(begin, min(limit, failure[node]), slow, options.cores, times, rng)
        if task.is_done():
            wall = max(wall, end)
        else:
            interrupted += 1
            twice += options.together * len(task.again)
            end += options.requeue_seconds if end == failure[node] else 0
            heapq.heappush(ready, (end, number, task))
        heapq.heappush(free, (end, node))
    return wall, interrupted, twice


def main():
    options = parse()
    try:
        rows, row_bytes = rows_of(options.store)
    except sqlite3.Error as error:
        raise SystemExit(f'{options.store}: {error}') from None
    times = sample_times(rows, options, random.Random(options.seed))
    mean = sum(times) / len(times)
    print(f'{options.meshes} meshes of {mean:.4g} s on average (the longest of {SAMPLES}: {max(times):.4g} s): '
          f'{options.meshes * mean / 3600:.2f} hours of one core')
    if options.together > 1:
        rng = random.Random(options.seed)
        times = [sum(rng.choices(times, k=options.together)) for _ in range(SAMPLES)]
    print('nodes  cores     hours     merge  efficiency  interrupted  twice       GB')
    for nodes in options.nodes:
        wall, interrupted, twice = simulate(nodes, times, options)
        merge = options.meshes * options.merge_microseconds * 1e-6
        efficiency = options.meshes * mean / (nodes * options.cores * wall)
        print(f'{nodes:5d} {nodes * options.cores:6d} {(wall + merge) / 3600:9.3f} {merge / 3600:9.3f} '
              f'{100 * efficiency:9.1f} % {interrupted:12d} {twice:6d} {options.meshes * row_bytes / 1e9:8.2f}')


if __name__ == '__main__':
    sys.exit(main())
