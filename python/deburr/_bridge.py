# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Between the classes of the package and the dicts that the C++ side makes and takes."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .layout import Element, Field, FieldValues, FileLayout, HeaderBlock, Lists

_PLAIN = ("encoding", "separator", "header", "mark", "count_line", "resolution")
_LISTS = ("comments", "obj_info")


def field_values(name: str, value: ArrayLike | Lists) -> FieldValues:
    """What was given as a field, in a form that files can hold."""
    if isinstance(value, Lists):
        return value
    array: NDArray[Any] = np.asarray(value)
    if array.ndim == 2:
        return Lists.of_rows(array)
    if array.ndim != 1:
        raise ValueError(f"field '{name}' must have shape (N,) or (N, K), got {array.shape}")
    kind, size = array.dtype.kind, array.itemsize
    if kind in "US":
        return array.astype(str).astype(object)
    if kind == "O":
        if not all(isinstance(item, str) for item in array):
            raise TypeError(f"field '{name}' must hold numbers or str")
        return array
    if kind == "b":
        return array.astype(np.uint8)
    if kind not in "iuf" or size > 8:
        raise TypeError(f"field '{name}' must hold numbers or str, got {array.dtype}")
    if kind == "f" and size == 2:
        return array.astype(np.float32)
    return array if array.dtype.isnative else array.astype(array.dtype.newbyteorder("="))


def fields_from_core(attributes: list[tuple[str, Any, Any, str]]) -> dict[str, FieldValues]:
    """Fields by their names, in order."""
    fields: dict[str, FieldValues] = {}
    for name, values, offsets, length_type in attributes:
        array = np.array(values, dtype=object) if isinstance(values, list) else values
        fields[name] = array if offsets is None else Lists(array, offsets, length_type)
    return fields


def fields_to_core(fields: dict[str, FieldValues]) -> list[tuple[str, Any, Any, str]]:
    """The reverse of fields_from_core()."""
    attributes: list[tuple[str, Any, Any, str]] = []
    for name, value in fields.items():
        held = field_values(name, value)
        array = held.values if isinstance(held, Lists) else held
        items = array.tolist() if array.dtype.kind == "O" else np.ascontiguousarray(array)
        offsets = held.offsets if isinstance(held, Lists) else None
        length_type = held.length_type if isinstance(held, Lists) else "uint8"
        attributes.append((name, items, offsets, length_type))
    return attributes


def layout_from_core(parts: dict[str, Any]) -> FileLayout:
    """A layout of what the C++ side tells."""
    return FileLayout(
        **{name: parts[name] for name in (*_PLAIN, *_LISTS)},
        fields=[Field(*entry) for entry in parts["fields"]],
        elements=[
            Element(name, size, fields_from_core(attributes), before)
            for name, size, attributes, before in parts["elements"]
        ],
        blocks=[HeaderBlock(*entry) for entry in parts["blocks"]],
    )


def layout_to_core(layout: FileLayout) -> dict[str, Any]:
    """The reverse of layout_from_core()."""
    parts: dict[str, Any] = {name: getattr(layout, name) for name in _PLAIN}
    for name in (*_LISTS, "fields", "blocks"):
        parts[name] = [*getattr(layout, name)]
    parts["elements"] = [
        (element.name, element.size, fields_to_core(element.fields), element.before_points)
        for element in layout.elements
    ]
    return parts
