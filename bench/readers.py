"""What the readers cost against those of another build: processor time and peak memory of reading large files, as ratios.

    python3 bench/readers.py OTHER/rectilin build/rectilin [FACES]

Each file is converted to binary PLY by both commands, in turn, so that what else the machine does disturbs both; the
least of each counts. Reading is most of it.
"""

import os
import pathlib
import subprocess
import sys
import tempfile


def cost(command, source, target):
    """Seconds of processor time, and bytes at most."""
    process = subprocess.Popen([command, "convert", source, target], stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    assert process.returncode == 0, (command, source)
    return usage.ru_utime + usage.ru_stime, 1024 * usage.ru_maxrss


def main():
    before, now = sys.argv[1:3]
    faces = sys.argv[3] if len(sys.argv) > 3 else "400000"
    print(f"{'file':14} {'MB':>6} {'s before':>9} {'s now':>9} {'time':>6} {'memory':>7}")
    with tempfile.TemporaryDirectory() as folder:
        target = pathlib.Path(folder, "out.ply")
        for name, text in [("mesh.off", False), ("mesh.obj", False), ("mesh.ply", False), ("mesh.stl", False),
                           ("text.ply", True), ("text.stl", True)]:
            file = pathlib.Path(folder, name)
            subprocess.run([now, "convert", *(["--text"] if text else []), f"shape:blob?faces={faces}", file], check=True)
            rounds = [(cost(before, file, target), cost(now, file, target)) for _ in range(7)]
            (old_time, old_memory), (new_time, new_memory) = (
                tuple(min(run[side][k] for run in rounds) for k in range(2)) for side in range(2))
            print(f"{name:14} {file.stat().st_size / 1e6:6.1f} {old_time:9.3f} {new_time:9.3f} "
                  f"{new_time / old_time:6.2f} {new_memory / old_memory:7.2f}")


main()
