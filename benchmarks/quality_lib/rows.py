# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""What a suite yields: figures of one case and one method, and the bars that they have to meet."""
import dataclasses
import math


@dataclasses.dataclass
class Row:
    suite: str
    case: str
    method: str
    figures: dict  # name -> number, or None where deburr could not tell
    bars: dict = dataclasses.field(default_factory=dict)  # name -> (">=" or "<=", limit)
    seconds: float = 0
    note: str = ""
    plot: dict = dataclasses.field(default_factory=dict)  # where in the plots

    def misses(self):
        """The bars that are not met, in words. A figure that nobody could tell is not met."""
        told = []
        for name, (sense, limit) in self.bars.items():
            value = self.figures.get(name)
            met = value is not None and (value <= limit if sense == "<=" else value >= limit)
            if not met:
                told.append(f"{name} {text(value)} not {sense} {limit:g}")
        return told

    def verdict(self):
        if self.misses():
            return "MISS: " + "; ".join(self.misses())
        return "pass" if self.bars else self.note and "not measured" or "-"


def text(value):
    if value is None:
        return "-"
    if isinstance(value, str):
        return value
    if value == int(value) and abs(value) < 1e9:
        return str(int(value))
    return f"{value:.4g}" if 1e-3 <= abs(value) < 1e4 else f"{value:.2e}"


def line(row):
    """One line for people who wait."""
    told = ", ".join(f"{name} {text(value)}" for name, value in row.figures.items())
    return (f"{row.suite:8} {row.case:28} {row.method:12} {row.seconds:7.2f} s  "
            f"{row.note or told}  [{row.verdict()}]")


def markdown(columns, lines):
    table = ["| " + " | ".join(columns) + " |", "|" + "---|" * len(columns)]
    return "\n".join(table + ["| " + " | ".join(map(text, cells)) + " |" for cells in lines]) + "\n"


def table(rows):
    """A Markdown table of rows: every figure a column."""
    names = list(dict.fromkeys(name for row in rows for name in row.figures))
    lines = [[row.case, row.method, *(row.figures.get(name) for name in names),
              round(row.seconds, 2), row.verdict() + (f" ({row.note})" if row.note else "")]
             for row in rows]
    return markdown(["case", "method", *names, "seconds", "bars"], lines)


def case_table(rows):
    """The cases suite, a line per case: mean errors in % of the diagonal, and their ratios."""
    methods = list(dict.fromkeys(row.method for row in rows))
    columns = ["case", "points", "noisy", "best peer"]
    for method in methods:
        columns += [method, f"{method} / noisy", f"{method} / peer", f"{method} s"]
    lines = []
    for case in dict.fromkeys(row.case for row in rows):
        of = {row.method: row for row in rows if row.case == case}
        any_row = next(iter(of.values())).figures
        cells = [case, any_row["points"], any_row["noisy"], any_row.get("peer")]
        for method in methods:
            row = of[method]
            cells += [row.figures.get(k) for k in ("error", "ratio", "peer_ratio")]
            cells.append(round(row.seconds, 2))
        lines.append(cells)
    cells = ["geometric mean", "", "", ""]
    for method in methods:
        mine = [row for row in rows if row.method == method]
        cells += ["", *(geometric_mean(row.figures.get(k) for row in mine)
                        for k in ("ratio", "peer_ratio")), ""]
    return markdown(columns, lines + [cells])


def geometric_mean(values):
    """Of the values that are there and positive; None without any."""
    logs = [math.log(value) for value in values if value is not None and value > 0]
    return math.exp(sum(logs) / len(logs)) if logs else None
