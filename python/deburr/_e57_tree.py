# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Headers of E57 files as plain values, which can be kept, pickled and made into nodes again."""

from __future__ import annotations

import base64
from typing import Any

Plain = list[Any]


def to_plain(node: Any) -> Plain | None:
    """What a node and all below it say; None for points, which are no part of a header."""
    from pye57 import libe57

    kind = node.type()
    types = libe57.NodeType
    if kind == types.E57_STRING:
        return ["string", libe57.StringNode(node).value()]
    if kind == types.E57_FLOAT:
        number = libe57.FloatNode(node)
        single = number.precision() == libe57.FloatPrecision.E57_SINGLE
        return ["float", number.value(), single, number.minimum(), number.maximum()]
    if kind == types.E57_INTEGER:
        number = libe57.IntegerNode(node)
        return ["integer", number.value(), number.minimum(), number.maximum()]
    if kind == types.E57_SCALED_INTEGER:
        number = libe57.ScaledIntegerNode(node)
        limits = [number.minimum(), number.maximum()]
        return ["scaled", number.rawValue(), *limits, number.scale(), number.offset()]
    if kind == types.E57_BLOB:
        blob = libe57.BlobNode(node)
        data = bytearray(blob.byteCount())
        blob.read(data, 0, len(data))
        return ["blob", base64.b64encode(data).decode()]
    if kind == types.E57_STRUCTURE:
        return ["structure", children(libe57.StructureNode(node))]
    if kind == types.E57_VECTOR:
        vector = libe57.VectorNode(node)
        items = [to_plain(vector.get(i)) for i in range(vector.childCount())]
        return ["vector", vector.allowHeteroChildren(), [item for item in items if item]]
    return None


def children(structure: Any, without: tuple[str, ...] = ()) -> dict[str, Plain]:
    """The children of a structure by name."""
    found = {}
    for i in range(structure.childCount()):
        child = structure.get(i)
        name = child.elementName()
        plain = None if name in without else to_plain(child)
        if plain is not None:
            found[name] = plain
    return found


def add(parent: Any, name: str | None, plain: Plain, image_file: Any) -> None:
    """Makes a node of plain values and hangs it below another; without a name at its end."""
    from pye57 import libe57

    kind, *values = plain
    if kind == "structure":
        node = libe57.StructureNode(image_file)
    elif kind == "vector":
        node = libe57.VectorNode(image_file, values[0])
    elif kind == "blob":
        data = base64.b64decode(values[0])
        node = libe57.BlobNode(image_file, len(data))
    else:
        node = _number_or_text(image_file, kind, values)
    if name is None:
        parent.append(node)
    else:
        parent.set(name, node)
    # Nodes are filled where they hang: a blob cannot be written before.
    if kind == "structure":
        for child, below in values[0].items():
            add(node, child, below, image_file)
    elif kind == "vector":
        for below in values[1]:
            add(node, None, below, image_file)
    elif kind == "blob":
        node.write(bytearray(data), 0, len(data))


def _number_or_text(image_file: Any, kind: str, values: Plain) -> Any:
    from pye57 import libe57

    if kind == "string":
        return libe57.StringNode(image_file, values[0])
    if kind == "float":
        value, single, least, most = values
        precision = libe57.FloatPrecision
        chosen = precision.E57_SINGLE if single else precision.E57_DOUBLE
        return libe57.FloatNode(image_file, value, chosen, least, most)
    if kind == "integer":
        return libe57.IntegerNode(image_file, *values)
    raw, least, most, scale, offset = values
    return libe57.ScaledIntegerNode(image_file, raw, least, most, scale, offset)


def text(value: str) -> Plain:
    """A string."""
    return ["string", value]


def real(value: float) -> Plain:
    """A double without limits."""
    most = 1.7976931348623157e308
    return ["float", float(value), False, -most, most]
