"""The certified Manhattan frame of a point cloud with normals: three orthogonal axes that the normals keep to best.

    python3 point_cloud_frame.py room.ply
"""

import sys

import numpy as np

import rectilin

if len(sys.argv) > 1:
    normals, weights = rectilin.read_normals(sys.argv[1])
else:  # a room: walls, floor and ceiling in a frame that is to be found, with noise and with furniture of any direction
    rng = np.random.default_rng(1)
    frame = rectilin.domain("zone").rotation([0.1, -0.2, 0.15])
    walls = np.repeat(frame, 400, axis=0) + rng.normal(scale=0.03, size=(1200, 3))
    normals, weights = np.concatenate([walls, rng.normal(size=(300, 3))]), None

r = rectilin.measure_normals(normals, weights)
print("axes of the frame, as rows:")
print(r.rotation)
print(f"R = {r.rectilinearity:.6f}, and no frame has more than {r.upper:.6f}")
