# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Reads and writes the PLY files of deburr: binary, little endian, triangles."""
import numpy as np

TYPES = {"char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4",
         "float": "f4", "double": "f8"}


def read(path):
    """The fields of the points as records, and the triangles, an empty array if none."""
    with open(path, "rb") as file:
        data = file.read()
    at = data.index(b"end_header\n") + len(b"end_header\n")
    lines = data[:at].decode().splitlines()
    if "format binary_little_endian 1.0" not in lines:
        raise ValueError(f"{path}: not a binary little-endian PLY file")
    elements = []
    for words in map(str.split, lines):
        if words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property" and words[1] != "list":
            elements[-1][2].append((words[2], "<" + TYPES[words[1]]))
        elif words[0] == "property":
            elements[-1][2].append((words[4], [("n", "u1"), ("v", "<i4", 3)]))
    found = {}
    for name, count, properties in elements:
        row = np.dtype(properties)
        found[name] = np.frombuffer(data, row, count, at)
        at += count * row.itemsize
    triangles = found["face"]["vertex_indices"]["v"] if "face" in found else np.zeros((0, 3), int)
    return found["vertex"], triangles


def vectors(vertex, names=("x", "y", "z")):
    """Fields of the points as the columns of an array of doubles."""
    return np.stack([vertex[name].astype(float) for name in names], axis=1)


def write_points(path, points):
    """Writes positions as doubles."""
    header = ("ply\nformat binary_little_endian 1.0\n"
              f"element vertex {len(points)}\n"
              "property double x\nproperty double y\nproperty double z\nend_header\n")
    with open(path, "wb") as file:
        file.write(header.encode())
        file.write(np.ascontiguousarray(points, "<f8").tobytes())
