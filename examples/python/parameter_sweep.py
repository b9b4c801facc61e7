# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Find the options that suit a kind of scan, as scikit-learn does: fit, score, compare.

    python parameter_sweep.py

`Denoiser` has the methods of a scikit-learn transformer, so GridSearchCV takes it too.
"""

from __future__ import annotations

import itertools
from typing import Any

import deburr


class Denoiser:
    """deburr.denoise() with its options as parameters of an estimator."""

    def __init__(self, **options: Any) -> None:
        self.options = options

    def get_params(self, deep: bool = True) -> dict[str, Any]:  # noqa: ARG002
        """The options."""
        return dict(self.options)

    def set_params(self, **options: Any) -> Denoiser:
        """Changes some options."""
        self.options.update(options)
        return self

    def fit(self, points: Any, truth: Any = None) -> Denoiser:  # noqa: ARG002
        """Nothing is learned: every cloud tells its own noise."""
        return self

    def transform(self, points: Any) -> Any:
        """The clean points."""
        return deburr.denoise(points, **self.options).as_given()

    def score(self, points: Any, truth: Any) -> float:
        """Minus the mean distance to the truth: more is better."""
        return -deburr.compare(self.transform(points), truth).error.mean


def main() -> None:
    scan = deburr.synth("part", points=3000, noise=0.004)
    grid: dict[str, list[Any]] = {"strength": [2, 3, 4], "outliers": ["label", "keep"]}
    scores = {}
    for values in itertools.product(*grid.values()):
        options = dict(zip(grid, values, strict=True))
        scores[values] = Denoiser(**options).score(scan.cloud, scan.truth)
        print(", ".join(f"{name}={value}" for name, value in options.items()), end=": ")
        print(f"mean distance {-scores[values]:.4f}")
    print("best:", *max(scores, key=lambda values: scores[values]))


if __name__ == "__main__":
    main()
