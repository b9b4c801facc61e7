# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Between LAZ and LAS: lazrs does the points, everything else is copied byte by byte.

Source: ASPRS, LAS Specification 1.4 R15; the record "laszip encoded" is that of LASzip.
"""

from __future__ import annotations

import shutil
import struct
from dataclasses import dataclass
from typing import Any, BinaryIO

_RECORD = struct.Struct("<H16sHH32s")
_LASZIP = (b"laszip encoded", 22204)
_PACKED = 0xC0
_PIECE = 1 << 24


@dataclass
class Head:
    """What stands before the points: the header and the records, some of its numbers apart."""

    header: bytearray
    records: list[bytes]
    #: Between the records and the points.
    padding: bytes

    @classmethod
    def read(cls, file: BinaryIO) -> Head:
        """Reads it; struct.error or ValueError where the file is no LAS."""
        start = file.read(227)
        if start[:4] != b"LASF":
            raise ValueError("no LAS file, which begins with LASF")
        size, points_at, count = struct.unpack_from("<HII", start, 94)
        header = bytearray(start + file.read(max(0, size - 227)))
        records = []
        at = size
        for _ in range(count):
            head = file.read(_RECORD.size)
            length = _RECORD.unpack(head)[3]
            at += _RECORD.size + length
            records.append(head + file.read(length))
        if at > points_at or len(header) < size:
            raise ValueError(f"byte {at}: the records reach into the points")
        return cls(header, records, file.read(points_at - at))

    def take_laszip(self) -> bytes:
        """Takes out the record that tells how points are packed."""
        for record in self.records:
            _, user, number, _, _ = _RECORD.unpack_from(record)
            if (user.rstrip(b"\0"), number) == _LASZIP:
                self.records.remove(record)
                return record[_RECORD.size :]
        raise ValueError("no record tells how the points are packed")

    def add_laszip(self, data: bytes) -> None:
        """Puts such a record behind the others."""
        user, number = _LASZIP
        self.records.append(_RECORD.pack(0, user, number, len(data), b"deburr") + data)

    @property
    def point_format(self) -> int:
        return self.header[104] & ~_PACKED

    def set_packed(self, packed: bool) -> None:
        self.header[104] = self.point_format | (0x80 if packed else 0)

    @property
    def point_size(self) -> int:
        return int(struct.unpack_from("<H", self.header, 105)[0])

    @property
    def point_count(self) -> int:
        (count,) = struct.unpack_from("<I", self.header, 107)
        if self.header[25] >= 4 and len(self.header) >= 255:
            (count,) = struct.unpack_from("<Q", self.header, 247)
        return int(count)

    def _tails(self) -> dict[int, int]:
        """Where the header has the places of what stands behind the points, and these."""
        fields = [227] if self.header[25] >= 3 else []
        if self.header[25] >= 4 and any(self.header[243:247]):
            fields.append(235)
        known = {at: struct.unpack_from("<Q", self.header, at)[0] for at in fields}
        return {at: place for at, place in known.items() if place > 0}

    @property
    def tail_at(self) -> int | None:
        """Where what stands behind the points begins."""
        return min(self._tails().values(), default=None)

    def move_tail(self, by: int) -> None:
        """Tells that what stands behind the points has moved."""
        for at, place in self._tails().items():
            struct.pack_into("<Q", self.header, at, place + by)

    def to_bytes(self) -> bytes:
        """Header, records and padding, with the numbers that follow from them."""
        body = b"".join(self.records) + self.padding
        points_at = len(self.header) + len(body)
        struct.pack_into("<II", self.header, 96, points_at, len(self.records))
        return bytes(self.header) + body


def unpack(packed: BinaryIO, plain: BinaryIO) -> None:
    """LAZ to LAS."""
    import lazrs

    head = Head.read(packed)
    decoder: Any = lazrs.ParLasZipDecompressor(packed, head.take_laszip())
    head.set_packed(False)
    tail_at = head.tail_at
    start = head.to_bytes()
    end = len(start) + head.point_count * head.point_size
    if tail_at is not None:
        head.move_tail(end - tail_at)
        start = head.to_bytes()
    plain.write(start)
    for size in _pieces(head):
        piece = bytearray(size)
        decoder.decompress_many(piece)
        plain.write(piece)
    if tail_at is not None:
        packed.seek(tail_at)
        shutil.copyfileobj(packed, plain)


def pack(plain: BinaryIO, packed: BinaryIO) -> None:
    """LAS to LAZ."""
    import lazrs

    head = Head.read(plain)
    # What a point has beyond its format are extra bytes, which lazrs has to know.
    extra = head.point_size - format_size(head.point_format)
    scheme = lazrs.LazVlr.new_for_compression(head.point_format, extra)
    head.add_laszip(scheme.record_data())
    head.set_packed(True)
    packed.write(head.to_bytes())
    encoder: Any = lazrs.ParLasZipCompressor(packed, scheme)
    for size in _pieces(head):
        encoder.compress_many(plain.read(size))
    encoder.done()
    tail_at = head.tail_at
    if tail_at is None:
        return
    packed.seek(0, 2)
    head.move_tail(packed.tell() - tail_at)
    plain.seek(tail_at)
    shutil.copyfileobj(plain, packed)
    packed.seek(0)
    packed.write(head.to_bytes())


def format_size(point_format: int) -> int:
    sizes = (20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67)
    if point_format >= len(sizes):
        raise ValueError(f"point format {point_format} is none of LAS")
    return sizes[point_format]


def _pieces(head: Head) -> list[int]:
    """Bytes of the points to do at once."""
    if head.point_size == 0:
        raise ValueError("points of no length")
    most = max(1, _PIECE // head.point_size)
    whole, rest = divmod(head.point_count, most)
    counts = [most] * whole + ([rest] if rest else [])
    return [count * head.point_size for count in counts]
