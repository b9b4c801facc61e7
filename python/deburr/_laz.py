# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""LAZ and COPC: what is inside is LAS, which the C++ side reads and writes."""

from __future__ import annotations

import copy
import struct
import tempfile
from pathlib import Path
from typing import Any

from . import _copc, _core, _las_modern, _laz_codec
from ._atomic import whole_file
from ._errors import DeburrIOError
from .cloud import PointCloud
from .result import Result

_MAGIC = b"LASF"
#: Where a LAS header has its point format, whose highest bit tells that points are packed.
_FORMAT_AT = 104
_PACKED = 0x80


def is_compressed(path: Path) -> bool:
    """Whether a file is LAZ (or COPC, which is LAZ too) by its content."""
    try:
        with path.open("rb") as file:
            head = file.read(_FORMAT_AT + 1)
    except OSError:
        return False  # the C++ side says what is wrong
    return head[:4] == _MAGIC and len(head) > _FORMAT_AT and bool(head[_FORMAT_AT] & _PACKED)


def read(path: Path) -> PointCloud:
    """Read a LAZ or COPC file."""
    lazrs = _import_lazrs(path)
    with tempfile.TemporaryDirectory(prefix="deburr-") as folder:
        plain = Path(folder, "cloud.las")
        try:
            with path.open("rb") as packed, plain.open("wb") as file:
                _laz_codec.unpack(packed, file)
        except (lazrs.LazrsError, struct.error, ValueError, OSError) as error:
            raise DeburrIOError(f"{path}: {error}") from error
        return _read_plain(plain)


def write(path: Path, cloud: PointCloud) -> list[str]:
    """Write a LAZ or COPC file, whole or not at all; returns what LAS could not hold."""
    lazrs = _import_lazrs(path)
    is_copc = path.name.lower().endswith(".copc.laz")
    with tempfile.TemporaryDirectory(prefix="deburr-") as folder:
        plain = Path(folder, "cloud.las")
        losses = _write_modern(plain, cloud) if is_copc else _write_plain(plain, cloud)
        pack = _copc.pack if is_copc else _laz_codec.pack
        try:
            with whole_file(path) as part, plain.open("rb") as file, part.open("x+b") as packed:
                pack(file, packed)
        except lazrs.LazrsError as error:
            raise DeburrIOError(f"{path}: {error}") from error
    return losses


def from_laspy(las: Any) -> PointCloud:
    """A cloud of a laspy.LasData, with every dimension and record."""
    with tempfile.TemporaryDirectory(prefix="deburr-") as folder:
        plain = Path(folder, "cloud.las")
        _without_octree(las).write(plain, do_compress=False)
        return _read_plain(plain)


def _without_octree(las: Any) -> Any:
    """The same without the records of COPC, which laspy reads but does not write."""
    header = las.header
    if not any(v.user_id == "copc" for v in [*header.vlrs, *(header.evlrs or [])]):
        return las
    header = copy.deepcopy(header)
    for some in (header.vlrs, header.evlrs or []):
        some[:] = [vlr for vlr in some if vlr.user_id != "copc"]
    return type(las)(header, las.points)


def of_result(result: Result) -> Any:
    """A laspy.LasData of a result, as it would be written."""
    import laspy

    from .files import fit_to

    with tempfile.TemporaryDirectory(prefix="deburr-") as folder:
        plain = Path(folder, "cloud.las")
        _write_plain(plain, fit_to(result, "las", True))
        return laspy.read(plain)


def _read_plain(path: Path) -> PointCloud:
    from .files import from_core

    cloud = from_core(_core.read(path, "las")[0])
    # The octree of COPC is one of packed points; it would be wrong for any other file.
    cloud.layout.blocks = [b for b in cloud.layout.blocks if not _is_copc(b.name)]
    return cloud


def _write_plain(path: Path, cloud: PointCloud) -> list[str]:
    from .files import to_core

    return list(_core.write(path, to_core(cloud), "las"))


def _write_modern(path: Path, cloud: PointCloud) -> list[str]:
    """LAS of a kind that can become COPC."""
    losses = _write_plain(path, cloud)
    with path.open("rb") as file:
        head = _laz_codec.Head.read(file)
    if not _las_modern.is_modern(head):
        cloud, more = _las_modern.modernise(cloud, head)
        more += _write_plain(path, cloud)
        losses += [loss for loss in more if loss not in losses]
    return losses


def _is_copc(block: str) -> bool:
    words = block.split()
    return len(words) > 2 and words[0] == "LAS" and words[-2] == "copc"


def _import_lazrs(path: Path) -> Any:
    try:
        import lazrs
    except ImportError as error:
        raise ImportError(f"{path}: LAZ needs lazrs: pip install 'deburr[las]'") from error
    return lazrs
