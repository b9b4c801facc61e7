# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""What is raised besides ValueError; the messages are those of the C++ library."""


class DeburrIOError(OSError):
    """A file that cannot be read or written; the message names it and the line or byte."""


class DataError(ValueError):
    """Well-formed data on which the request has no answer, such as normals to be kept of none."""


class Cancelled(RuntimeError):  # noqa: N818
    """A computation that was stopped by other means than an exception."""


for _error in (DeburrIOError, DataError, Cancelled):
    _error.__module__ = "deburr"
