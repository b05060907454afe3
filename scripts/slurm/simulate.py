#!/usr/bin/env python3
"""How long a job array takes, from the times that some meshes took.

Usage: simulate.py TABLE.csv --meshes 1e6 --nodes 16 [--cores 32] [--hours 24] ...

TABLE.csv is what `rectilin export` writes; its column `seconds` is the distribution that times are drawn from. Each node
works through shards, one array task after another, with as many workers as it has cores; a worker takes the next mesh of
the shard. A node fails at random moments, as often as --days-between-failures says, and its task is requeued and goes on
after --requeue-seconds; the meshes in work are lost. A task whose time is over (--hours) is submitted again.
"""
import argparse
import csv
import heapq
import random


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('table')
    parser.add_argument('--meshes', type=float, default=1e6)
    parser.add_argument('--nodes', type=int, default=1)
    parser.add_argument('--cores', type=int, default=32)
    parser.add_argument('--shards', type=int, default=0, help='default: four for each node')
    parser.add_argument('--hours', type=float, default=24, help='time limit of a task')
    parser.add_argument('--start-seconds', type=float, default=10, help='from a free node to the first mesh')
    parser.add_argument('--requeue-seconds', type=float, default=180)
    parser.add_argument('--days-between-failures', type=float, default=30, help='of one node')
    parser.add_argument('--seed', type=int, default=1)
    return parser.parse_args()


def shard_seconds(count, times, cores, rng, failures, options):
    """Seconds that a node needs for a shard of `count` meshes, and how often it was interrupted."""
    ends = [0.0] * min(cores, count)  # when each worker is free
    heapq.heapify(ends)
    clock_of_failure = rng.expovariate(failures)
    limit = 3600 * options.hours
    task_began, interruptions, left = 0.0, 0, count
    while left > 0:
        now = heapq.heappop(ends)
        stop = min(clock_of_failure, task_began + limit)
        if now >= stop:  # all that is in work is lost, and done again
            lost = sum(1 for end in ends if end > stop) + (now > stop)
            left += lost
            resume = stop + (options.requeue_seconds if stop == clock_of_failure else options.start_seconds)
            task_began, interruptions = resume, interruptions + 1
            while clock_of_failure <= resume:
                clock_of_failure += rng.expovariate(failures)
            ends = [resume] * min(cores, left)
            heapq.heapify(ends)
            continue
        heapq.heappush(ends, now + rng.choice(times))
        left -= 1
    return max(ends), interruptions


def main():
    options = parse()
    with open(options.table, newline='') as file:
        times = [float(row['seconds']) for row in csv.DictReader(file) if float(row['seconds']) > 0]
    if not times:
        raise SystemExit(options.table + ': no times')
    rng = random.Random(options.seed)
    shards = options.shards or 4 * options.nodes
    failures = 1 / (86400 * options.days_between_failures)
    meshes = int(options.meshes)
    nodes = [0.0] * options.nodes
    heapq.heapify(nodes)
    interruptions = 0
    for shard in range(shards):
        count = sum(1 for _ in range(shard, meshes, shards)) if meshes < 1000 else meshes // shards
        seconds, stops = shard_seconds(count, times, options.cores, rng, failures, options)
        interruptions += stops
        heapq.heappush(nodes, heapq.heappop(nodes) + options.start_seconds + seconds)
    wall = max(nodes)
    ideal = meshes * sum(times) / len(times) / (options.nodes * options.cores)
    print(f'{meshes} meshes, {options.nodes} nodes of {options.cores} cores, {shards} shards: {wall / 3600:.2f} h '
          f'({ideal / 3600:.2f} h if nothing were lost, {100 * ideal / wall:.0f} %), {interruptions} interruptions')


if __name__ == '__main__':
    main()
