# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""What comes in becomes the arrays that the library takes; what cannot is refused by its name."""

from __future__ import annotations

import operator
import os
from typing import Any, SupportsFloat, SupportsIndex

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
Points = NDArray[np.float64] | NDArray[np.float32]
Bytes = NDArray[np.uint8]
Mask = NDArray[np.bool_]


def any_vectors(name: str, value: ArrayLike) -> Points:
    """An (N, 3) array of float32 or float64; the same memory wherever the library can read it."""
    if isinstance(value, (str, bytes, os.PathLike)):
        raise TypeError(f"{name} must be an array, got {value!r}: deburr.read() reads files")
    array: NDArray[Any] = np.asarray(value)
    if array.dtype.kind not in "fiub":
        given = f"{type(value).__name__}" if array.ndim == 0 else f"an array of {array.dtype}"
        raise TypeError(f"{name} must hold numbers, got {given}")
    if array.size == 0 and array.ndim <= 2:
        array = array.reshape(0, 3)
    if array.ndim != 2 or array.shape[1] != 3:
        hint = ", is it transposed?" if array.ndim == 2 and array.shape[0] == 3 else ""
        raise ValueError(f"{name} must have shape (N, 3), got {array.shape}{hint}")
    readable = (
        # Neither holds for arrays of the other byte order, and for fields of packed records.
        array.dtype in (np.float32, np.float64) and array.flags.aligned
    )
    if readable:
        return array
    single = array.dtype.kind == "f" and array.itemsize == 4
    return np.ascontiguousarray(array, dtype=np.float32 if single else np.float64)


def vectors(name: str, value: ArrayLike) -> Floats:
    """An (N, 3) array of float64 without gaps; the same memory where it is one already."""
    return np.ascontiguousarray(any_vectors(name, value), dtype=np.float64)


def values(name: str, value: ArrayLike, dtype: Any) -> NDArray[Any]:
    """A (N,) array of a type, which has to hold the values exactly."""
    array: NDArray[Any] = np.asarray(value)
    if array.ndim != 1:
        raise ValueError(f"{name} must have shape (N,), got {array.shape}")
    result = np.ascontiguousarray(array, dtype=dtype)
    if array.dtype.kind not in "iub" or not np.array_equal(result, array):
        raise ValueError(f"{name} must hold integers that fit into {np.dtype(dtype)}")
    return result


def whole(name: str, value: SupportsIndex) -> int:
    """An int of anything that is an integer."""
    try:
        return operator.index(value)
    except TypeError:
        raise TypeError(f"{name} must be an integer, got {value!r}") from None


def real(name: str, value: SupportsFloat) -> float:
    """A float of anything that is a real number."""
    try:
        if isinstance(value, (str, bytes)):
            raise TypeError
        return float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be a number, got {value!r}") from None


def option(default: Any, name: str, value: Any) -> Any:
    """A value of the type of its default."""
    if isinstance(default, str):
        if not isinstance(value, str):
            raise TypeError(f"{name} must be a word, got {value!r}")
        return value
    return whole(name, value) if isinstance(default, int) else real(name, value)
