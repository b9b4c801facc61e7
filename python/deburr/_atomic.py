# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Files that appear whole or not at all, as those that the C++ side writes."""

from __future__ import annotations

import secrets
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ._errors import DeburrIOError


@contextmanager
def whole_file(path: Path) -> Iterator[Path]:
    """A place beside the target to write to, which replaces it unless something is raised."""
    target = path.resolve()
    part = target.parent / f".deburr-{secrets.token_hex(8)}.tmp"
    try:
        yield part
        if target.exists():
            part.chmod(target.stat().st_mode)
        part.replace(target)
    except OSError as error:
        if isinstance(error, DeburrIOError):
            raise
        raise DeburrIOError(f"{path}: {error.strerror or error}") from error
    finally:
        part.unlink(missing_ok=True)
